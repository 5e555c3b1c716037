// The table of settings, in the order in which help and files list them; settings_table.cpp has the
// functions that use it.
#pragma once

#include <algorithm>
#include <array>

#include "host/settings/machine_rows.h"  // kMachineRows
#include "host/settings/part_rows.h"     // kPartRows
#include "host/settings/setting_row.h"   // Setting

namespace host {

inline constexpr auto kSettings = [] {
  std::array<Setting, kPartRows.size() + kMachineRows.size()> all;
  std::copy(kMachineRows.begin(), kMachineRows.end(),
            std::copy(kPartRows.begin(), kPartRows.end(), all.begin()));
  return all;
}();

}  // namespace host
