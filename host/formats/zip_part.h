// Finds the one part in an ordinary zip archive, as web sites and mail programs make them.
//
// Entries with a mesh's ending come first (.stl .obj .amf .3mf .sif), then those with a layer
// file's ending, then others whose content is a mesh. If the first of these groups that is not
// empty has several entries, the error names them. Folders and files that systems add (__MACOSX,
// .DS_Store) don't count.
#pragma once

#include "core/result.h"               // Result
#include "host/files/input_file.h"     // InputFile
#include "host/formats/zip_archive.h"  // ZipArchive

namespace host {

// Entries with other endings that are unpacked to recognise their kind.
inline constexpr std::size_t kZipLooksMax = 16;

// True for a 3MF package, which is a zip archive, too.
[[nodiscard]] bool is_threemf(const ZipArchive& archive);

// The part, unpacked into a temporary file.
[[nodiscard]] core::Result<InputFile> only_part(const ZipArchive& archive);

}  // namespace host
