// Settings in archives: what PrusaSlicer, SuperSlicer, OrcaSlicer and Bambu Studio put into their
// 3MF files, and the parts of a .curaprofile.
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"  // Result

namespace host {

// Whether a file with these first bytes is an archive.
[[nodiscard]] bool is_archive(std::string_view start);

// The settings' text, as it would be in a file of its own. An error if there are none.
[[nodiscard]] core::Result<std::string> settings_in_archive(const std::string& path);

}  // namespace host
