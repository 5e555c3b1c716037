// Branches under roofs, held against the formula on cells of a line with all layers held.
#include "core/supports/lightning_fold.h"

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
#include "tests/support/region_text.h"

using namespace core;

namespace {

constexpr double kSide_mm = 60;

Settings lightning() {
  Settings settings;
  settings.loose_pattern = LoosePattern::kLightning;
  return settings;
}

// From the bed up.
std::vector<Branches> fold(const std::vector<Region>& insides, const Settings& settings) {
  LightningFold fold(settings);
  std::vector<Branches> found(insides.size());
  for (std::size_t i = insides.size(); i-- > 0;) {
    const auto index = static_cast<LayerIndex>(i);
    found[i] = fold.push({index, settings.layer_height * index, settings.layer_height,
                          std::make_shared<const Region>(insides[i]), nullptr});
  }
  return found;
}

Region square(double side_mm) {
  return test::rectangle_region(30 - side_mm / 2, 30 - side_mm / 2, side_mm, side_mm);
}

// What is branch on the level line at this height, as cells of 0.01 mm.
constexpr int kCells = 6'000;
using Cells = std::vector<char>;

Cells cells_of(const Branches& branches, std::int32_t y) {
  Cells cells(kCells);
  for (const Branch& branch : branches) {
    if (branch.from.y != y || branch.to.y != y) continue;
    const auto first = std::max(0, (branch.from.x + 50) / 100);
    for (int i = first; i < kCells && i * 100 + 50 < branch.to.x; ++i) {
      cells[static_cast<std::size_t>(i)] = 1;
    }
  }
  return cells;
}

Cells cells_of(const PointLocation& region, std::int32_t y) {
  Cells cells(kCells);
  for (int i = 0; i < kCells; ++i) {
    cells[static_cast<std::size_t>(i)] = region.contains({i * 100 + 50, y}) ? 1 : 0;
  }
  return cells;
}

std::vector<std::vector<Region>> stacks() {
  std::vector<std::vector<Region>> all(3);
  all[0].assign(60, square(40));                                           // a box
  for (int i = 0; i < 60; ++i) all[1].push_back(square(52.13 - 0.8 * i));  // a pyramid of 68°
  for (int i = 0; i < 60; ++i) all[2].push_back(square(20.13 + 0.5 * i));  // and one upside down
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    test::Random dice(seed);
    std::vector<Region> random;
    Region inside = square(40);
    for (int i = 0; i < 50; ++i) {
      const Region piece = test::rectangle_region(dice.between(5, 45), dice.between(5, 45),
                                                  dice.between(2, 12), dice.between(2, 12));
      inside = dice.unit() < 0.5 ? unite(inside, piece) : subtract(inside, piece);
      random.push_back(inside);
    }
    all.push_back(std::move(random));
  }
  return all;
}

std::int32_t spacing_units(const Settings& settings) {
  return static_cast<std::int32_t>(std::lround(kBranchSpacing * settings.bridge_max.mm() * 1e4));
}

}  // namespace

// A stretch of a line that has plastic above and air under it.
struct Hanging {
  int cells = 0;
  bool both = false;  // held at both ends
};

// Stretches where `plastic` is over loose cells that are no branch.
std::vector<Hanging> hanging(const Cells& plastic, const Cells& loose, const Cells& branch) {
  std::vector<Hanging> all;
  const auto held = [&](std::size_t i) { return loose[i] == 0 || branch[i] != 0; };
  for (std::size_t i = 1; i + 1 < plastic.size(); ++i) {
    if (plastic[i] == 0 || held(i)) continue;
    Hanging found;
    const bool from = held(i - 1);
    for (; i + 1 < plastic.size() && plastic[i] != 0 && !held(i); ++i) ++found.cells;
    found.both = from && held(i);
    all.push_back(found);
  }
  return all;
}

TEST_CASE("on each line branches hold what lies over them: within the step, or across a gap") {
  const Settings settings = lightning();
  const InsideLayer upper{1, settings.layer_height, settings.layer_height, nullptr, nullptr};
  const InsideLayer lower{0, Length(), settings.layer_height, nullptr, nullptr};
  const Length reach = cone_step(upper, lower, settings);
  // With what is too short to be laid, and a cell at either end.
  const int most = static_cast<int>((reach + kBranchMin).mm() * 100) + 2;
  const int gap = static_cast<int>(kBranchGap * settings.bridge_max.mm() * 100) + 2;
  const std::vector<std::vector<Region>> all = stacks();
  for (std::size_t stack = 0; stack < all.size(); ++stack) {
    CAPTURE(stack);
    const std::vector<Region>& insides = all[stack];
    const std::vector<Branches> found = fold(insides, settings);
    std::size_t branches = 0;
    for (std::size_t n = 0; n + 1 < insides.size(); ++n) {
      CAPTURE(n);
      branches += found[n].size();
      const Region inner =
          offset(insides[n], reach + Length::from_mm(0.02), Length::from_units(10));
      const PointLocation loose_at(insides[n]), over_at(insides[n + 1]), deep_at(inner);
      for (std::int32_t y = spacing_units(settings); y < kSide_mm * 1e4;
           y += spacing_units(settings)) {
        CAPTURE(y);
        const Cells loose = cells_of(loose_at, y), over = cells_of(over_at, y);
        const Cells here = cells_of(found[n], y), above = cells_of(found[n + 1], y);
        Cells roof = cells_of(deep_at, y);
        for (std::size_t i = 0; i < roof.size(); ++i) {
          if (over[i] != 0) roof[i] = 0;
          if (here[i] != 0) REQUIRE_NE(loose[i], 0);
        }
        for (const Hanging& each : hanging(roof, loose, here)) CHECK_LE(each.cells, most);
        for (const Hanging& each : hanging(above, loose, here)) {
          CHECK_LE(each.cells, each.both ? gap : most);
        }
      }
    }
    CHECK_GT(branches, 0);
  }
}

TEST_CASE("under a flat roof whole lines are branches, which draw back to the wall") {
  const Settings settings = lightning();
  const std::vector<Branches> found = fold(std::vector<Region>(200, square(40)), settings);
  const Branches& top = found[199];
  // Lines 6.5 mm apart, over 40 mm, in two directions.
  CHECK_GE(top.size(), 12);
  for (const Branch& branch : top) {
    CHECK(branch.from_wall);
    CHECK(branch.to_wall);
  }
  CHECK_EQ(found[198].size(), 2 * top.size());
  const auto longest = [](const Branches& branches) {
    std::int32_t most = 0;
    for (const Branch& b : branches) most = std::max({most, b.to.x - b.from.x, b.to.y - b.from.y});
    return most;
  };
  // 16 mm at each side of a gap of 8 mm; 0.18 mm less with each layer.
  CHECK_EQ(longest(found[198]) / 1e4, doctest::Approx(16).epsilon(0.02));
  CHECK_EQ(longest(found[148]) / 1e4, doctest::Approx(7).epsilon(0.02));
  CHECK(found[110].empty());
  CHECK(found[0].empty());
}

TEST_CASE("walls that lean less than the angle need no branch") {
  const Settings settings = lightning();
  std::vector<Region> insides;
  for (int i = 0; i < 30; ++i) insides.push_back(square(4.5 + 0.3 * i));
  for (int i = 0; i < 30; ++i) insides.push_back(square(13.2 - 0.3 * i));
  const std::vector<Branches> found = fold(insides, settings);
  // Those under the roof at the top have drawn back by then.
  for (std::size_t n = 0; n < 33; ++n) CHECK(found[n].empty());
}

TEST_CASE("branches are at fixed places, whatever the part around them") {
  const Settings settings = lightning();
  const std::vector<Branches> found = fold(std::vector<Region>(3, square(31)), settings);
  REQUIRE_FALSE(found[2].empty());
  for (const Branch& branch : found[2]) {
    const std::int32_t across = branch.from.y == branch.to.y ? branch.from.y : branch.from.x;
    CHECK_EQ(across % spacing_units(settings), 0);
  }
}
