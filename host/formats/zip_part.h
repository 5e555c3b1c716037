// The one part in a zip archive that is no 3MF package: what sites and mail programs make of a
// file.
//
// Entries that are named like meshes come first (.stl .obj .amf .3mf .sif), then those like layer
// files, then any others whose content is a mesh. Where the first of these is several, none is
// chosen: they are named in the error. Folders and what systems add (__MACOSX, .DS_Store) don't
// count.
#pragma once

#include "core/result.h"               // Result
#include "host/files/input_file.h"     // InputFile
#include "host/formats/zip_archive.h"  // ZipArchive

namespace host {

// Entries with other names that are unpacked to see what they are.
inline constexpr std::size_t kZipLooksMax = 16;

// A 3MF package, which is a zip archive by itself.
[[nodiscard]] bool is_threemf(const ZipArchive& archive);

// COSTS: unpacks it into a temporary file.
[[nodiscard]] core::Result<InputFile> only_part(const ZipArchive& archive);

}  // namespace host
