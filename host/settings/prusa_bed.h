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

// The bed if it is a rectangle along the axes, at any position, however its outline is written;
// nullopt for other shapes.
[[nodiscard]] std::optional<BedRectangle> rectangular_bed(std::string_view text);

// The largest rectangle within the outline that has its centre and its proportions, up to half a
// hundredth of a mm. Nullopt if the outline is not convex or can't be read.
[[nodiscard]] std::optional<BedRectangle> rectangle_within_bed(std::string_view text);

}  // namespace host
