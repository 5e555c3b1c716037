// The package around a 3MF's models: which one is the root, and how parts are opened.
#pragma once

#include <string>

#include "core/result.h"               // Result
#include "host/formats/xml_scanner.h"  // XmlScanner
#include "host/formats/zip_archive.h"  // ZipArchive

namespace host {

// A part's name as the archive has it.
[[nodiscard]] std::string without_slash(const std::string& path);

// The model that the package's relationships name; else the only one.
[[nodiscard]] core::Result<std::string> root_model(const ZipArchive& archive);

// REQUIRES: the archive outlives the scanner.
[[nodiscard]] core::Result<XmlScanner> scanner_of(const ZipArchive& archive,
                                                  const std::string& part);

}  // namespace host
