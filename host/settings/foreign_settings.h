// Takes the settings of another program's profile that mean the same here, and says what became of
// each line.
#pragma once

#include <string>

#include "core/result.h"                  // Status
#include "host/settings/profile_lines.h"  // ForeignProfile
#include "host/settings/settings_file.h"  // LoadedSettings

namespace host {

// Sets `loaded` from the profile. Values that have no counterpart are named there, and G-code keeps
// its placeholders. An error for a value that is wrong in the other program, too.
core::Status apply_foreign(ForeignProfile profile, const std::string& name, LoadedSettings& loaded);

}  // namespace host
