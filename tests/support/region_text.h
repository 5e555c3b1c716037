// Regions written as text, for tests.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/geometry.h"        // Ring
#include "core/regions/region.h"  // Region

namespace test {

// Rings in mm: "0:0 10:0 10:10, 3:3 3:6 6:6". REQUIRES: well-formed text.
std::vector<core::Ring> rings_from_text(std::string_view text);

// REQUIRES: the rings are clean; it is checked.
core::Region region_from_text(std::string_view text);

// Region to text, for messages.
std::string to_text(const core::Region& region);

core::Ring rectangle(double x0_mm, double y0_mm, double x1_mm, double y1_mm);

// From its lower left corner; millimetres.
core::Region rectangle_region(double x, double y, double width, double height);

}  // namespace test
