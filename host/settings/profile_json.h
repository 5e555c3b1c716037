// Profiles of OrcaSlicer and Bambu Studio: JSON files of one printer ("machine"), print ("process")
// or filament each, that inherit from other files by name; and the settings in their 3MF files,
// where all are in one.
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"                  // Result
#include "host/settings/profile_lines.h"  // ForeignProfile, ProfileChoice

namespace host {

// Folders that are looked through for a file that another one names.
inline constexpr int kProfileFoldersMax = 256;

// A file is sought by name beside the one that names it, in the folders beside that, and in their
// folders. With a printer go its default print and filament, or those of the choice, which may also
// be paths. `name`: the file's path.
//
// An error for a file that another one inherits from and that is not there.
[[nodiscard]] core::Result<ForeignProfile> read_json_profile(std::string_view text,
                                                             const std::string& name,
                                                             const ProfileChoice& choice);

}  // namespace host
