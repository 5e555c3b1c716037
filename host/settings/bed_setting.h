// The bed's outline as text, "0x0,250x0,250x210,0x210", as PrusaSlicer has it, and how it goes
// together with bed_x, bed_y and the bed's origin.
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"                // Result
#include "host/settings/setting_row.h"  // BedCorners

namespace host {

// Corners in the printer's coordinates. Empty for "rectangle" and for no text.
//
// An error unless the outline is a simple polygon of 3 to kBedCornersMax corners that is at least
// 1 mm wide and deep.
[[nodiscard]] core::Result<BedCorners> read_bed_shape(std::string_view text);

[[nodiscard]] std::string write_bed_shape(const BedCorners& corners);

// Sets the outline and its bounding box. A rectangle along the axes, in any spelling, is kept as a
// box alone. REQUIRES: read_bed_shape() made the corners.
void set_bed_shape(PrintSettings& settings, const BedCorners& corners);

// After `key` was set to another value than in `before`: bed_x and bed_y make the bed a rectangle,
// the origin moves its outline.
void follow_bed(std::string_view key, const PrintSettings& before, PrintSettings& settings);

}  // namespace host
