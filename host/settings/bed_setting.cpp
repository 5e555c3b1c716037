#include "host/settings/bed_setting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "host/settings/settings_text.h"  // read_number, write_number
#include "host/system/text.h"             // trimmed

namespace host {
namespace {

using core::Error;
using core::Length;
using core::Point;
using core::Result;

Error bad(std::string message) { return {core::ErrorCode::kBadSetting, std::move(message)}; }

Result<Point> read_corner(std::string_view text) {
  const std::size_t between = text.find('x');
  if (between == std::string_view::npos) {
    return bad(fmt::format("\"{}\" is no corner as 250x210", trimmed(text)));
  }
  const Result<double> x = read_number(text.substr(0, between), "mm");
  const Result<double> y = read_number(text.substr(between + 1), "mm");
  if (!x.ok()) return x.error();
  if (!y.ok()) return y.error();
  if (std::abs(x.value()) > kBedMaxMm || std::abs(y.value()) > kBedMaxMm) {
    return bad(fmt::format("corner {} is farther than {} mm from the origin", trimmed(text),
                           write_number(kBedMaxMm)));
  }
  return Point{static_cast<std::int32_t>(Length::from_mm(x.value()).units()),
               static_cast<std::int32_t>(Length::from_mm(y.value()).units())};
}

bool on_edge(Point point, Point from, Point to) {
  return core::cross(from, to, point) == 0 && point.x >= std::min(from.x, to.x) &&
         point.x <= std::max(from.x, to.x) && point.y >= std::min(from.y, to.y) &&
         point.y <= std::max(from.y, to.y);
}

bool touch(Point a, Point b, Point c, Point d) {
  if (on_edge(a, c, d) || on_edge(b, c, d) || on_edge(c, a, b) || on_edge(d, a, b)) return true;
  const auto sign = [](std::int64_t area) { return (area > 0) - (area < 0); };
  return sign(core::cross(a, b, c)) * sign(core::cross(a, b, d)) < 0 &&
         sign(core::cross(c, d, a)) * sign(core::cross(c, d, b)) < 0;
}

// Without corners that repeat the one before, or that lie on a straight edge.
BedCorners without_idle(BedCorners corners) {
  for (std::size_t i = 0; corners.size() > 2 && i < corners.size();) {
    const Point before = corners[(i + corners.size() - 1) % corners.size()];
    const Point after = corners[(i + 1) % corners.size()];
    const bool idle = corners[i] == before || on_edge(corners[i], before, after);
    if (idle) {
      corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    } else {
      ++i;
    }
  }
  return corners;
}

// No two edges meet but neighbours in their corner. COSTS: O(n²).
bool is_simple(const BedCorners& corners) {
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point a = corners[i], b = corners[(i + 1) % count];
    for (std::size_t j = i + 1; j < count; ++j) {
      const Point c = corners[j], d = corners[(j + 1) % count];
      if (b == c ? on_edge(d, a, b) : d == a ? on_edge(c, a, b) : touch(a, b, c, d)) return false;
    }
  }
  return true;
}

bool is_rectangle(const BedCorners& corners) {
  if (corners.size() != 4) return false;
  const core::Box box = core::box_of(corners);
  return std::all_of(corners.begin(), corners.end(), [&box](Point corner) {
    return (corner.x == box.min.x || corner.x == box.max.x) &&
           (corner.y == box.min.y || corner.y == box.max.y);
  });
}

}  // namespace

Result<BedCorners> read_bed_shape(std::string_view text) {
  BedCorners corners;
  std::string_view rest = trimmed(text);
  if (rest == "rectangle") return corners;
  while (!rest.empty()) {
    const std::size_t comma = rest.find(',');
    const Result<Point> corner = read_corner(rest.substr(0, comma));
    if (!corner.ok()) return corner.error();
    if (corners.size() == core::kBedCornersMax) {
      return bad(fmt::format("more than {} corners", core::kBedCornersMax));
    }
    corners.push_back(corner.value());
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
    if (rest.empty()) return bad("a corner is missing behind the last comma");
  }
  if (corners.empty()) return corners;
  corners = without_idle(std::move(corners));
  const core::Box box = core::box_of(corners);
  const Length least = Length::from_mm(1);
  const Length width = Length::from_units(std::int64_t{box.max.x} - box.min.x);
  const Length depth = Length::from_units(std::int64_t{box.max.y} - box.min.y);
  if (corners.size() < 3) return bad("an outline has three corners or more");
  if (width < least || depth < least) {
    return bad(
        fmt::format("the outline is {:g} mm wide and {:g} mm deep: bed_x and bed_y are at "
                    "least 1 mm",
                    width.mm(), depth.mm()));
  }
  if (std::max(width, depth) > Length::from_mm(kBedMaxMm)) {
    return bad(fmt::format("the outline is larger than {} mm", write_number(kBedMaxMm)));
  }
  if (!is_simple(corners)) return bad("the outline crosses or touches itself");
  return corners;
}

std::string write_bed_shape(const BedCorners& corners) {
  if (corners.empty()) return "rectangle";
  std::string text;
  for (const Point corner : corners) {
    text += (text.empty() ? "" : ",") + write_number(Length::from_units(corner.x).mm()) + "x" +
            write_number(Length::from_units(corner.y).mm());
  }
  return text;
}

void set_bed_shape(PrintSettings& settings, const BedCorners& corners) {
  settings.bed_shape.clear();
  if (corners.empty()) return;
  const core::Box box = core::box_of(corners);
  settings.bed_origin_x = Length::from_units(box.min.x);
  settings.bed_origin_y = Length::from_units(box.min.y);
  settings.bed_x = Length::from_units(std::int64_t{box.max.x} - box.min.x);
  settings.bed_y = Length::from_units(std::int64_t{box.max.y} - box.min.y);
  if (!is_rectangle(corners)) settings.bed_shape = corners;
}

void follow_bed(std::string_view key, const PrintSettings& before, PrintSettings& settings) {
  if (settings.bed_shape.empty()) return;
  const bool size = settings.bed_x != before.bed_x || settings.bed_y != before.bed_y;
  if ((key == "bed_x" || key == "bed_y") && size) settings.bed_shape.clear();
  if (key != "bed_origin_x" && key != "bed_origin_y") return;
  const Length x = settings.bed_origin_x - before.bed_origin_x;
  const Length y = settings.bed_origin_y - before.bed_origin_y;
  for (Point& corner : settings.bed_shape) {
    corner = {static_cast<std::int32_t>(corner.x + x.units()),
              static_cast<std::int32_t>(corner.y + y.units())};
  }
}

}  // namespace host
