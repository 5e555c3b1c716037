#include "core/roads/row_rests.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/booleans/boolean.h"  // clean, intersect
#include "core/units.h"             // kUnitsPerMm

namespace core {
namespace {

// Windows reach over their strip by this, so that neighbours are one.
constexpr double kOverStrip = 2;

// A piece of a contour within a strip: x along the rows.
struct Piece {
  double x0, y0, x1, y1;
};

// ∫ min(max(x, a), b) dx from 0 on, but for a constant.
double clamped_integral(double x, double a, double b) {
  if (x <= a) return a * x;
  if (x <= b) return (a * a + x * x) / 2;
  return (a * a - b * b) / 2 + b * x;
}

// ∫ min(max(x, a), b) dy along the piece.
double clamped_area(const Piece& piece, double a, double b) {
  const double dx = piece.x1 - piece.x0, dy = piece.y1 - piece.y0;
  if (std::abs(dx) < 1) return std::clamp((piece.x0 + piece.x1) / 2, a, b) * dy;
  return (clamped_integral(piece.x1, a, b) - clamped_integral(piece.x0, a, b)) / dx * dy;
}

class Strips {
 public:
  Strips(const Region& region, const RowStrips& grid) : grid_(grid) {
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    std::vector<std::vector<std::array<double, 2>>> rings;
    for (const Ring& ring : region.rings()) {
      std::vector<std::array<double, 2>>& turned = rings.emplace_back();
      for (const Point point : ring) {
        turned.push_back(grid.turn.to_rows(point));
        low = std::min(low, turned.back()[1]);
        high = std::max(high, turned.back()[1]);
      }
    }
    if (rings.empty()) return;
    first_ = strip_of(low);
    strips_.resize(static_cast<std::size_t>(strip_of(high) - first_ + 1));
    for (const auto& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[(i + 1) % ring.size()]);
    }
  }

  // The windows' outlines in the plane.
  [[nodiscard]] std::vector<Ring> windows(const std::vector<RowStretch>& stretches,
                                          double least) const {
    std::vector<Ring> outlines;
    std::size_t next = 0;
    for (std::size_t i = 0; i < strips_.size(); ++i) {
      const std::int64_t number = first_ + static_cast<std::int64_t>(i);
      while (next < stretches.size() && stretches[next].row < number) ++next;
      const std::size_t begin = next;
      while (next < stretches.size() && stretches[next].row == number) ++next;
      add_windows(number,
                  {stretches.begin() + static_cast<std::ptrdiff_t>(begin),
                   stretches.begin() + static_cast<std::ptrdiff_t>(next)},
                  least, outlines);
    }
    return outlines;
  }

 private:
  [[nodiscard]] std::int64_t strip_of(double y) const {
    return static_cast<std::int64_t>(std::floor(y / grid_.distance));
  }

  void add(std::array<double, 2> a, std::array<double, 2> b) {
    const std::int64_t from = strip_of(a[1]), to = strip_of(b[1]);
    const std::int64_t step = to >= from ? 1 : -1;
    std::array<double, 2> at = a;
    for (std::int64_t strip = from; true; strip += step) {
      std::array<double, 2> next = b;
      if (strip != to) {
        next[1] = static_cast<double>(step > 0 ? strip + 1 : strip) * grid_.distance;
        next[0] = a[0] + (b[0] - a[0]) * (next[1] - a[1]) / (b[1] - a[1]);
      }
      strips_[static_cast<std::size_t>(strip - first_)].push_back({at[0], at[1], next[0], next[1]});
      if (strip == to) return;
      at = next;
    }
  }

  void add_windows(std::int64_t number, std::vector<RowStretch> rows, double least,
                   std::vector<Ring>& outlines) const {
    const std::vector<Piece>& pieces = strips_[static_cast<std::size_t>(number - first_)];
    if (pieces.empty()) return;
    std::sort(rows.begin(), rows.end(),
              [](const RowStretch& a, const RowStretch& b) { return a.from < b.from; });
    double low = pieces.front().x0, high = low;
    for (const Piece& piece : pieces) {
      low = std::min({low, piece.x0, piece.x1});
      high = std::max({high, piece.x0, piece.x1});
    }
    double from = low;
    bool covered = false;
    for (const RowStretch& row : rows) {
      const double to = row.from - grid_.reach;
      if (!covered && !row.from_covered) add_window(number, from, to, least, outlines);
      from = row.to + grid_.reach;
      covered = row.to_covered;
    }
    if (!covered) add_window(number, from, high, least, outlines);
  }

  void add_window(std::int64_t number, double from, double to, double least,
                  std::vector<Ring>& outlines) const {
    if (to <= from || (to - from) * grid_.distance < least) return;
    double area = 0;
    for (const Piece& piece : strips_[static_cast<std::size_t>(number - first_)]) {
      area += clamped_area(piece, from, to);
    }
    if (area < least) return;
    const double bottom = static_cast<double>(number) * grid_.distance - kOverStrip;
    const double top = static_cast<double>(number + 1) * grid_.distance + kOverStrip;
    outlines.push_back({grid_.turn.to_plane(from, bottom), grid_.turn.to_plane(to, bottom),
                        grid_.turn.to_plane(to, top), grid_.turn.to_plane(from, top)});
  }

  const RowStrips& grid_;
  std::int64_t first_ = 0;
  std::vector<std::vector<Piece>> strips_;
};

}  // namespace

Region row_rests(const Region& region, const std::vector<RowStretch>& stretches,
                 const RowStrips& grid, double least_mm2) {
  const std::vector<Ring> outlines =
      Strips(region, grid).windows(stretches, least_mm2 * kUnitsPerMm * kUnitsPerMm);
  if (outlines.empty()) return {};
  return intersect(region, clean(outlines, FillRule::kNonZero));
}

}  // namespace core
