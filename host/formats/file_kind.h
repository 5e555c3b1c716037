// Recognises the kind of a file by its content, never by its name: .slc is the ending of at least
// three formats, .ssl and .sif of two.
//
// Most kinds have typical first bytes. OBJ has none: a file is OBJ if a line starts with a word of
// OBJ, after comments of any length and lines with other words.
#pragma once

#include "core/result.h"            // Result
#include "host/files/input_file.h"  // InputFile

namespace host {

enum class FileKind { kStl, kZip, kAmf, kObj, kSif, kLsif, kCli, kSlc, kSliceV0, kSvg };

// Reads only as far as needed. Errors: an empty file; a known kind that can't be read, by name.
[[nodiscard]] core::Result<FileKind> kind_of(InputFile& file);

}  // namespace host
