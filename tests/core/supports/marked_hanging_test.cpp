// Marks of people, held against stacks of cells and boxes, where every point can be asked.
#include "core/supports/marked_hanging.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/supports/support_fold.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

constexpr std::size_t kCells = 6;  // a side; 2 mm each
constexpr double kCell_mm = 2, kSide_mm = 12;
constexpr std::size_t kLayers = 9;

// What opening takes from edges, and what widens narrow pieces.
constexpr double kEdge_mm = 0.2;

// No gap or distance, and nothing small or bridged.
Settings bare() {
  Settings settings;
  settings.supports = SupportPlace::kEverywhere;
  settings.support_top_gap_layers = 0;
  settings.support_bottom_gap_layers = 0;
  settings.support_xy_distance = Length();
  settings.support_interface_layers = 0;
  settings.support_bottom_interface_layers = 0;
  settings.support_base_expansion = Length();
  settings.support_area_min_mm2 = 0;
  settings.support_section_min = Length();
  settings.bridge_max = Length();
  settings.road_width_min = Length::from_mm(0.1);
  return settings;
}

// A box of a mark: layers from `low` up to `high`.
struct MarkBox {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  std::size_t low = 0, high = 0;

  [[nodiscard]] bool has(std::size_t layer, double x, double y) const {
    return layer >= low && layer <= high && x > x0 && x < x1 && y > y0 && y < y1;
  }
  [[nodiscard]] bool has_edge_near(double x, double y) const {
    const auto near = [](double a, double b) { return std::abs(a - b) < kEdge_mm; };
    return near(x, x0) || near(x, x1) || near(y, y0) || near(y, y1);
  }
};

struct MarkedStack {
  std::vector<std::vector<bool>> layers;  // of cells
  std::vector<MarkBox> enforcers, blockers;

  [[nodiscard]] bool solid(std::size_t layer, double x, double y) const {
    const auto column = static_cast<std::size_t>(x / kCell_mm);
    return layers[layer][static_cast<std::size_t>(y / kCell_mm) * kCells + column];
  }

  // Whether a support is at this point: under the first thing above it, if that is held.
  [[nodiscard]] bool held(std::size_t layer, double x, double y, bool automatic) const {
    if (solid(layer, x, y)) return false;
    for (std::size_t m = layer + 1; m < layers.size(); ++m) {
      if (!solid(m, x, y)) continue;
      const auto any = [&](const std::vector<MarkBox>& boxes) {
        return std::any_of(boxes.begin(), boxes.end(),
                           [&](const MarkBox& box) { return box.has(m, x, y); });
      };
      return (automatic || any(enforcers)) && !any(blockers);
    }
    return false;
  }

  [[nodiscard]] bool near_an_edge(double x, double y) const {
    const auto to_cell = [](double at) {
      return std::abs(at - kCell_mm * std::round(at / kCell_mm));
    };
    const auto any = [&](const std::vector<MarkBox>& boxes) {
      return std::any_of(boxes.begin(), boxes.end(),
                         [&](const MarkBox& box) { return box.has_edge_near(x, y); });
    };
    return to_cell(x) < kEdge_mm || to_cell(y) < kEdge_mm || any(enforcers) || any(blockers);
  }
};

MarkedStack random_stack(std::uint64_t seed) {
  test::Random random(seed);
  MarkedStack stack;
  stack.layers.assign(kLayers, std::vector<bool>(kCells * kCells));
  for (auto& cells : stack.layers) {
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = random.unit() < 0.35;
  }
  const auto boxes = [&](int count) {
    std::vector<MarkBox> found;
    for (int i = 0; i < count; ++i) {
      MarkBox box;
      box.x0 = random.unit() * 9;
      box.y0 = random.unit() * 9;
      box.x1 = box.x0 + 0.5 + random.unit() * 6;
      box.y1 = box.y0 + 0.5 + random.unit() * 6;
      box.low = static_cast<std::size_t>(random.unit() * kLayers);
      box.high = box.low + static_cast<std::size_t>(random.unit() * 5);
      found.push_back(box);
    }
    return found;
  };
  stack.enforcers = boxes(3);
  stack.blockers = boxes(2);
  return stack;
}

Region region_of_boxes(const std::vector<MarkBox>& boxes, std::size_t layer) {
  Region all;
  for (const MarkBox& box : boxes) {
    if (layer < box.low || layer > box.high) continue;
    all = unite(all, test::rectangle_region(box.x0, box.y0, box.x1 - box.x0, box.y1 - box.y0));
  }
  return all;
}

Region slice_of(const MarkedStack& stack, std::size_t layer) {
  Region all;
  for (std::size_t i = 0; i < kCells * kCells; ++i) {
    if (!stack.layers[layer][i]) continue;
    all = unite(all, test::rectangle_region(static_cast<double>(i % kCells) * kCell_mm,
                                            static_cast<double>(i / kCells) * kCell_mm, kCell_mm,
                                            kCell_mm));
  }
  return all;
}

std::vector<SupportLayer> fold(const MarkedStack& stack, const Settings& settings) {
  SupportFold fold(settings);
  std::vector<SupportLayer> found(stack.layers.size());
  const auto take = [&] {
    while (auto layer = fold.next()) found[static_cast<std::size_t>(layer->index)] = *layer;
  };
  for (std::size_t n = stack.layers.size(); n-- > 0;) {
    const Length height = settings.layer_height;
    FoldSlice slice{static_cast<LayerIndex>(n), height * static_cast<std::int64_t>(n), height,
                    std::make_shared<const Region>(slice_of(stack, n))};
    slice.marks = std::make_shared<const SupportMarks>(
        SupportMarks{region_of_boxes(stack.enforcers, n), region_of_boxes(stack.blockers, n)});
    fold.push(std::move(slice));
    take();
  }
  fold.end();
  take();
  return found;
}

// A slope that rises to the right from x = 10 on, 20 mm deep.
Region ramp_slice(double angle_degrees, double z_mm) {
  return test::rectangle_region(0, 0, 10 + z_mm * std::tan(angle_degrees * std::numbers::pi / 180),
                                20);
}

// What of a layer of a ramp is to be held, with marks.
MarkedHanging on_ramp(double angle_degrees, double z_mm, bool by_itself, const SupportMarks* marks,
                      const Settings& settings) {
  const Length planes = settings.layer_height;
  return marked_hanging(ramp_slice(angle_degrees, z_mm),
                        ramp_slice(angle_degrees, z_mm - planes.mm()), planes, by_itself, marks,
                        settings);
}

}  // namespace

TEST_CASE("supports stand under what is enforced or hangs by itself, and is not blocked") {
  int held = 0, not_held = 0;
  for (std::uint64_t seed = 40; seed < 52; ++seed) {
    CAPTURE(seed);
    const MarkedStack stack = random_stack(seed);
    for (const bool automatic : {true, false}) {
      CAPTURE(automatic);
      Settings settings = bare();
      settings.support_auto = automatic;
      const std::vector<SupportLayer> found = fold(stack, settings);
      for (std::size_t n = 0; n < kLayers; ++n) {
        CAPTURE(n);
        for (double y = 0.125; y < kSide_mm; y += 0.25) {
          for (double x = 0.125; x < kSide_mm; x += 0.25) {
            if (stack.near_an_edge(x, y)) continue;
            const Point at{static_cast<std::int32_t>(x * kUnitsPerMm),
                           static_cast<std::int32_t>(y * kUnitsPerMm)};
            const bool expected = stack.held(n, x, y, automatic);
            ++(expected ? held : not_held);
            if (found[n].region->contains(at) == expected) continue;
            CAPTURE(x);
            CAPTURE(y);
            FAIL_CHECK((expected ? "not held" : "held"));
          }
        }
      }
    }
  }
  CHECK_GT(held, 10'000);
  CHECK_GT(not_held, 10'000);
}

TEST_CASE("an enforcer holds a slope of any angle, a blocker none") {
  const Settings settings;
  const double z = 4;
  const SupportMarks enforced{test::rectangle_region(0, 5, 40, 6), {}};
  const SupportMarks blocked{{}, test::rectangle_region(0, 5, 40, 6)};
  for (const double angle : {3.5, 10.0, 30.0, 44.0}) {
    CAPTURE(angle);
    CHECK(on_ramp(angle, z, true, nullptr, settings).empty());
    const double strip = settings.layer_height.mm() * std::tan(angle * std::numbers::pi / 180);
    const MarkedHanging held = on_ramp(angle, z, true, &enforced, settings);
    CHECK(held.islands.empty());
    CHECK_EQ(held.overhangs.area_mm2(), doctest::Approx(strip * 6).epsilon(0.01));
    CHECK(on_ramp(angle, z, false, &enforced, settings).overhangs == held.overhangs);
  }
  const double strip = settings.layer_height.mm() * std::tan(60 * std::numbers::pi / 180);
  CHECK_EQ(on_ramp(60, z, true, nullptr, settings).overhangs.area_mm2(),
           doctest::Approx(strip * 20).epsilon(0.01));
  CHECK_EQ(on_ramp(60, z, true, &enforced, settings).overhangs.area_mm2(),
           doctest::Approx(strip * 20).epsilon(0.01));
  CHECK_EQ(on_ramp(60, z, false, &enforced, settings).overhangs.area_mm2(),
           doctest::Approx(strip * 6).epsilon(0.01));
  CHECK_EQ(on_ramp(60, z, true, &blocked, settings).overhangs.area_mm2(),
           doctest::Approx(strip * 14).epsilon(0.01));
  CHECK(on_ramp(60, z, false, nullptr, settings).empty());
}

TEST_CASE("an island is held as far as it is enforced, and not where it is blocked") {
  Settings settings;
  const Region post = test::rectangle_region(0, 0, 5, 5);
  const Region island = test::rectangle_region(20, 0, 10, 10);
  const Region slice = unite(post, island);
  const Length planes = settings.layer_height;
  const SupportMarks left{test::rectangle_region(15, -5, 8, 30), {}};
  const SupportMarks both{left.enforced, test::rectangle_region(15, -5, 30, 10)};
  const MarkedHanging some = marked_hanging(slice, post, planes, false, &left, settings);
  CHECK_EQ(some.islands.area_mm2(), doctest::Approx(30));
  CHECK(some.overhangs.empty());
  const MarkedHanging rest = marked_hanging(slice, post, planes, true, &both, settings);
  CHECK_EQ(rest.islands.area_mm2(), doctest::Approx(50));
  const MarkedHanging corner = marked_hanging(slice, post, planes, false, &both, settings);
  CHECK_EQ(corner.islands.area_mm2(), doctest::Approx(15));
}

TEST_CASE("what is enforced is held however small it is, and nothing else that is small") {
  const Region post = test::rectangle_region(0, 0, 5, 20);
  // Two knobs of 0.36 mm².
  const Region knobs =
      unite(test::rectangle_region(5, 4, 0.6, 0.6), test::rectangle_region(5, 14, 0.6, 0.6));
  Settings settings = bare();
  settings.support_area_min_mm2 = 0.5;
  SupportFold fold(settings);
  const auto post_shared = std::make_shared<const Region>(post);
  const auto both = std::make_shared<const Region>(unite(post, knobs));
  const Length height = settings.layer_height;
  for (LayerIndex n = 9; n >= 0; --n) {
    FoldSlice slice{n, height * n, height, n == 9 ? both : post_shared};
    slice.marks =
        std::make_shared<const SupportMarks>(SupportMarks{test::rectangle_region(0, 0, 20, 8), {}});
    fold.push(std::move(slice));
  }
  fold.end();
  while (const auto layer = fold.next()) {
    if (layer->index == 9) continue;
    CAPTURE(layer->index);
    CHECK(layer->region->contains({53'000, 43'000}));
    CHECK_FALSE(layer->region->contains({53'000, 143'000}));
  }
}

TEST_CASE("between heights, what hangs is held or not, as the settings say") {
  // A shelf of one layer every ten, out of a post.
  MarkedStack stack;
  for (int n = 0; n < 50; ++n) {
    std::vector<bool> cells(kCells * kCells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::size_t shelf = static_cast<std::size_t>(n) / 10 + 1;
      cells[i] = i % kCells == 0 || (n % 10 == 9 && i % kCells == shelf);
    }
    stack.layers.push_back(std::move(cells));
  }
  Settings settings = bare();
  // Layers of 0.2 mm: the shelves' bottoms are at 1.8, 3.8 … 9.8 mm.
  const auto held = [&] {
    const std::vector<SupportLayer> found = fold(stack, settings);
    std::vector<bool> shelves;
    for (std::size_t shelf = 0; shelf < 5; ++shelf) {
      const auto x = static_cast<std::int32_t>((2 * static_cast<double>(shelf) + 3) * kUnitsPerMm);
      shelves.push_back(found[shelf * 10 + 5].region->contains({x, 60'000}));
    }
    return shelves;
  };
  using Shelves = std::vector<bool>;
  CHECK(held() == Shelves{true, true, true, true, true});
  settings.support_height_range = {"5.8-7.8 off", "0-1.8 off", "3.8 - 3.9  off"};
  CHECK(held() == Shelves{true, false, false, true, true});
  settings.support_auto = false;
  CHECK(held() == Shelves{false, false, false, false, false});
  settings.support_height_range = {"1.9-5.9 on", "9.8-100 on", "7-9 off"};
  CHECK(held() == Shelves{false, true, true, false, true});
}
