// The bed of a PrusaSlicer profile, "0x0,250x0,250x210,0x210": its outline's corners in mm.
#pragma once

#include <optional>
#include <string_view>

namespace host {

struct BedRectangle {
  double left = 0;
  double front = 0;
  double width = 0;
  double depth = 0;
};

// A rectangle along the axes, anywhere, however its outline is written. Nothing for any other
// shape.
[[nodiscard]] std::optional<BedRectangle> rectangular_bed(std::string_view text);

// The largest rectangle of the outline's proportions that lies in its middle and within it. Nothing
// where the outline is not convex, or can't be read. Half a hundredth of a mm is given away.
[[nodiscard]] std::optional<BedRectangle> rectangle_within_bed(std::string_view text);

}  // namespace host
