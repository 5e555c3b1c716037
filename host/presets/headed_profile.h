// A settings file that begins with facts which are no settings, in a section of their own:
//
//     [printer]              `section`; lines of "key = value", '#' starts a comment
//     preset = ender3
//     [rind]
//     bed_x = 230            settings, as in every profile (settings/settings_file.h)
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "core/result.h"  // Result

namespace host {

struct HeadedProfile {
  std::map<std::string, std::string, std::less<>> head;
  std::string settings;  // the rest; each of its lines has the number that it has in the file

  // Empty if it is not there.
  [[nodiscard]] std::string_view value(std::string_view key) const;
};

// `name` is for messages, which begin with "name:line: ". A key outside `keys`, and a key that
// comes twice, are errors.
[[nodiscard]] core::Result<HeadedProfile> read_headed_profile(
    std::string_view text, const std::string& name, std::string_view section,
    std::span<const std::string_view> keys);

}  // namespace host
