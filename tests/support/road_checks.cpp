#include "tests/support/road_checks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tests/support/region_checks.h"  // distance_to_segment, signed_distance

namespace test {

namespace {

// Every piece with the widths at its two ends, in units.
template <typename Visit>
void each_piece(const core::Road& road, const Visit& visit) {
  const std::size_t count = road.points.size();
  for (std::size_t i = 0; i < (road.closed ? count : count - 1); ++i) {
    const std::size_t j = (i + 1) % count;
    visit(core::Segment{road.points[i], road.points[j]},
          static_cast<double>(core::width_at(road, i).units()),
          static_cast<double>(core::width_at(road, j).units()));
  }
}

double piece_mm(const core::Segment& piece) {
  return std::hypot(piece.to.x - piece.from.x, piece.to.y - piece.from.y) / core::kUnitsPerMm;
}

bool covered(core::Point point, const std::vector<core::Road>& roads) {
  return std::any_of(roads.begin(), roads.end(), [&](const core::Road& road) {
    bool near = false;
    each_piece(road, [&](const core::Segment& piece, double a, double b) {
      const double dx = static_cast<double>(piece.to.x) - piece.from.x;
      const double dy = static_cast<double>(piece.to.y) - piece.from.y;
      const double along = (static_cast<double>(point.x) - piece.from.x) * dx +
                           (static_cast<double>(point.y) - piece.from.y) * dy;
      const double t = std::clamp(along / (dx * dx + dy * dy), 0.0, 1.0);
      near = near || 2 * distance_to_segment(point, piece) <= a + t * (b - a);
    });
    return near;
  });
}

// Every fifth of a millimetre.
template <typename Visit>
void each_sample(const core::Road& road, const Visit& visit) {
  each_piece(road, [&](const core::Segment& piece, double a, double b) {
    const int parts = 1 + static_cast<int>(piece_mm(piece) / 0.2);
    for (int i = 0; i <= parts; ++i) {
      const double t = static_cast<double>(i) / parts;
      visit(piece.from.x + t * (piece.to.x - piece.from.x),
            piece.from.y + t * (piece.to.y - piece.from.y), a + t * (b - a));
    }
  });
}

}  // namespace

double covered_share(const core::Region& region, const std::vector<core::Road>& roads, int points,
                     Random& random) {
  const core::Box box = region.box();
  int inside = 0, hit = 0;
  while (inside < points) {
    const core::Point p{random.integer(box.min.x, box.max.x), random.integer(box.min.y, box.max.y)};
    if (!region.contains(p)) continue;
    ++inside;
    hit += covered(p, roads) ? 1 : 0;
  }
  return static_cast<double>(hit) / points;
}

double sticks_out_mm(const core::Region& region, const std::vector<core::Road>& roads) {
  double worst = 0;
  for (const core::Road& road : roads) {
    each_sample(road, [&](double x, double y, double width) {
      worst = std::max(worst, (width / 2 - signed_distance(region, x, y)) / core::kUnitsPerMm);
    });
  }
  return worst;
}

double least_depth_mm(const core::Region& region, const std::vector<core::Road>& roads) {
  double least = 1e9;
  for (const core::Road& road : roads) {
    each_sample(road, [&](double x, double y, double) {
      least = std::min(least, signed_distance(region, x, y) / core::kUnitsPerMm);
    });
  }
  return least;
}

double laid_mm2(const std::vector<core::Road>& roads, core::Length height) {
  double sum = 0;
  for (const core::Road& road : roads) {
    each_piece(road, [&](const core::Segment& piece, double a, double b) {
      const auto area = [&](double width) {
        return core::bead_area_mm2(core::Length::from_units(std::llround(width)), height);
      };
      sum += piece_mm(piece) * (area(a) + area(b)) / 2 / height.mm();
    });
  }
  return sum;
}

double total_length_mm(const std::vector<core::Road>& roads) {
  double sum = 0;
  for (const core::Road& road : roads) {
    each_piece(road, [&](const core::Segment& piece, double, double) { sum += piece_mm(piece); });
  }
  return sum;
}

}  // namespace test
