// What became of each setting of another program's profile: taken, changes the print, not
// supported, of no meaning here.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "host/settings/settings_file.h"  // LoadedSettings, ProfileRow

namespace host {

inline constexpr std::array kProfileGroups = {ProfileGroup::kTaken, ProfileGroup::kChanges,
                                              ProfileGroup::kNotSupported,
                                              ProfileGroup::kNoMeaning};

// A row for each setting, in the order of the groups.
[[nodiscard]] std::vector<ProfileRow> report_of(const LoadedSettings& loaded);

// "taken", "changes the print", …
[[nodiscard]] std::string_view group_name(ProfileGroup group);

// How many there are of each group, in one line.
[[nodiscard]] std::string counts_of(const std::vector<ProfileRow>& rows);

// As comments of a settings file, a heading before each group.
[[nodiscard]] std::string text_of(const std::vector<ProfileRow>& rows);

}  // namespace host
