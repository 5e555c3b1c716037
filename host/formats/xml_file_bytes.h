// A file as the source of an XmlScanner.
#pragma once

#include "host/files/input_file.h"     // InputFile
#include "host/formats/xml_scanner.h"  // XmlScanner

namespace host {

[[nodiscard]] XmlScanner::ByteSource xml_bytes_of(InputFile file);

}  // namespace host
