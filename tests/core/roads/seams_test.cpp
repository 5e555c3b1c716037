#include "core/roads/seams.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/limits.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/regions/polyline.h"
#include "core/trigonometry.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

const Length kWidth = Length::from_mm(0.45);

LayerRoads outer_roads(const Region& slice) {
  LayerRoads roads;
  roads.islands.emplace_back();
  const Region line = offset(slice, Length::from_mm(0.225), Length::from_units(25));
  for (const Ring& ring : line.rings()) {
    roads.islands[0].push_back({RoadKind::kOuterPerimeter, kWidth, true, ring});
  }
  return roads;
}

// A stack of slices, layer by layer as the planner sees them.
class Stack {
 public:
  explicit Stack(const std::function<Region(int)>& slice, int layers) {
    std::vector<std::shared_ptr<const CornerIndex>> corners;
    for (int i = 0; i < layers; ++i) {
      SplitLayer layer;
      layer.slice.index = i;
      layer.slice.region = slice(i);
      if (i > 0) layer.below = std::make_shared<const Region>(layers_.back().slice.region);
      corners.push_back(std::make_shared<const CornerIndex>(layer.slice.region, kCornerArm));
      layers_.push_back(std::move(layer));
    }
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      for (std::size_t k = i + 1; k < std::min(i + 5, layers_.size()); ++k) {
        layers_[i].corners_above.push_back(corners[k]);
      }
      roads_.push_back(outer_roads(layers_[i].slice.region));
      seams_.push_back(seam_loops(layers_[i], roads_[i]));
    }
  }

  [[nodiscard]] std::size_t size() const { return layers_.size(); }
  [[nodiscard]] const SplitLayer& layer(std::size_t i) const { return layers_[i]; }
  [[nodiscard]] const LayerRoads& roads(std::size_t i) const { return roads_[i]; }
  [[nodiscard]] const LayerSeams& seams(std::size_t i) const { return seams_[i]; }

  [[nodiscard]] std::vector<RingPlace> place(SeamPlacer& placer, std::size_t i) const {
    return placer.place(static_cast<LayerIndex>(i), roads_[i], seams_[i]);
  }

  // The seams of the loops around islands.
  [[nodiscard]] std::vector<Point> column(SeamPosition position) const {
    SeamPlacer placer(position);
    std::vector<Point> points;
    for (std::size_t i = 0; i < size(); ++i) {
      const std::vector<RingPlace> places = place(placer, i);
      for (std::size_t k = 0; k < places.size(); ++k) {
        if (!seams_[i].loops[k].hole) points.push_back(places[k].at);
      }
    }
    return points;
  }

 private:
  std::vector<SplitLayer> layers_;
  std::vector<LayerRoads> roads_;
  std::vector<LayerSeams> seams_;
};

double largest_step_mm(const std::vector<Point>& column) {
  double largest = 0;
  for (std::size_t i = 1; i < column.size(); ++i) {
    largest = std::max(largest, distance_mm(column[i - 1], column[i]));
  }
  return largest;
}

int jumps(const std::vector<Point>& column) {
  int count = 0;
  for (std::size_t i = 1; i < column.size(); ++i) {
    count += distance_mm(column[i - 1], column[i]) > 1 ? 1 : 0;
  }
  return count;
}

Region polygon(double radius_mm, int points, double turn) {
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double angle = turn + 2 * std::numbers::pi * i / points;
    ring.push_back({static_cast<std::int32_t>(std::lround(radius_mm * 1e4 * cosine(angle))),
                    static_cast<std::int32_t>(std::lround(radius_mm * 1e4 * sine(angle)))});
  }
  return Region::from_clean_rings({ring});
}

const char* const kL = "0:0 20:0 20:10 10:10 10:20 0:20";

}  // namespace

TEST_CASE("on a prism the seam stays at one place, in the hollow corner") {
  const Stack stack([](int) { return test::region_from_text(kL); }, 12);
  const std::vector<Point> column = stack.column(SeamPosition::kAligned);
  REQUIRE_EQ(column.size(), 12);
  for (const Point p : column) CHECK_EQ(p, column.front());
  CHECK_LT(distance_mm(column.front(), {100'000, 100'000}), 0.35);
}

TEST_CASE("on a round prism the seam stays to the unit, between its points too") {
  for (const double turn : {0.0, 0.01, 0.3}) {
    const Stack stack([turn](int) { return polygon(15, 100, turn); }, 30);
    const std::vector<Point> column = stack.column(SeamPosition::kAligned);
    for (const Point p : column) CHECK_EQ(p, column.front());
  }
}

TEST_CASE("on a cone the seam moves with the contour and no more") {
  const Stack stack([](int i) { return polygon(15 - 0.15 * i, 90, 0.002 * i); }, 60);
  CHECK_LT(largest_step_mm(stack.column(SeamPosition::kAligned)), 0.2);
}

TEST_CASE("on a twisted tower the seam follows a corner") {
  const Stack stack([](int i) { return polygon(14, 4, 0.015 * i); }, 120);
  const std::vector<Point> column = stack.column(SeamPosition::kAligned);
  CHECK_LT(largest_step_mm(column), 0.25);
  for (const Point p : column) CHECK_GT(distance_mm(p, {0, 0}), 13.5);
}

TEST_CASE("a window in a wall does not lose the seam") {
  const Region tube = test::region_from_text("0:0 30:0 30:20 0:20, 2:2 2:18 28:18 28:2");
  const auto with_window = [&](const Region& window) {
    return [&tube, window](int i) { return i >= 20 && i < 40 ? subtract(tube, window) : tube; };
  };
  const Stack elsewhere(with_window(test::region_from_text("12:-1 18:-1 18:3 12:3")), 60);
  const std::vector<Point> far = elsewhere.column(SeamPosition::kAligned);
  REQUIRE_EQ(far.size(), 60);
  // While it is open, the loop's way leads past a hollow corner inside.
  CHECK_LE(jumps(far), 2);
  CHECK_LT(distance_mm(far.front(), far.back()), 0.01);
  // Where the seam is: it leaves for the window, once, and does not wander when it closes.
  const Stack here(with_window(test::region_from_text("26:16 31:16 31:21 26:21")), 60);
  CHECK_LT(distance_mm(here.column(SeamPosition::kAligned).front(), {300'000, 200'000}), 0.4);
  CHECK_LE(jumps(here.column(SeamPosition::kAligned)), 2);
}

TEST_CASE("a loop that is gone for some layers gets its seam again") {
  // Two towers; the right one has no slice in layers 10 to 29.
  const Region both = test::region_from_text("0:0 10:0 10:10 0:10, 20:0 30:0 30:10 20:10");
  const Region left = test::region_from_text("0:0 10:0 10:10 0:10");
  const Stack stack([&](int i) { return i >= 10 && i < 30 ? left : both; }, 40);
  SeamPlacer placer(SeamPosition::kAligned);
  // Told where to begin: not where it would by itself.
  placer.resume_from({{{202'000, 2'000}, false, 0}, {{2'000, 2'000}, false, 0}});
  for (std::size_t i = 0; i < stack.size(); ++i) {
    CAPTURE(i);
    for (const RingPlace& place : stack.place(placer, i)) {
      CHECK_LT(place.at.y, 5'000);
      CHECK_LT(place.at.x % 200'000, 5'000);
    }
  }
}

TEST_CASE("a corner that lasts is taken, not one of the first layer alone") {
  const auto slice = [](int i) {
    return test::region_from_text(
        i == 0 ? "0:0 8:0 8:2 10:2 10:0 20:0 20:20 12:20 12:18 8:18 8:20 0:20"
               : "0:0 8:0 8:2 10:2 10:0 20:0 20:20 0:20");
  };
  const std::vector<Point> column = Stack(slice, 10).column(SeamPosition::kAligned);
  for (const Point p : column) CHECK_LT(p.y, 25'000);
  CHECK_LT(largest_step_mm(column), 0.1);
}

TEST_CASE("a much better corner is worth one jump, places alike none") {
  // The hollow corner begins in layer 20.
  const auto slice = [](int i) {
    return test::region_from_text(i < 20 ? "0:0 20:0 20:20 0:20" : kL);
  };
  const std::vector<Point> column = Stack(slice, 40).column(SeamPosition::kAligned);
  CHECK_LE(jumps(column), 1);
  CHECK_LT(distance_mm(column.back(), {100'000, 100'000}), 0.35);
  // A square that shrinks on one side after the other: its corners are alike.
  const auto leaning = [](int i) {
    const double a = i % 2 == 0 ? 0.05 * i : 0.05 * (i - 1);
    return polygon(14 - a * 0.1, 4, 0.1);
  };
  CHECK_EQ(jumps(Stack(leaning, 40).column(SeamPosition::kAligned)), 0);
}

TEST_CASE(
    "each seam is on its contour, and held where any place is; a resumed stack goes on alike") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<Region> slices;
    Region last = test::random_region(random, 120, 30);
    for (int i = 0; i < 12; ++i) {
      slices.push_back(last);
      Ring ring =
          test::random_blob(random, 30, random.between(5, 25), random.between(5, 25), 5, 0.5);
      const Region blob = Region::from_clean_rings({std::move(ring)});
      last = i % 2 == 0 ? subtract(last, blob) : unite(last, blob);
    }
    const Stack stack([&](int i) { return slices[static_cast<std::size_t>(i)]; }, 12);
    for (const SeamPosition position :
         {SeamPosition::kAligned, SeamPosition::kRear, SeamPosition::kRandom}) {
      SeamPlacer placer(position);
      for (std::size_t i = 0; i < stack.size(); ++i) {
        CAPTURE(i);
        SeamPlacer resumed(position);
        resumed.resume_from(placer.memory());
        const std::vector<RingPlace> places = stack.place(placer, i);
        CHECK_EQ(stack.place(resumed, i), places);
        CHECK_EQ(resumed.memory(), placer.memory());
        REQUIRE_EQ(places.size(), stack.seams(i).loops.size());
        LayerRoads started = stack.roads(i);
        set_starts(stack.seams(i), places, started);
        for (std::size_t k = 0; k < places.size(); ++k) {
          const SeamLoop& loop = stack.seams(i).loops[k];
          const Road& before = stack.roads(i).islands[loop.island][loop.road];
          const Road& road = started.islands[loop.island][loop.road];
          CHECK_EQ(road.points.front(), places[k].at);
          CHECK_LT(distance_mm(nearest_place(before.points, places[k].at).at, places[k].at), 2e-4);
          CHECK(length_mm(road) == doctest::Approx(length_mm(before)).epsilon(1e-3));
          CHECK_EQ(road.starts, (std::vector<std::uint32_t>{0}));
          if (!stack.layer(i).below) continue;
          const Region& below = *stack.layer(i).below;
          const bool any = std::any_of(before.points.begin(), before.points.end(),
                                       [&](Point p) { return below.contains(p); });
          if (any) CHECK(below.contains(places[k].at));
        }
      }
    }
  }
}

TEST_CASE("where only a stretch between two points is held, the seam is there") {
  const Region bar = test::region_from_text("10:-1 12:-1 12:21 10:21");
  const Stack stack(
      [&](int i) { return i == 0 ? bar : test::region_from_text("0:0 20:0 20:20 0:20"); }, 2);
  for (const SeamPosition position :
       {SeamPosition::kAligned, SeamPosition::kRear, SeamPosition::kRandom}) {
    CHECK(bar.contains(stack.column(position).back()));
  }
}

TEST_CASE("a place at the very edge of what holds is not held") {
  for (const double margin_mm : {0.05, 0.15}) {
    CAPTURE(margin_mm);
    SplitLayer layer;
    layer.slice.region = test::rectangle_region(0, 0, 20, 10);
    // The road's left corners lie this far inside.
    layer.below =
        std::make_shared<const Region>(test::rectangle_region(0, 0, 0.225 + margin_mm, 10));
    const LayerRoads roads = outer_roads(layer.slice.region);
    const LayerSeams seams = seam_loops(layer, roads);
    const SeamLoop& loop = seams.loops.front();
    CHECK_EQ(std::count(loop.held_points.begin(), loop.held_points.end(), true),
             margin_mm > 0.1 ? 2 : 0);
  }
}

TEST_CASE("inner perimeters start beside their outer one's seam") {
  const Stack stack([](int) { return test::region_from_text(kL); }, 1);
  LayerRoads roads = stack.roads(0);
  Road inner{RoadKind::kPerimeter, kWidth, true, {}};
  const Region line =
      offset(stack.layer(0).slice.region, Length::from_mm(0.65), Length::from_units(25));
  inner.points = line.rings().front();
  roads.islands[0].push_back(inner);
  const LayerSeams seams = seam_loops(stack.layer(0), roads);
  REQUIRE_EQ(seams.followers.size(), 1);
  SeamPlacer placer(SeamPosition::kRear);
  set_starts(seams, placer.place(0, roads, seams), roads);
  CHECK_LT(distance_mm(roads.islands[0][0].points.front(), roads.islands[0][1].points.front()),
           0.65);
}

TEST_CASE("nearest marks corners, held ones only") {
  const Region half = test::region_from_text("-1:-1 15:-1 15:21 -1:21");
  Stack stack([&](int i) { return i == 0 ? half : test::region_from_text(kL); }, 2);
  LayerRoads roads = stack.roads(1);
  SeamPlacer placer(SeamPosition::kNearest);
  const std::vector<RingPlace> places = stack.place(placer, 1);
  CHECK(places.empty());
  set_starts(stack.seams(1), places, roads);
  const Road& road = roads.islands[0][0];
  CHECK_EQ(road.starts.size(), 4);
  for (const std::uint32_t i : road.starts) CHECK(half.contains(road.points[i]));
}

TEST_CASE("no more seams are remembered than kSeamsMax, and those go on") {
  std::string text;
  for (int i = 0; i < 400; ++i) {
    const int x = i % 20 * 3, y = i / 20 * 3;
    const double side = i < 300 ? 2 : 1.5;
    text += (i > 0 ? ", " : "") + std::to_string(x) + ":" + std::to_string(y) + " " +
            std::to_string(x + side) + ":" + std::to_string(y) + " " + std::to_string(x + side) +
            ":" + std::to_string(y + side) + " " + std::to_string(x) + ":" +
            std::to_string(y + side);
  }
  const Stack stack([&](int) { return test::region_from_text(text); }, 3);
  SeamPlacer placer(SeamPosition::kAligned);
  const auto first = stack.place(placer, 0);
  CHECK_EQ(placer.memory().size(), kSeamsMax);
  CHECK_EQ(stack.place(placer, 1), first);
  CHECK_EQ(stack.place(placer, 2), first);
}
