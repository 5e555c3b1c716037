// PrusaSlicer's values that are a share of another setting's, "80%".
#pragma once

#include <string>
#include <string_view>

#include "host/settings/prusa_left_out.h"  // ProfileValues

namespace host {

// The key's value, in the unit of the setting that it is a share of, if that is known; otherwise as
// in the profile. Shares of the thing itself (fill_density) stay.
[[nodiscard]] std::string absolute_value(const ProfileValues& profile, std::string_view key);

}  // namespace host
