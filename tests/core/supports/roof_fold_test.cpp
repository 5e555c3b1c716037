// An inside that holds up its own roof: laws on stacks of insides, and the formula computed again
// on a raster with all layers held.
#include "core/supports/roof_fold.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/regions/point_location.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

constexpr Length kExact = Length::from_units(10);

// High layers, so that a step is many cells of the raster.
Settings high_layers() {
  Settings settings;
  settings.layer_height = Length::from_mm(1);
  settings.road_width = Length::from_mm(3);
  settings.loose_width_min = Length::from_mm(1);
  settings.loose_area_min_mm2 = 0.5;
  settings.bridge_max = Length::from_mm(12);
  settings.loose_roof = LooseRoof::kCone;
  return settings;
}

// From the bed up.
std::vector<InsideLayer> fold(const std::vector<Region>& insides, const Settings& settings) {
  RoofFold fold(settings);
  std::vector<InsideLayer> found(insides.size());
  const auto take = [&] {
    while (auto layer = fold.next()) found[static_cast<std::size_t>(layer->index)] = *layer;
  };
  std::shared_ptr<const Region> last;
  for (std::size_t i = insides.size(); i-- > 0;) {
    if (!last || !(*last == insides[i])) last = std::make_shared<const Region>(insides[i]);
    const auto index = static_cast<LayerIndex>(i);
    fold.push({index, settings.layer_height * index, settings.layer_height, last, nullptr});
    take();
  }
  fold.end();
  take();
  for (const InsideLayer& layer : found) REQUIRE(layer.loose);
  return found;
}

Region disc(double x, double y, double radius_mm) {
  Ring ring;
  constexpr int kPoints = 96;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * M_PI * i / kPoints;
    ring.push_back(
        {static_cast<std::int32_t>(std::lround((x + radius_mm * std::cos(angle)) * 1e4)),
         static_cast<std::int32_t>(std::lround((y + radius_mm * std::sin(angle)) * 1e4))});
  }
  return clean({ring}, FillRule::kNonZero);
}

Region square(double side_mm) {
  return test::rectangle_region(50 - side_mm / 2, 50 - side_mm / 2, side_mm, side_mm);
}

struct Case {
  std::string name;
  std::vector<Region> insides;
};

std::vector<Case> cases() {
  std::vector<Case> all(4);
  all[0].name = "box";
  all[0].insides.assign(30, square(50));
  all[1].name = "narrow box";
  all[1].insides.assign(20, square(9));
  all[2].name = "dome";
  for (int i = 0; i < 25; ++i) all[2].insides.push_back(disc(50, 50, std::sqrt(625.0 - i * i)));
  all[3].name = "pyramid";  // its sides rise at 27°
  for (int i = 0; i < 14; ++i) all[3].insides.push_back(square(60 - 4 * i));
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Case random;
    random.name = "seed " + std::to_string(seed);
    test::Random dice(seed);
    Region inside = disc(50, 50, 20);
    for (int i = 0; i < 16; ++i) {
      const Region more = disc(dice.between(30, 70), dice.between(30, 70), dice.between(3, 16));
      if (dice.unit() < 0.3) inside = subtract(inside, more);
      if (dice.unit() < 0.5) inside = unite(inside, more);
      random.insides.push_back(inside);
    }
    all.push_back(std::move(random));
  }
  return all;
}

double widest_piece(const Region& region) { return test::widest_difference(region, {}); }

// The formula's insides by brute force: cells, every cell against every cell within the step.
class Raster {
 public:
  static constexpr int kCells = 200;  // a side
  static constexpr double kCell_mm = 0.5;
  static constexpr double kNear_mm = 0.75;  // a cell and its diagonal neighbours
  using Cells = std::vector<bool>;

  static Cells of(const Region& region) {
    Cells cells(kCells * kCells);
    const PointLocation at(region);
    for (int y = 0; y < kCells; ++y) {
      for (int x = 0; x < kCells; ++x) cells[index(x, y)] = at.contains(centre(x, y));
    }
    return cells;
  }

  static Cells grown(const Cells& cells, double by_mm) {
    Cells result(cells.size());
    const int reach = static_cast<int>(by_mm / kCell_mm) + 1;
    for (int y = 0; y < kCells; ++y) {
      for (int x = 0; x < kCells; ++x) {
        if (!cells[index(x, y)]) continue;
        for (int v = std::max(0, y - reach); v <= std::min(kCells - 1, y + reach); ++v) {
          for (int u = std::max(0, x - reach); u <= std::min(kCells - 1, x + reach); ++u) {
            if (std::hypot(u - x, v - y) * kCell_mm <= by_mm) result[index(u, v)] = true;
          }
        }
      }
    }
    return result;
  }

  static std::size_t index(int x, int y) {
    return static_cast<std::size_t>(y) * kCells + static_cast<std::size_t>(x);
  }
  static Point centre(int x, int y) {
    return {static_cast<std::int32_t>((x + 0.5) * kCell_mm * kUnitsPerMm),
            static_cast<std::int32_t>((y + 0.5) * kCell_mm * kUnitsPerMm)};
  }
};

}  // namespace

TEST_CASE("the inside grows by the step at most, but for seeds, and what lies over it is held") {
  const Settings settings = high_layers();
  for (const Case& each : cases()) {
    CAPTURE(each.name);
    const std::vector<InsideLayer> found = fold(each.insides, settings);
    bool any = false;
    for (std::size_t n = 0; n < found.size(); ++n) {
      CAPTURE(n);
      const Region& loose = *found[n].loose;
      any |= !loose.empty();
      CHECK_LE(widest_piece(subtract(loose, each.insides[n])), 3);
      const Region none;
      const bool top = n + 1 == found.size();
      const Region& above = top ? none : *found[n + 1].loose;
      const Length step = top ? Length() : cone_step(found[n + 1], found[n], settings);
      if (!top) CHECK_EQ(step.mm(), doctest::Approx(1).epsilon(0.0002));
      const Region reach = above.empty() ? above : offset(above, -step, kExact);
      CHECK_LE(widest_piece(subtract(loose, unite(reach, *found[n].seed))), 3);
      // Held: what is solid above lies within the step of what is solid here, the tips of corners
      // within twice that; but for what rows bridge from one side of a seed to the other.
      const Length far = step * 2;
      const Region inner = loose.empty() ? loose : offset(loose, far, kExact);
      for (Island& island : islands(subtract(subtract(inner, above), *found[n].seed))) {
        const Region hangs = region_of(std::move(island));
        CAPTURE(hangs.box().min.x);
        CAPTURE(hangs.box().min.y);
        CHECK_LE(hangs.area_mm2(), 0.01);
      }
    }
    CHECK(any);
  }
}

TEST_CASE("each inside is the one that cells give by the formula, where nothing is kept for ribs") {
  const Settings settings = high_layers();
  for (const Case& each : cases()) {
    if (each.name != "narrow box" && each.name != "dome" && each.name != "pyramid") continue;
    CAPTURE(each.name);
    const std::vector<InsideLayer> found = fold(each.insides, settings);
    Raster::Cells ours(Raster::kCells * Raster::kCells);
    for (std::size_t n = found.size(); n-- > 0;) {
      CAPTURE(n);
      const Raster::Cells given = Raster::of(each.insides[n]), seed = Raster::of(*found[n].seed);
      Raster::Cells formula = Raster::grown(ours, 1);
      for (std::size_t i = 0; i < formula.size(); ++i) {
        formula[i] = given[i] && (formula[i] || seed[i]);
      }
      ours = Raster::of(*found[n].loose);
      const Raster::Cells wider = Raster::grown(ours, Raster::kNear_mm);
      const Raster::Cells far = Raster::grown(formula, Raster::kNear_mm);
      int lost = 0, more = 0;
      for (std::size_t i = 0; i < ours.size(); ++i) {
        lost += formula[i] && !wider[i] ? 1 : 0;
        more += ours[i] && !far[i] ? 1 : 0;
      }
      CHECK_EQ(lost, 0);
      CHECK_EQ(more, 0);
    }
  }
}

TEST_CASE("what is new and narrower than a step becomes loose as it is, and is held") {
  const Settings settings = high_layers();
  // The sides move outwards by 0.8 mm in each layer, the corners by 1.13 mm.
  std::vector<Region> pyramid;
  for (int i = 0; i < 12; ++i) pyramid.push_back(square(27.6 - 1.6 * i));
  const std::vector<InsideLayer> found = fold(pyramid, settings);
  std::size_t highest = 0;  // the roof begins there
  for (std::size_t n = 0; n < found.size(); ++n) highest = found[n].loose->empty() ? highest : n;
  REQUIRE_GE(highest, 8);
  for (std::size_t n = 0; n < highest; ++n) {
    CAPTURE(n);
    CHECK_LE(widest_piece(subtract(pyramid[n], *found[n].loose)), 3);
    const Region inner = offset(*found[n].loose, settings.layer_height, kExact);
    CHECK_LE(widest_piece(subtract(inner, *found[n + 1].loose)), 3);
  }
}

TEST_CASE("a wide roof is cut into strips whose walls stand on the floor") {
  const Settings settings = high_layers();
  const std::vector<InsideLayer> found = fold(std::vector<Region>(30, square(50)), settings);
  const Region& top = *found.back().loose;
  CHECK_GE(islands(top).size(), 3);
  for (Island& island : islands(top)) {
    const Box box = region_of(std::move(island)).box();
    CHECK_LE(box.max.x - box.min.x, settings.bridge_max.units());
  }
  // A row goes on as a wall of the same width: nothing changes down to the floor.
  for (const InsideLayer& layer : found) CHECK(*layer.loose == top);
}

TEST_CASE("a roof that gets wider below is begun where it can just be bridged") {
  const Settings settings = high_layers();
  std::vector<Region> dome;
  for (int i = 0; i < 25; ++i) dome.push_back(disc(50, 50, std::sqrt(625.0 - i * i)));
  const std::vector<InsideLayer> found = fold(dome, settings);
  // A disc of 12 mm would be 0.73 layers under the top, the next one is wider than that.
  std::size_t highest = 0;
  for (std::size_t n = 0; n < found.size(); ++n) highest = found[n].loose->empty() ? highest : n;
  const Box box = found[highest].loose->box();
  CHECK_EQ(highest, 24);
  CHECK_LE(box.max.x - box.min.x, 150'000);
}

TEST_CASE("a hollow grows at its angle over thousands of layers, in few points") {
  Settings settings;
  settings.layer_height = Length::from_mm(0.05);
  settings.loose_roof = LooseRoof::kCone;
  // The disc is bridged, and strips would be too narrow: the rest of the roof is not begun.
  settings.bridge_max = Length::from_mm(10.2);
  settings.loose_width_min = Length::from_mm(9.5);
  const Region wide = test::rectangle_region(0, 0, 1'000, 1'000);
  const auto inside = std::make_shared<const Region>(wide);
  const auto first = std::make_shared<const Region>(disc(500, 500, 5));
  RoofFold fold(settings);
  constexpr LayerIndex kLayers = 3'000;
  std::size_t most = 0;
  double least = 1, largest = 0;  // of the growth, as a share of the exact one
  for (LayerIndex n = kLayers; n-- > 0;) {
    const auto& given = n + 1 == kLayers ? first : inside;
    fold.push({n, settings.layer_height * n, settings.layer_height, given, nullptr});
    if (n == 0) fold.end();
    while (auto layer = fold.next()) {
      most = std::max(most, layer->loose->point_count());
      const Box box = layer->loose->box();
      const double radius = (box.max.x - box.min.x) / 2.0 / kUnitsPerMm;
      const auto steps = static_cast<double>(kLayers - 1 - layer->index);
      if (steps < 100) continue;
      const double share = (radius - 5) / (steps * 0.05);
      least = std::min(least, share);
      largest = std::max(largest, share);
    }
  }
  MESSAGE("growth from ", least, " to ", largest, ", at most ", most, " points");
  CHECK_LE(largest, 1);
  CHECK_GE(least, 0.98);
  CHECK_LE(most, 2'000);
}
