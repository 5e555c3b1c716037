#include "tests/support/road_checks.h"

#include <algorithm>
#include <cmath>

#include "tests/support/region_checks.h"  // distance_to_segment, signed_distance

namespace test {

namespace {

template <typename Visit>
void each_piece(const core::Road& road, const Visit& visit) {
  for (std::size_t i = 1; i < road.points.size(); ++i) {
    visit(core::Segment{road.points[i - 1], road.points[i]});
  }
  if (road.closed) visit(core::Segment{road.points.back(), road.points.front()});
}

double piece_mm(const core::Segment& piece) {
  return std::hypot(piece.to.x - piece.from.x, piece.to.y - piece.from.y) / core::kUnitsPerMm;
}

bool covered(core::Point point, const std::vector<core::Road>& roads) {
  return std::any_of(roads.begin(), roads.end(), [&](const core::Road& road) {
    bool near = false;
    each_piece(road, [&](const core::Segment& piece) {
      near =
          near || 2 * distance_to_segment(point, piece) <= static_cast<double>(road.width.units());
    });
    return near;
  });
}

// Every fifth of a millimetre.
template <typename Visit>
void each_sample(const core::Road& road, const Visit& visit) {
  each_piece(road, [&](const core::Segment& piece) {
    const int parts = 1 + static_cast<int>(piece_mm(piece) / 0.2);
    for (int i = 0; i <= parts; ++i) {
      const double t = static_cast<double>(i) / parts;
      visit(piece.from.x + t * (piece.to.x - piece.from.x),
            piece.from.y + t * (piece.to.y - piece.from.y));
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
    each_sample(road, [&](double x, double y) {
      const double depth = signed_distance(region, x, y) / core::kUnitsPerMm;
      worst = std::max(worst, road.width.mm() / 2 - depth);
    });
  }
  return worst;
}

double least_depth_mm(const core::Region& region, const std::vector<core::Road>& roads) {
  double least = 1e9;
  for (const core::Road& road : roads) {
    each_sample(road, [&](double x, double y) {
      least = std::min(least, signed_distance(region, x, y) / core::kUnitsPerMm);
    });
  }
  return least;
}

double laid_mm2(const std::vector<core::Road>& roads, core::Length height) {
  double sum = 0;
  for (const core::Road& road : roads) {
    sum += total_length_mm({road}) * core::bead_area_mm2(road.width, height) / height.mm();
  }
  return sum;
}

double total_length_mm(const std::vector<core::Road>& roads) {
  double sum = 0;
  for (const core::Road& road : roads) {
    each_piece(road, [&](const core::Segment& piece) { sum += piece_mm(piece); });
  }
  return sum;
}

}  // namespace test
