#include "host/settings/prusa_bed.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/result.h"
#include "host/settings/settings_text.h"  // read_number

namespace host {
namespace {

struct Corner {
  double x = 0;
  double y = 0;
};

// Empty if the text has another form.
std::vector<Corner> corners_of(std::string_view text) {
  std::vector<Corner> corners;
  while (!text.empty()) {
    const std::string_view point = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), point.size() + 1));
    const std::size_t cross = point.find('x');
    if (cross == std::string_view::npos) return {};
    const core::Result<double> x = read_number(point.substr(0, cross), "mm");
    const core::Result<double> y = read_number(point.substr(cross + 1), "mm");
    if (!x.ok() || !y.ok()) return {};
    corners.push_back({x.value(), y.value()});
  }
  return corners;
}

double doubled_area(Corner a, Corner b, Corner c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

double area_of(const std::vector<Corner>& corners) {
  double doubled = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    doubled += doubled_area(corners.front(), corners[i], corners[(i + 1) % corners.size()]);
  }
  return doubled / 2;
}

BedRectangle box_of(const std::vector<Corner>& corners) {
  Corner low = corners.front(), high = low;
  for (const Corner& at : corners) {
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
  }
  return {low.x, low.y, high.x - low.x, high.y - low.y};
}

// True if the point is left of every edge. REQUIRES: the outline is counter-clockwise.
bool within(const std::vector<Corner>& outline, Corner point) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (doubled_area(outline[i], outline[(i + 1) % outline.size()], point) < 0) return false;
  }
  return true;
}

}  // namespace

std::optional<BedRectangle> rectangular_bed(std::string_view text) {
  const std::vector<Corner> corners = corners_of(text);
  if (corners.size() < 4) return std::nullopt;
  // A shape that fills its bounding box is a rectangle.
  const BedRectangle box = box_of(corners);
  const double whole = box.width * box.depth;
  if (!(whole > 0) || std::abs(std::abs(area_of(corners)) / whole - 1) > 1e-6) return std::nullopt;
  return box;
}

std::optional<BedRectangle> rectangle_within_bed(std::string_view text) {
  constexpr double kGivenAway = 0.005;
  std::vector<Corner> outline = corners_of(text);
  if (outline.size() < 3) return std::nullopt;
  if (area_of(outline) < 0) std::reverse(outline.begin(), outline.end());
  const bool convex = std::all_of(outline.begin(), outline.end(),
                                  [&](const Corner& corner) { return within(outline, corner); });
  const BedRectangle box = box_of(outline);
  if (!convex || !(box.width * box.depth > 0)) return std::nullopt;
  const Corner middle{box.left + box.width / 2, box.front + box.depth / 2};
  const auto scaled = [&](double share) {
    return BedRectangle{middle.x - share * box.width / 2, middle.y - share * box.depth / 2,
                        share * box.width, share * box.depth};
  };
  const auto fits = [&](double share) {
    const BedRectangle all = scaled(share);
    const double right = all.left + all.width, back = all.front + all.depth;
    return within(outline, {all.left, all.front}) && within(outline, {right, all.front}) &&
           within(outline, {right, back}) && within(outline, {all.left, back});
  };
  if (!fits(0)) return std::nullopt;
  double inside = 0, outside = 1;
  for (int i = 0; i < 40; ++i) {
    const double share = (inside + outside) / 2;
    (fits(share) ? inside : outside) = share;
  }
  BedRectangle bed = scaled(inside);
  // To hundredths of a mm, inwards.
  const auto up = [](double mm) { return std::ceil((mm + kGivenAway) * 100) / 100; };
  const auto down = [](double mm) { return std::floor((mm - kGivenAway) * 100) / 100; };
  const double right = down(bed.left + bed.width), back = down(bed.front + bed.depth);
  bed.left = up(bed.left);
  bed.front = up(bed.front);
  bed.width = std::round((right - bed.left) * 100) / 100;
  bed.depth = std::round((back - bed.front) * 100) / 100;
  if (!(bed.width > 1 && bed.depth > 1)) return std::nullopt;
  return bed;
}

}  // namespace host
