// A file's bytes for an XmlScanner.
#pragma once

#include "host/formats/xml_scanner.h"  // XmlScanner
#include "host/part/input_file.h"      // InputFile

namespace host {

[[nodiscard]] XmlScanner::ByteSource xml_bytes_of(InputFile file);

}  // namespace host
