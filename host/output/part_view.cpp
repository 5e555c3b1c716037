#include "host/output/part_view.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/check.h"
#include "core/facet_sides.h"  // FacetSides

namespace host {
namespace {

constexpr std::int64_t kSide = PartView::kCells;

// A cell's side at first, in units: the buffer shows 1.6 mm.
constexpr double kFirstCell = 16;

// Of the light that comes from above and, less, from the front and the left; a unit vector.
constexpr double kLightX = -0.2545, kLightY = -0.5937, kLightZ = 0.7634;
// What the sides away from it get.
constexpr double kAmbient = 0.2;

// The colours of the darkest and of the brightest facet.
constexpr std::array<double, 3> kDark = {0x5a, 0x33, 0x10}, kBright = {0xff, 0xdc, 0x9c};

constexpr double kShadeMax = 255;

// A facet that is wider than this, in cells, but is seen along its surface, shows nothing that its
// neighbours don't.
constexpr double kNarrow = 1.5;

// A shorter piece of a row, in cells, lies in one cell if it covers a centre.
constexpr double kShortest = 0.5;

// Of a pixel's side, in cells.
constexpr double kLeastPixel = 1.0 / 1'024;

// One of a facet's edges between two rows, or columns: where it is, and how near.
struct Edge {
  double from_row, from, from_near, step, step_near;

  Edge(const std::array<double, 3>& a, const std::array<double, 3>& b)
      : from_row(a[0]), from(a[1]), from_near(a[2]), step(0), step_near(0) {
    if (b[0] <= a[0]) return;
    step = (b[1] - a[1]) / (b[0] - a[0]);
    step_near = (b[2] - a[2]) / (b[0] - a[0]);
  }
  [[nodiscard]] double at(double row) const { return from + step * (row - from_row); }
  [[nodiscard]] double near_at(double row) const {
    return from_near + step_near * (row - from_row);
  }
};

// Without a call of the library's. REQUIRES: |value| < 2^63.
std::int64_t floor_of(double value) {
  const auto towards_zero = static_cast<std::int64_t>(value);
  return value < static_cast<double>(towards_zero) ? towards_zero - 1 : towards_zero;
}

std::int64_t within(std::int64_t cell) { return std::clamp(cell, std::int64_t{0}, kSide - 1); }

// The cells of one row of the buffer that a pixel covers, with their shares.
struct Span {
  std::int64_t first, last;
  double from, to;

  Span(double start, double end)
      : first(std::max(std::int64_t{0}, floor_of(start))),
        last(std::min(kSide - 1, floor_of(end))),
        from(start),
        to(end) {}
  [[nodiscard]] double share(std::int64_t cell) const {
    const auto start = static_cast<double>(cell);
    return std::max(0.0, std::min(to, start + 1) - std::max(from, start));
  }
};

}  // namespace

// What a facet shows, computed when it is asked for: most facets are hidden.
class PartView::Face {
 public:
  explicit Face(const core::Triangle& triangle) : triangle_(triangle) {}

  [[nodiscard]] bool has_area() {
    look();
    return area_squared_ > 0;
  }

  // 1 … 255. REQUIRES: it has an area
  [[nodiscard]] std::uint8_t shade() {
    if (shade_ != 0) return shade_;
    look();
    const core::Direction& n = normal_;
    const double side = -n.x - n.y + n.z < 0 ? -1 : 1;  // the side that is seen
    const double lit = side * (n.x * kLightX + n.y * kLightY + n.z * kLightZ);
    const double bright = kAmbient + (1 - kAmbient) * std::max(0.0, lit / std::sqrt(area_squared_));
    shade_ = static_cast<std::uint8_t>(std::clamp(kShadeMax * bright + 0.5, 1.0, kShadeMax));
    return shade_;
  }

  // Whether its least height is less than this, in units.
  [[nodiscard]] bool narrower_than(double width) {
    look();
    const core::FacetSides sides(triangle_);
    const core::Direction &u = sides.to_second, &v = sides.to_third;
    const core::Direction third{v.x - u.x, v.y - u.y, v.z - u.z};
    const double longest_squared =
        std::max({u.length_squared(), v.length_squared(), third.length_squared()});
    return area_squared_ < width * width * longest_squared;
  }

 private:
  void look() {
    if (area_squared_ >= 0) return;
    normal_ = core::FacetSides(triangle_).normal();
    area_squared_ = normal_.length_squared();
  }

  const core::Triangle& triangle_;
  core::Direction normal_;
  double area_squared_ = -1;  // of its doubled area, in units; -1: not looked at
  std::uint8_t shade_ = 0;
};

PartView::PartView()
    : near_(std::make_unique_for_overwrite<float[]>(kSide * kSide)),
      shade_(std::make_unique<std::uint8_t[]>(kSide * kSide)),
      cell_(kFirstCell) {}

PartView::Corner PartView::seen(const core::Vertex& vertex) {
  // Isometric: all three axes are shortened alike.
  constexpr double kAcross = 0.70710678118654752, kBack = 0.40824829046386302;
  constexpr double kUp = 0.81649658092772603, kNear = 0.57735026918962576;
  const auto x = static_cast<double>(vertex.x), y = static_cast<double>(vertex.y);
  const auto z = static_cast<double>(vertex.z);
  return {(x - y) * kAcross, (x + y) * kBack + z * kUp, (z - x - y) * kNear};
}

PartView::Cells PartView::cells_of(const Extent& extent) const {
  const double per_unit = 1 / cell_;  // exact: a power of two
  return {floor_of(extent.left * per_unit), floor_of(extent.right * per_unit),
          floor_of(extent.low * per_unit), floor_of(extent.high * per_unit)};
}

void PartView::add(const core::Triangle& triangle) {
  Face face(triangle);
  std::array<Corner, 3> corners = {seen(triangle.corners[0]), seen(triangle.corners[1]),
                                   seen(triangle.corners[2])};
  const auto& [a, b, c] = corners;
  Extent extent{std::min({a.across, b.across, c.across}), std::max({a.across, b.across, c.across}),
                std::min({a.up, b.up, c.up}), std::max({a.up, b.up, c.up})};
  if (!whole_.holds(extent)) {
    if (!face.has_area()) return;
    make_room(extent);
  }
  const double per_unit = 1 / cell_;
  const auto first_left = static_cast<double>(first_left_);
  const auto first_low = static_cast<double>(first_low_);
  extent = {extent.left * per_unit - first_left, extent.right * per_unit - first_left,
            extent.low * per_unit - first_low, extent.high * per_unit - first_low};
  const bool by_columns = extent.right - extent.left > extent.high - extent.low;
  const double start = by_columns ? extent.left : extent.low;
  const double end = by_columns ? extent.right : extent.high;
  const std::int64_t first = floor_of(start + 0.5), last = floor_of(end - 0.5);
  // At most as large as a cell.
  if (first > last && !face.narrower_than(kNarrow * cell_)) return;
  // Row, place in it, nearness.
  std::array<Place, 3> places;
  for (std::size_t i = 0; i < 3; ++i) {
    const double across = corners[i].across * per_unit - first_left;
    const double up = corners[i].up * per_unit - first_low;
    places[i] =
        by_columns ? Place{across, up, corners[i].near} : Place{up, across, corners[i].near};
  }
  if (places[1][0] < places[0][0]) std::swap(places[0], places[1]);
  if (places[2][0] < places[1][0]) std::swap(places[1], places[2]);
  if (places[1][0] < places[0][0]) std::swap(places[0], places[1]);
  if (first > last) {
    const auto middle = [&](std::size_t i) {
      return (places[0][i] + places[1][i] + places[2][i]) / 3;
    };
    if (!face.has_area()) return;
    return mark(cell_at(floor_of(middle(0)), floor_of(middle(1)), by_columns), middle(2), face);
  }
  draw(places, first, last, by_columns, face);
}

void PartView::make_room(const Extent& extent) {
  const bool first = empty();
  whole_ = first ? extent
                 : Extent{std::min(whole_.left, extent.left), std::max(whole_.right, extent.right),
                          std::min(whole_.low, extent.low), std::max(whole_.high, extent.high)};
  while (true) {
    Cells all = cells_of(extent);
    if (!first) {
      all = {std::min(all.left, used_.left), std::max(all.right, used_.right),
             std::min(all.low, used_.low), std::max(all.high, used_.high)};
    }
    const std::int64_t width = all.right - all.left + 1, height = all.high - all.low + 1;
    if (width > kSide || height > kSide) {
      double_cells();
      continue;
    }
    if (all.left < first_left_ || all.right >= first_left_ + kSide || all.low < first_low_ ||
        all.high >= first_low_ + kSide) {
      // In the middle, so that there is room on each side.
      move_to(all.left - (kSide - width) / 2, all.low - (kSide - height) / 2);
    }
    used_ = all;
    return;
  }
}

// Goes through the new cells in order; none is written before the old ones there have been read.
void PartView::double_cells() {
  cell_ *= 2;
  const std::int64_t odd_left = first_left_ & 1, odd_low = first_low_ & 1;
  const std::int64_t last_row = used_.high - first_low_, last_column = used_.right - first_left_;
  for (std::int64_t row = (used_.low - first_low_) / 2; row <= last_row; ++row) {
    const std::int64_t below = 2 * row - odd_low;
    const std::int64_t low = std::max<std::int64_t>(below, 0), high = std::min(below + 2, kSide);
    for (std::int64_t column = (used_.left - first_left_) / 2; column <= last_column; ++column) {
      const std::int64_t beside = 2 * column - odd_left;
      const std::int64_t left = std::max<std::int64_t>(beside, 0);
      const std::int64_t right = std::min(beside + 2, kSide);
      float near = 0;
      std::uint8_t shade = 0;
      for (std::int64_t r = low; r < high; ++r) {
        for (auto old = static_cast<std::size_t>(r * kSide + left);
             old < static_cast<std::size_t>(r * kSide + right); ++old) {
          if (shade_[old] == 0 || (shade != 0 && near_[old] <= near)) continue;
          near = near_[old];
          shade = shade_[old];
        }
      }
      const auto cell = static_cast<std::size_t>(row * kSide + column);
      shade_[cell] = shade;
      if (shade != 0) near_[cell] = near;
    }
  }
  first_left_ >>= 1;
  first_low_ >>= 1;
  used_ = {used_.left >> 1, used_.right >> 1, used_.low >> 1, used_.high >> 1};
}

// REQUIRES: what was drawn fits into the buffer there.
void PartView::move_to(std::int64_t left, std::int64_t low) {
  const std::int64_t right_by = first_left_ - left, up_by = first_low_ - low;
  first_left_ = left;
  first_low_ = low;
  if (std::abs(right_by) >= kSide || std::abs(up_by) >= kSide) {
    std::fill_n(shade_.get(), kSide * kSide, std::uint8_t{0});
    return;
  }
  const auto kept = static_cast<std::size_t>(kSide - std::abs(right_by));
  const std::int64_t from = std::max<std::int64_t>(0, -right_by);
  const std::int64_t to = std::max<std::int64_t>(0, right_by);
  // A row is written after the one that lies there has moved on.
  for (std::int64_t i = 0; i < kSide; ++i) {
    const std::int64_t row = up_by > 0 ? kSide - 1 - i : i;
    std::uint8_t* shades = shade_.get() + row * kSide;
    const std::int64_t source = row - up_by;
    if (source < 0 || source >= kSide) {
      std::fill_n(shades, kSide, std::uint8_t{0});
      continue;
    }
    std::memmove(shades + to, shade_.get() + source * kSide + from, kept);
    std::memmove(near_.get() + row * kSide + to, near_.get() + source * kSide + from,
                 kept * sizeof(float));
    std::fill_n(shades + (right_by > 0 ? 0 : static_cast<std::int64_t>(kept)), kSide - kept,
                std::uint8_t{0});
  }
}

void PartView::show(std::size_t cell, float near, Face& face) {
  if (!face.has_area()) return;
  shade_[cell] = face.shade();
  near_[cell] = near;
}

std::size_t PartView::cell_at(std::int64_t row, std::int64_t place, bool by_columns) {
  return static_cast<std::size_t>(by_columns ? within(place) * kSide + within(row)
                                             : within(row) * kSide + within(place));
}

// Row by row; column by column if the facet is wider than high.
void PartView::draw(const std::array<Place, 3>& points, std::int64_t first, std::int64_t last,
                    bool by_columns, Face& face) {
  const std::size_t cell_step = by_columns ? kSide : 1;
  const Edge whole(points[0], points[2]), lower(points[0], points[1]), upper(points[1], points[2]);
  for (std::int64_t row = first; row <= last; ++row) {
    const double centre = static_cast<double>(row) + 0.5;
    const Edge& other = centre < points[1][0] ? lower : upper;
    double from = whole.at(centre), to = other.at(centre);
    double near = whole.near_at(centre), near_to = other.near_at(centre);
    if (from > to) {
      std::swap(from, to);
      std::swap(near, near_to);
    }
    const std::int64_t begin = within(floor_of(from + 0.5)), end = within(floor_of(to - 0.5));
    if (begin > end || to - from < kShortest) {
      if (begin > end && !face.narrower_than(kNarrow * cell_)) continue;
      mark(cell_at(row, floor_of((from + to) / 2), by_columns), (near + near_to) / 2, face);
      continue;
    }
    const double step = (near_to - near) / (to - from);
    near += (static_cast<double>(begin) + 0.5 - from) * step;
    std::size_t cell = cell_at(row, begin, by_columns);
    for (std::int64_t place = begin; place <= end; ++place) {
      mark(cell, near, face);
      near += step;
      cell += cell_step;
    }
  }
}

RgbaPicture PartView::picture(int width, int height) const {
  RIND_CHECK(width >= 1 && height >= 1);
  RgbaPicture picture{width, height, {}};
  picture.bytes.resize(std::size_t{4} * static_cast<std::size_t>(width) *
                       static_cast<std::size_t>(height));
  if (empty()) return picture;
  // Cells a pixel, and the cells of the picture's lower left corner.
  const double margin = std::min(width, height) / 32.0;
  const double cells =
      std::max({(whole_.right - whole_.left) / (width - 2 * margin) / cell_,
                (whole_.high - whole_.low) / (height - 2 * margin) / cell_, kLeastPixel});
  const double start_across = (whole_.left + whole_.right) / (2 * cell_) -
                              static_cast<double>(first_left_) - cells * width / 2;
  const double start_up = (whole_.low + whole_.high) / (2 * cell_) -
                          static_cast<double>(first_low_) - cells * height / 2;
  std::uint8_t* pixel = picture.bytes.data();
  for (int y = height - 1; y >= 0; --y) {
    const Span rows(start_up + y * cells, start_up + (y + 1) * cells);
    for (int x = 0; x < width; ++x, pixel += 4) {
      const Span columns(start_across + x * cells, start_across + (x + 1) * cells);
      double filled = 0, bright = 0;
      for (std::int64_t row = rows.first; row <= rows.last; ++row) {
        for (std::int64_t column = columns.first; column <= columns.last; ++column) {
          const std::uint8_t shade = shade_[static_cast<std::size_t>(row * kSide + column)];
          if (shade == 0) continue;
          const double share = rows.share(row) * columns.share(column);
          filled += share;
          bright += share * shade;
        }
      }
      if (filled <= 0) continue;
      bright /= filled * kShadeMax;
      for (std::size_t i = 0; i < 3; ++i) {
        pixel[i] =
            static_cast<std::uint8_t>(std::lround(kDark[i] + bright * (kBright[i] - kDark[i])));
      }
      pixel[3] =
          static_cast<std::uint8_t>(std::lround(255 * std::min(1.0, filled / (cells * cells))));
    }
  }
  return picture;
}

}  // namespace host
