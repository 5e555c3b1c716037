// The roof fold's formula for all layers of a part, from the top down, computed again on cells:
//
//     loose'(n) = loose(n) ∩ (grow(loose'(n+1), step) ∪ seed(n))
//
// Nothing of the fold goes into a layer's cells but its seeds: errors of one layer that add up over
// those below are seen. Growth is brute force: every cell within the step of every cell at an edge.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/regions/point_location.h"
#include "core/regions/polyline.h"
#include "core/supports/roof_fold.h"
#include "tests/support/random_regions.h"

using namespace core;

namespace {

constexpr double kStep_mm = 1;
constexpr int kStepCells = 24;
constexpr double kCell_mm = kStep_mm / kStepCells;
constexpr int kSide = 76 * kStepCells;

// Cells as far apart as this grow by 24 cells at least, in all directions, by 24.19 at most (the
// width of the convex hull of cells in a circle of this radius). By 24 cells they grow by less.
const double kStepCellsMost = std::sqrt(585.0);

// Between a region's edge and the cells whose centres are in it.
constexpr double kEdge_mm = 2 * kCell_mm;

// Places farther away than this are not told apart.
constexpr double kFar_mm = 0.5;

// What rounding takes of a growth, beside kGrowthLoss.
constexpr double kRounding_mm = 4 / kUnitsPerMm;

struct Disc {
  double x_mm, y_mm, radius_mm;
};

struct Stack {
  std::string name;
  std::vector<std::vector<Disc>> insides;  // discs united, from the bed up
};

Region region_of_discs(const std::vector<Disc>& discs) {
  std::vector<Ring> rings;
  for (const Disc& disc : discs) {
    constexpr int kPoints = 360;
    Ring& ring = rings.emplace_back();
    for (int i = 0; i < kPoints; ++i) {
      const double angle = 2 * M_PI * i / kPoints;
      const double x_mm = disc.x_mm + disc.radius_mm * std::cos(angle);
      const double y_mm = disc.y_mm + disc.radius_mm * std::sin(angle);
      ring.push_back({static_cast<std::int32_t>(std::lround(x_mm * kUnitsPerMm)),
                      static_cast<std::int32_t>(std::lround(y_mm * kUnitsPerMm))});
    }
  }
  return clean(rings, FillRule::kNonZero);
}

std::vector<Stack> stacks() {
  constexpr int kLayers = 36;
  std::vector<Stack> all;
  Stack dome{"dome", {}}, leaning{"leaning dome", {}}, waist{"waist", {}};
  for (int n = 0; n < kLayers; ++n) {
    const double radius = std::sqrt(36.2 * 36.2 - (n + 0.8) * (n + 0.8));
    dome.insides.push_back({{38, 38, radius}});
    leaning.insides.push_back({{27 + 0.6 * n, 38 - 0.2 * n, radius * 0.7}});
    // Wide at the bottom, narrow halfway up, wide again, closed at the top.
    const double open = std::min(2.0 * std::abs(n - 18) + 7, 2.0 * (kLayers - n) + 3);
    waist.insides.push_back({{38, 38, std::min(open, 36.0)}});
  }
  all.push_back(std::move(dome));
  all.push_back(std::move(leaning));
  all.push_back(std::move(waist));
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    Stack random{"seed " + std::to_string(seed), {}};
    test::Random dice(seed);
    // Two lobes that wander together, so slowly that no roof begins beside the hollow: between two
    // hollows the fold keeps a wall, which the formula has not.
    Disc one{37, 38, 4}, other{39, 38, 4};
    const auto wander = [&](Disc& disc, double x_mm, double y_mm, double range_mm) {
      disc.x_mm = std::clamp(disc.x_mm + dice.between(-0.7, 0.7), x_mm - range_mm, x_mm + range_mm);
      disc.y_mm = std::clamp(disc.y_mm + dice.between(-0.7, 0.7), y_mm - range_mm, y_mm + range_mm);
      disc.radius_mm = std::clamp(disc.radius_mm + dice.between(-0.6, 1.8), 4.0, 28.0);
    };
    std::vector<std::vector<Disc>> downwards;
    for (int n = 0; n < kLayers; ++n) {
      downwards.push_back({one, other});
      wander(one, 38, 38, 5);
      wander(other, one.x_mm, one.y_mm, 2.5);
    }
    random.insides.assign(downwards.rbegin(), downwards.rend());
    all.push_back(std::move(random));
  }
  return all;
}

// High layers, so that a step is many cells.
Settings high_layers() {
  Settings settings;
  settings.layer_height = Length::from_mm(kStep_mm);  // at 45°
  settings.road_width = Length::from_mm(3);
  settings.loose_width_min = Length::from_mm(1);
  settings.loose_area_min_mm2 = 0.5;
  settings.bridge_max = Length::from_mm(12);
  settings.loose_roof = LooseRoof::kCone;
  return settings;
}

// From the bed up.
std::vector<InsideLayer> fold(const Stack& stack, const Settings& settings) {
  RoofFold fold(settings);
  std::vector<InsideLayer> found(stack.insides.size());
  for (std::size_t i = stack.insides.size(); i-- > 0;) {
    const auto index = static_cast<LayerIndex>(i);
    fold.push({index, settings.layer_height * index, settings.layer_height,
               std::make_shared<const Region>(region_of_discs(stack.insides[i]))});
    if (i == 0) fold.end();
    while (auto layer = fold.next()) found[static_cast<std::size_t>(layer->index)] = *layer;
  }
  for (const InsideLayer& layer : found) REQUIRE(layer.loose);
  return found;
}

class Cells {
 public:
  Cells() : set_(static_cast<std::size_t>(kSide) * kSide) {}

  [[nodiscard]] bool at(int x, int y) const { return set_[index(x, y)] != 0; }
  [[nodiscard]] int first_row() const { return first_row_; }
  [[nodiscard]] int last_row() const { return last_row_; }
  [[nodiscard]] bool at_edge(int x, int y) const {
    return at(x, y) && (!at(x - 1, y) || !at(x + 1, y) || !at(x, y - 1) || !at(x, y + 1));
  }

  // Nothing is set within two cells of the raster's own edge.
  void set_row(int y, int from, int to) {
    if (y < 2 || y > kSide - 3) return;
    for (int x = std::max(2, from); x <= std::min(kSide - 3, to); ++x) set_[index(x, y)] = 1;
    first_row_ = std::min(first_row_, y);
    last_row_ = std::max(last_row_, y);
  }
  void set_disc(double x, double y, double radius) {
    const int low = static_cast<int>(std::ceil(y - radius));
    for (int row = low; row <= y + radius; ++row) {
      const double half = std::sqrt(std::max(0.0, radius * radius - (row - y) * (row - y)));
      set_row(row, static_cast<int>(std::ceil(x - half)), static_cast<int>(std::floor(x + half)));
    }
  }
  void set_region(const Region& region) {
    if (region.empty()) return;
    const PointLocation location(region);
    const Box box = region.box();
    for (int y = cell_of(box.min.y); y <= cell_of(box.max.y); ++y) {
      for (int x = cell_of(box.min.x); x <= cell_of(box.max.x); ++x) {
        if (location.contains(centre(x, y))) set_row(y, x, x);
      }
    }
  }

  [[nodiscard]] Cells grown(double by_cells) const {
    Cells result = *this;
    for (int y = first_row_; y <= last_row_; ++y) {
      for (int x = 1; x < kSide - 1; ++x) {
        if (at_edge(x, y)) result.set_disc(x, y, by_cells);
      }
    }
    return result;
  }
  void keep(const Cells& other) {
    for (std::size_t i = 0; i < set_.size(); ++i) set_[i] &= other.set_[i];
  }

  // To the nearest cell's centre; kFar_mm at most.
  [[nodiscard]] double distance_mm(Point p) const {
    const double px = p.x / (kCell_mm * kUnitsPerMm) - 0.5;
    const double py = p.y / (kCell_mm * kUnitsPerMm) - 0.5;
    constexpr int kReach = static_cast<int>(kFar_mm / kCell_mm);
    const int x = cell_of(p.x), y = cell_of(p.y);
    double nearest_mm = at(x, y) ? 0 : kFar_mm;
    for (int v = y - kReach; v <= y + kReach && nearest_mm > 0; ++v) {
      for (int u = x - kReach; u <= x + kReach; ++u) {
        if (at(u, v)) nearest_mm = std::min(nearest_mm, std::hypot(u - px, v - py) * kCell_mm);
      }
    }
    return nearest_mm;
  }

  static Point centre(int x, int y) {
    return {static_cast<std::int32_t>(std::lround((x + 0.5) * kCell_mm * kUnitsPerMm)),
            static_cast<std::int32_t>(std::lround((y + 0.5) * kCell_mm * kUnitsPerMm))};
  }
  static int cell_of(std::int32_t units) {
    return static_cast<int>(std::floor(units / (kCell_mm * kUnitsPerMm)));
  }

 private:
  static std::size_t index(int x, int y) {
    return static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x);
  }
  std::vector<std::uint8_t> set_;
  int first_row_ = kSide, last_row_ = 0;  // nothing is set outside them
};

// One layer more, downwards.
Cells formula(const Cells& above, const std::vector<Disc>& inside, const Region& seed,
              double step_cells) {
  Cells given;
  for (const Disc& disc : inside) {
    given.set_disc(disc.x_mm / kCell_mm - 0.5, disc.y_mm / kCell_mm - 0.5,
                   disc.radius_mm / kCell_mm);
  }
  Cells cells = above.grown(step_cells);
  cells.set_region(seed);
  cells.keep(given);
  return cells;
}

double distance_mm_to(const Region& region, const PointLocation& location, Point p) {
  if (location.contains(p)) return 0;
  double nearest = INFINITY;
  for (const Ring& ring : region.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Segment side{ring[i], ring[(i + 1) % ring.size()]};
      nearest = std::min(nearest, distance_units(p, side) / kUnitsPerMm);
    }
  }
  return nearest;
}

// How far the region reaches out of the cells, looked at along its edges; kFar_mm at most.
double reach_mm(const Region& region, const Cells& cells) {
  double farthest = 0;
  for (const Ring& ring : region.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      const int parts = 1 + static_cast<int>(distance_mm(a, b) / 0.3);
      for (int k = 0; k < parts; ++k) {
        const double share = static_cast<double>(k) / parts;
        const Point p{static_cast<std::int32_t>(std::lerp(a.x, b.x, share)),
                      static_cast<std::int32_t>(std::lerp(a.y, b.y, share))};
        farthest = std::max(farthest, cells.distance_mm(p));
      }
    }
  }
  return farthest;
}

// How far cells lie outside the region, looked at in every fifth cell and along their edges.
double farthest_mm(const Cells& cells, const Region& region) {
  const PointLocation location(region);
  double farthest = 0;
  for (int y = cells.first_row(); y <= cells.last_row(); ++y) {
    for (int x = 1; x < kSide - 1; ++x) {
      const bool looked_at =
          (x + y) % 5 == 0 && (cells.at_edge(x, y) || (x % 5 == 0 && cells.at(x, y)));
      if (!looked_at) continue;
      farthest = std::max(farthest, distance_mm_to(region, location, Cells::centre(x, y)));
    }
  }
  return farthest;
}

}  // namespace

TEST_CASE("over all layers the inside is the formula's, and lacks no more than growth may lack") {
  const Settings settings = high_layers();
  for (const Stack& stack : stacks()) {
    CAPTURE(stack.name);
    const std::vector<InsideLayer> found = fold(stack, settings);
    Cells least, most;
    int steps = 0;  // since the first seed
    double lost_mm = 0, out_mm = 0;
    for (std::size_t n = found.size(); n-- > 0;) {
      CAPTURE(n);
      const Region& loose = *found[n].loose;
      least = formula(least, stack.insides[n], *found[n].seed, kStepCells);
      most = formula(most, stack.insides[n], *found[n].seed, kStepCellsMost);
      const double out = reach_mm(loose, most);
      CHECK_LE(out, kEdge_mm);
      out_mm = std::max(out_mm, out);
      const double lost = farthest_mm(least, loose);
      CHECK_LE(lost, kEdge_mm + steps * (kGrowthLoss * kStep_mm + kRounding_mm));
      lost_mm = std::max(lost_mm, lost);
      steps += loose.empty() ? 0 : 1;
    }
    CHECK_GE(steps, 30);
    MESSAGE(stack.name, ": lacks up to ", lost_mm, " mm, reaches out ", out_mm);
  }
}
