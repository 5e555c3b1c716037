// What kind of file it is, told by the content, never by the name: .slc is the name of three
// formats at least, .ssl and .sif of two.
//
// Most kinds are told by their first bytes. OBJ has no such: a file is one when the first word of a
// line is a word of OBJ's, behind comments of any length and lines of other words.
#pragma once

#include "core/result.h"            // Result
#include "host/files/input_file.h"  // InputFile

namespace host {

enum class FileKind { kStl, kZip, kAmf, kObj, kSif, kLsif, kCli, kSlc, kSliceV0, kSvg };

// Reads as much as tells the kind. Errors: an empty file, and kinds that are known and can't be
// read, by name.
[[nodiscard]] core::Result<FileKind> kind_of(InputFile& file);

}  // namespace host
