#include "core/slices/standing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "core/booleans/boolean.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_text.h"

using core::Length;
using core::Region;
using core::StandingReport;

namespace {

struct Block {
  double x, y, width, depth, bottom, top;
};

// Slices of a part made of blocks.
StandingReport report_of(const std::vector<Block>& blocks, double layer_mm, double brim_mm = 0) {
  double top = 0;
  for (const Block& block : blocks) top = std::max(top, block.top);
  core::Standing standing(brim_mm);
  for (int layer = 0; layer < std::lround(top / layer_mm); ++layer) {
    core::Slice slice;
    slice.index = layer;
    slice.bottom = Length::from_mm(layer * layer_mm);
    slice.height = Length::from_mm(layer_mm);
    const double z = (layer + 0.5) * layer_mm;
    for (const Block& b : blocks) {
      if (z < b.bottom || z > b.top) continue;
      slice.region = core::unite(slice.region, test::rectangle_region(b.x, b.y, b.width, b.depth));
    }
    standing.add(slice);
  }
  return standing.report();
}

// The second computation: a part of cells, all of which are held.
constexpr int kSide = 4;
constexpr int kLayers = 10;
constexpr double kCell_mm = 4;
constexpr double kLayer_mm = 12;

// By number, from 0.
struct Cells : std::bitset<kSide * kSide> {
  using Bits = std::bitset<kSide * kSide>;
  Cells() = default;
  // NOLINTNEXTLINE(google-explicit-constructor)
  Cells(const Bits& bits) : Bits(bits) {}
  bool operator[](int i) const { return Bits::operator[](static_cast<std::size_t>(i)); }
  reference operator[](int i) { return Bits::operator[](static_cast<std::size_t>(i)); }
};

bool beside(int a, int b) {
  return std::abs(a / kSide - b / kSide) + std::abs(a % kSide - b % kSide) == 1;
}

// Connected by cells' sides.
std::vector<Cells> islands_of(Cells cells) {
  std::vector<Cells> islands;
  for (int start = 0; start < kSide * kSide; ++start) {
    if (!cells[start]) continue;
    Cells island;
    island[start] = true;
    for (Cells before; before != island;) {
      before = island;
      for (int a = 0; a < kSide * kSide; ++a) {
        for (int b = 0; b < kSide * kSide; ++b) {
          if (island[a] && cells[b] && beside(a, b)) island[b] = true;
        }
      }
    }
    islands.push_back(island);
    cells &= ~island;
  }
  return islands;
}

Region region_of_cells(Cells cells) {
  std::vector<core::Ring> rings;
  for (int i = 0; i < kSide * kSide; ++i) {
    if (!cells[i]) continue;
    const double x = i % kSide * kCell_mm, y = i / kSide * kCell_mm;
    rings.push_back(test::rectangle(x, y, x + kCell_mm, y + kCell_mm));
  }
  return core::clean(rings, core::FillRule::kNonZero);
}

struct Size {
  double breadth_mm = std::numeric_limits<double>::max();
  double length_mm = 0;
};

// Across every line through two corners of the cells.
Size size_of_cells(Cells cells) {
  std::set<std::array<int, 2>> corners;
  for (int i = 0; i < kSide * kSide; ++i) {
    if (!cells[i]) continue;
    for (int k = 0; k < 4; ++k) corners.insert({i % kSide + k % 2, i / kSide + k / 2});
  }
  Size size;
  for (const auto& a : corners) {
    for (const auto& b : corners) {
      const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
      if (length == 0) continue;
      double left = -1e9, right = 1e9, front = -1e9, back = 1e9;
      for (const auto& c : corners) {
        const double across = (dx * (c[1] - a[1]) - dy * (c[0] - a[0])) / length;
        const double along = (dx * (c[0] - a[0]) + dy * (c[1] - a[1])) / length;
        left = std::max(left, across), right = std::min(right, across);
        front = std::max(front, along), back = std::min(back, along);
      }
      if ((left - right) * kCell_mm >= size.breadth_mm - 1e-9) continue;
      size = {(left - right) * kCell_mm, (front - back) * kCell_mm};
    }
  }
  return size;
}

// By layer, from 0.
struct Stack : std::vector<Cells> {
  using std::vector<Cells>::vector;
  const Cells& operator[](int layer) const { return at(static_cast<std::size_t>(layer)); }
  Cells& operator[](int layer) { return at(static_cast<std::size_t>(layer)); }
};

// Nothing of it begins in the air.
Stack random_stack(test::Random& random) {
  Stack stack;
  const double share = random.between(0.25, 0.7), change = random.between(0.02, 0.3);
  for (int layer = 0; layer < kLayers; ++layer) {
    Cells cells = layer > 0 ? stack.back() : Cells();
    for (int i = 0; i < kSide * kSide; ++i) {
      if (layer == 0 || random.unit() < change) cells[i] = random.unit() < share;
    }
    Cells held;
    for (const Cells& island : islands_of(cells)) {
      if (layer == 0 || (island & stack.back()).any()) held |= island;
    }
    stack.push_back(held);
  }
  return stack;
}

// What hangs together in layers 0 … top with each island of layer `top`: its cells on the bed.
std::vector<Cells> feet(const Stack& stack, int top) {
  std::vector<Cells> result;
  for (const Cells& island : islands_of(stack[top])) {
    Stack whole(static_cast<std::size_t>(top) + 1);
    whole[top] = island;
    for (Stack before; before != whole;) {
      before = whole;
      for (int layer = 0; layer <= top; ++layer) {
        for (const Cells& other : islands_of(stack[layer])) {
          const bool meets = (layer > 0 && (other & whole[layer - 1]).any()) ||
                             (layer < top && (other & whole[layer + 1]).any());
          if (meets) whole[layer] |= other;
        }
      }
    }
    result.push_back(whole[0]);
  }
  return result;
}

// Of all columns that end with this island: by going down from it, for each thickness anew.
double column_slenderness(const Stack& stack, int top, const Cells& island) {
  const auto thickness = [](const Cells& cells) {
    const Size size = size_of_cells(cells);
    return std::pow(size.length_mm * std::pow(size.breadth_mm, 3), 0.25);
  };
  double slenderest = 0;
  for (const double limit : core::kColumnThicknesses_mm) {
    if (thickness(island) >= limit) continue;
    double thickest = thickness(island);
    int bottom = top;
    std::vector<Cells> level{island};
    for (int layer = top - 1; layer >= 0 && !level.empty(); --layer) {
      std::vector<Cells> below;
      for (const Cells& other : islands_of(stack[layer])) {
        const bool meets = std::any_of(level.begin(), level.end(),
                                       [&](const Cells& one) { return (one & other).any(); });
        if (meets && thickness(other) < limit) below.push_back(other);
      }
      for (const Cells& one : below) thickest = std::max(thickest, thickness(one));
      if (!below.empty()) bottom = layer;
      level = below;
    }
    slenderest = std::max(slenderest, (top + 1 - bottom) * kLayer_mm / thickest);
  }
  return slenderest;
}

}  // namespace

TEST_CASE("bodies and columns of random stacks of cells are those that holding all layers finds") {
  std::int64_t loose_bodies = 0, columns = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Stack stack = random_stack(random);
    core::Standing standing(0);
    std::map<unsigned long, int> layers_on;  // by foot
    double thinnest = 0;
    for (int layer = 0; layer < kLayers; ++layer) {
      standing.add({layer,
                    Length::from_mm(layer * kLayer_mm),
                    Length::from_mm(kLayer_mm),
                    region_of_cells(stack[layer]),
                    {}});
      for (const Cells& foot : feet(stack, layer)) layers_on[foot.to_ulong()] = layer + 1;
      for (const Cells& island : islands_of(stack[layer])) {
        thinnest = std::max(thinnest, column_slenderness(stack, layer, island));
      }
    }
    double slenderest = 0;
    std::int64_t loose = 0;
    for (const auto& [foot, layers] : layers_on) {
      const double height_mm = layers * kLayer_mm,
                   breadth_mm = size_of_cells(Cells(foot)).breadth_mm;
      const double area_mm2 = static_cast<double>(Cells(foot).count()) * kCell_mm * kCell_mm;
      slenderest = std::max(slenderest, height_mm / breadth_mm);
      const bool weak = 0.0981 * height_mm > 0.02 * area_mm2 * breadth_mm / 6;
      loose += weak && height_mm / breadth_mm >= 5 - 1e-9 ? 1 : 0;
    }
    const StandingReport report = standing.report();
    if (!report.slenderest) continue;
    const double found = core::slenderness(report.slenderest->foot, report.slenderest->height.mm());
    CHECK_EQ(found, doctest::Approx(slenderest).epsilon(1e-6));
    CHECK_EQ(report.loose_bodies, loose);
    CHECK_EQ(report.thinnest.has_value(), thinnest >= core::kColumnSlenderness - 1e-9);
    if (report.thinnest) {
      CHECK_EQ(report.thinnest->slenderness, doctest::Approx(thinnest).epsilon(1e-6));
    }
    loose_bodies += loose;
    columns += report.thin_columns;
  }
  MESSAGE(loose_bodies << " loose bodies, " << columns << " thin columns");
  CHECK_GT(loose_bodies, 20);
  CHECK_GT(columns, 20);
}

TEST_CASE("a pillar is as slender as it is, and as a column as well, with layers of any height") {
  for (const double layer_mm : {0.1, 0.5, 2.0}) {
    CAPTURE(layer_mm);
    const StandingReport report = report_of({{10, 20, 4, 6, 0, 60}}, layer_mm);
    REQUIRE(report.loosest);
    CHECK_EQ(report.loose_bodies, 1);
    CHECK_EQ(report.loosest->height, Length::from_mm(60));
    CHECK_EQ(report.loosest->foot.breadth_mm, doctest::Approx(4));
    CHECK_EQ(report.loosest->foot.area_mm2, doctest::Approx(24));
    CHECK_EQ(report.loosest->foot.at, core::Point{120'000, 230'000});
    REQUIRE(report.thinnest);
    CHECK_EQ(report.thinnest->thickness_mm, doctest::Approx(std::pow(6.0 * 64, 0.25)));
    CHECK_EQ(report.thin_columns, 1);
  }
}

TEST_CASE("a brim that is there is counted, and told without") {
  const std::vector<Block> pillar{{0, 0, 4, 4, 0, 60}};
  const StandingReport bare = report_of(pillar, 0.5);
  REQUIRE(bare.loosest);
  const auto brim_mm = core::brim_that_holds_mm(bare.loosest->foot, 60);
  REQUIRE(brim_mm);
  CHECK_EQ(report_of(pillar, 0.5, *brim_mm).loose_bodies, 0);
  CHECK_EQ(report_of(pillar, 0.5, *brim_mm - 1).loose_bodies, 1);
  CHECK_EQ(report_of(pillar, 0.5, *brim_mm - 1).loosest->foot.breadth_mm, doctest::Approx(4));
}

TEST_CASE("legs stand alone up to the table's top, and together from there") {
  std::vector<Block> table;
  for (const double x : {0, 40}) {
    for (const double y : {0, 40}) table.push_back({x, y, 3, 3, 0, 40});
  }
  table.push_back({-1, -1, 45, 45, 40, 45});
  const StandingReport report = report_of(table, 0.5);
  CHECK_EQ(report.loose_bodies, 4);
  CHECK_EQ(report.thin_columns, 4);
  REQUIRE(report.loosest);
  CHECK_EQ(report.loosest->height, Length::from_mm(40));
  CHECK_EQ(report.thinnest->top, Length::from_mm(40));
  // Joined low enough, none is told.
  for (std::size_t i = 0; i < 4; ++i) table[i].top = 10;
  table[4].bottom = 10;
  CHECK_EQ(report_of(table, 0.5).loose_bodies, 0);
  CHECK_FALSE(report_of(table, 0.5).thinnest);
}

TEST_CASE("a mast on a plate is thin, the plate stands; a fin as thick is stiffer") {
  const StandingReport mast = report_of({{0, 0, 30, 30, 0, 10}, {14, 14, 2, 2, 10, 40}}, 0.2);
  CHECK_EQ(mast.loose_bodies, 0);
  REQUIRE(mast.thinnest);
  CHECK_EQ(mast.thinnest->bottom, Length::from_mm(10));
  CHECK_EQ(mast.thinnest->top, Length::from_mm(40));
  CHECK_EQ(mast.thinnest->slenderness, doctest::Approx(15));
  CHECK_FALSE(report_of({{0, 0, 60, 30, 0, 10}, {0, 14, 60, 3, 10, 50}}, 0.2).thinnest);
}

TEST_CASE("what gets thinner upwards is judged by its thin part") {
  std::vector<Block> spire;
  for (int i = 0; i < 9; ++i) spire.push_back({0, 0, 9.0 - i, 9.0 - i, i * 1.0, i + 1.0});
  spire.push_back({0, 0, 0.9, 0.9, 9, 19});
  const StandingReport report = report_of(spire, 0.5);
  REQUIRE(report.thinnest);
  CHECK_EQ(report.thinnest->bottom, Length::from_mm(9));
  CHECK_EQ(report.thinnest->slenderness, doctest::Approx(10 / 0.9));
}

TEST_CASE("a column that leans is one; thick parts between make two") {
  std::vector<Block> leaning;
  for (int i = 0; i < 40; ++i) leaning.push_back({i * 0.1, 0, 2, 2, i * 1.0, i + 1.0});
  const StandingReport one = report_of(leaning, 0.5);
  CHECK_EQ(one.thin_columns, 1);
  REQUIRE(one.thinnest);
  CHECK_EQ(one.thinnest->slenderness, doctest::Approx(20));
  CHECK_EQ(one.loosest->height, Length::from_mm(40));
  const StandingReport two =
      report_of({{6, 6, 2, 2, 0, 20}, {0, 0, 14, 14, 20, 30}, {6, 6, 2, 2, 30, 60}}, 0.5);
  CHECK_EQ(two.thin_columns, 2);
  CHECK_EQ(two.thinnest->bottom, Length::from_mm(30));
}

TEST_CASE("two feet that are joined hold with the areas of both") {
  const std::vector<Block> bridge{
      {0, 0, 8, 12, 0, 70}, {16, 0, 8, 12, 0, 70}, {0, 0, 24, 12, 10, 70}};
  const StandingReport report = report_of(bridge, 0.5);
  CHECK_EQ(report.loose_bodies, 0);
  REQUIRE(report.slenderest);
  CHECK_EQ(report.slenderest->foot.area_mm2, doctest::Approx(192));
  CHECK_EQ(report.slenderest->foot.breadth_mm, doctest::Approx(12));
}

TEST_CASE("an empty part, crumbs, and islands over the limit") {
  CHECK_FALSE(core::Standing(0).report().slenderest);
  CHECK_EQ(report_of({{0, 0, 0.01, 0.01, 0, 0.4}}, 0.2).loose_bodies, 0);
  std::vector<Block> many;
  const int count = static_cast<int>(core::kStandingIslandsMax) + 10;
  for (int i = 0; i < count; ++i) many.push_back({i * 3.0, 0, 1, 1, 0, 10});
  const StandingReport report = report_of(many, 5);
  CHECK_EQ(report.loose_bodies, core::kStandingIslandsMax);
  CHECK_EQ(report.islands_not_followed, 10);
}

TEST_CASE("objects that are printed one after another stand each by itself") {
  core::Standing standing(0);
  const auto add = [&standing](double x, double side, int layers) {
    for (int i = 0; i < layers; ++i) {
      core::Slice slice;
      slice.index = i;
      slice.bottom = Length::from_mm(i);
      slice.height = Length::from_mm(1);
      slice.region = test::rectangle_region(x, 0, side, side);
      standing.add(slice);
    }
  };
  add(0, 2, 30);
  const StandingReport mast = standing.report();
  standing.next_object();
  // At the same place on the bed: it is not what the mast's top goes on as.
  add(0, 20, 5);
  const StandingReport both = standing.report();
  REQUIRE(both.slenderest.has_value());
  CHECK_EQ(both.slenderest->height, Length::from_mm(30));
  CHECK_EQ(both.loose_bodies, mast.loose_bodies);
  CHECK_EQ(both.thin_columns, 1);
  standing.next_object();
  add(40, 2, 30);
  CHECK_EQ(standing.report().thin_columns, 2);
  standing.next_object();
  // Begins as the one before has ended.
  add(40, 2, 30);
  CHECK_EQ(standing.report().thin_columns, 3);
  CHECK_EQ(standing.report().loose_bodies, 3 * mast.loose_bodies);
}
