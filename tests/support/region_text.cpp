#include "tests/support/region_text.h"

#include <cstdlib>
#include <sstream>

#include "core/check.h"
#include "core/units.h"
#include "tests/support/region_checks.h"

namespace test {

using core::Length;
using core::Point;
using core::Ring;

namespace {

Point point_mm(double x, double y) {
  return {static_cast<std::int32_t>(Length::from_mm(x).units()),
          static_cast<std::int32_t>(Length::from_mm(y).units())};
}

}  // namespace

std::vector<Ring> rings_from_text(std::string_view text) {
  std::vector<Ring> rings;
  std::istringstream all{std::string(text)};
  for (std::string ring_text; std::getline(all, ring_text, ',');) {
    Ring ring;
    std::istringstream words(ring_text);
    double x = 0, y = 0;
    char colon = 0;
    while (words >> x >> colon >> y) {
      RIND_CHECK(colon == ':');
      ring.push_back(point_mm(x, y));
    }
    RIND_CHECK(words.eof());
    rings.push_back(std::move(ring));
  }
  return rings;
}

core::Region region_from_text(std::string_view text) {
  core::Region region = core::Region::from_clean_rings(rings_from_text(text));
  RIND_CHECK(is_clean(region));
  return region;
}

std::string to_text(const core::Region& region) {
  std::ostringstream text;
  text.precision(8);
  const char* ring_separator = "";
  for (const Ring& ring : region.rings()) {
    text << ring_separator;
    const char* separator = "";
    for (const Point p : ring) {
      text << separator << Length::from_units(p.x).mm() << ':' << Length::from_units(p.y).mm();
      separator = " ";
    }
    ring_separator = ", ";
  }
  return text.str();
}

Ring rectangle(double x0_mm, double y0_mm, double x1_mm, double y1_mm) {
  return {point_mm(x0_mm, y0_mm), point_mm(x1_mm, y0_mm), point_mm(x1_mm, y1_mm),
          point_mm(x0_mm, y1_mm)};
}

core::Region rectangle_region(double x, double y, double width, double height) {
  return core::Region::from_clean_rings({rectangle(x, y, x + width, y + height)});
}

}  // namespace test
