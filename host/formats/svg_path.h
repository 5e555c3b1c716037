// Reads the numbers of an SVG's shapes as contours.
#pragma once

#include <string>
#include <string_view>

#include "host/formats/contour_gatherer.h"  // ContourGatherer

namespace host {

// Converts y to the model's: `height_mm - y` if the picture's y axis points down.
struct SvgAxis {
  bool mirrored = false;
  double height_mm = 0;
};

// points="x,y x,y …", one contour. Returns why it can't be read; empty if it can.
[[nodiscard]] std::string add_svg_points(std::string_view points, const SvgAxis& axis, Turn turn,
                                         ContourGatherer& into);

// d="M x y x y … z M …": straight lines only, absolute or relative.
[[nodiscard]] std::string add_svg_path(std::string_view data, const SvgAxis& axis,
                                       ContourGatherer& into);

}  // namespace host
