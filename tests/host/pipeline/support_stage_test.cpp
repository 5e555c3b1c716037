// Whole prints with supports: what hangs is held, and nothing else is touched.
#include "host/pipeline/support_stage.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/regions/point_location.h"
#include "core/regions/polyline.h"
#include "core/regions/segment_grid.h"
#include "host/pipeline/pipeline.h"
#include "tests/host/print_rig.h"
#include "tests/host/whole_print.h"
#include "tests/support/part_folder.h"

using core::Length;
using core::Point;
using core::Region;
using core::Road;
using core::RoadKind;
using print_test::print;
using print_test::Printed;

namespace {

using core::SupportStyle;
constexpr SupportStyle kStyles[] = {SupportStyle::kGrid, SupportStyle::kTree};

core::Settings supported(core::SupportPlace place, SupportStyle style = SupportStyle::kGrid) {
  core::Settings settings;
  settings.bed_x = settings.bed_y = Length::from_mm(80);
  settings.supports = place;
  settings.support_style = style;
  settings.arcs = core::ArcUse::kOff;
  return settings;
}

// A shelf on a post over a base, and an island that hangs from the shelf's end.
parts::Part shelf() {
  return parts::together({parts::box({2, 2, 0}, 20, 16, 2), parts::box({2, 2, 2}, 6, 16, 10),
                          parts::box({2, 2, 12}, 34, 16, 2), parts::box({30, 6, 8}, 4, 8, 4)});
}

bool is_support(const Road& road) {
  return road.kind == RoadKind::kSupport || road.kind == RoadKind::kSupportInterface;
}

double filament(const Printed& printed, RoadKind kind) {
  return printed.statistics.filament_mm[static_cast<std::size_t>(kind)];
}

std::vector<core::Segment> segments_of(const std::vector<Road>& roads, bool supports) {
  std::vector<core::Segment> segments;
  for (const Road& road : roads) {
    if (is_support(road) != supports || road.kind == RoadKind::kSkirt) continue;
    const std::size_t count = road.points.size();
    for (std::size_t i = 0; i < (road.closed ? count : count - 1); ++i) {
      segments.push_back({road.points[i], road.points[(i + 1) % count]});
    }
  }
  return segments;
}

// The longest stretch of a road of the part, in layer `n`, that neither the slice below nor a
// support under the gap holds, in mm.
double longest_in_air(const Printed& printed, std::size_t n, int gap) {
  const Length reach = Length::from_mm(0.8);
  const core::PointLocation below(printed.slices[n - 1].region);
  std::vector<core::Segment> supports;
  for (std::size_t k = n - 1; k + static_cast<std::size_t>(gap) + 1 >= n; --k) {
    for (const core::Segment& s : segments_of(printed.roads[k], true)) supports.push_back(s);
    if (k == 0) break;
  }
  const core::SegmentGrid grid(Length::from_mm(1), supports);
  double longest = 0;
  for (const Road& road : printed.roads[n]) {
    if (is_support(road)) continue;
    double air = 0;
    for (std::size_t i = 1; i < road.points.size(); ++i) {
      const double mm = core::distance_mm(road.points[i - 1], road.points[i]);
      const int steps = std::max(1, static_cast<int>(mm / 0.1));
      for (int step = 0; step < steps; ++step) {
        const Point at = core::between(road.points[i - 1], road.points[i], (step + 0.5) / steps);
        const bool held = below.contains(at) || grid.any_within(at, reach);
        air = held ? 0 : air + mm / steps;
        longest = std::max(longest, air);
      }
    }
  }
  return longest;
}

}  // namespace

TEST_CASE("with supports everywhere, nothing of the part is laid into the air") {
  const test::PartFolder folder;
  core::Settings settings = supported(core::SupportPlace::kEverywhere);
  const std::vector<std::tuple<std::string, parts::Part, SupportStyle>> all = {
      {"shelf.stl", shelf(), SupportStyle::kGrid},
      {"mushroom.stl", parts::mushroom(), SupportStyle::kGrid},
      {"shelf.stl", shelf(), SupportStyle::kTree},
      {"mushroom.stl", parts::mushroom(), SupportStyle::kTree}};
  for (const auto& each : all) {
    const std::string& name = std::get<0>(each);
    CAPTURE(name);
    settings.support_style = std::get<2>(each);
    const std::string path = folder.add(name, std::get<1>(each));
    const Printed printed = print(settings, path);
    REQUIRE(printed.error.empty());
    CHECK_GT(filament(printed, RoadKind::kSupport), 50);
    CHECK_GT(filament(printed, RoadKind::kSupportInterface), 5);
    for (std::size_t n = 1; n < printed.roads.size(); ++n) {
      CAPTURE(n);
      CHECK_LT(longest_in_air(printed, n, settings.support_top_gap_layers), 0.8);
    }
    for (std::size_t kind = 0; kind < core::kHangingKinds; ++kind) {
      CHECK_EQ(printed.statistics.hanging.of(static_cast<core::HangingKind>(kind)).count, 0);
    }
    settings.supports = core::SupportPlace::kOff;
    const Printed without = print(settings, path);
    settings.supports = core::SupportPlace::kEverywhere;
    bool any = false;
    for (std::size_t n = 1; n < without.roads.size(); ++n) any |= longest_in_air(without, n, 1) > 2;
    CHECK(any);
  }
}

TEST_CASE("supports keep their gaps and their distance, and the part's roads are the same") {
  const test::PartFolder folder;
  for (const SupportStyle style : kStyles) {
    core::Settings settings = supported(core::SupportPlace::kEverywhere, style);
    settings.support_top_gap_layers = 2;
    settings.support_bottom_gap_layers = 1;
    const std::string path = folder.add("shelf.stl", shelf());
    const Printed printed = print(settings, path);
    settings.supports = core::SupportPlace::kOff;
    const Printed without = print(settings, path);
    REQUIRE_EQ(printed.roads.size(), without.roads.size());
    for (std::size_t n = 0; n < printed.roads.size(); ++n) {
      CAPTURE(n);
      std::vector<Road> own;
      for (const Road& road : printed.roads[n]) {
        if (!is_support(road)) own.push_back(road);
      }
      // The first layer's skirt goes around the supports.
      if (n > 0) {
        REQUIRE_EQ(own.size(), without.roads[n].size());
        for (std::size_t i = 0; i < own.size(); ++i)
          CHECK(own[i].points == without.roads[n][i].points);
      }
      const Region near =
          core::offset(printed.slices[n].region, Length::from_mm(-0.19), Length::from_units(100));
      Region others;
      for (const int up : {-1, 1, 2}) {
        const auto m = static_cast<std::ptrdiff_t>(n) + up;
        if (m < 0 || m >= static_cast<std::ptrdiff_t>(printed.slices.size())) continue;
        others = core::unite(others, printed.slices[static_cast<std::size_t>(m)].region);
      }
      for (const Road& road : printed.roads[n]) {
        if (!is_support(road)) continue;
        for (std::size_t i = 0; i < road.points.size(); ++i) {
          const Point at = road.points[i];
          CHECK_FALSE(near.contains(at));
          CHECK_FALSE(others.contains(at));
        }
      }
    }
  }
}

TEST_CASE("from the bed only: nothing stands on the part, and what is not held is told") {
  const test::PartFolder folder;
  const std::string path = folder.add("shelf.stl", shelf());
  for (const SupportStyle style : kStyles) {
    const Printed printed = print(supported(core::SupportPlace::kBed, style), path);
    REQUIRE(printed.error.empty());
    CHECK_GT(filament(printed, RoadKind::kSupport), 50);
    const Region base = printed.slices[2].region;
    for (std::size_t n = 0; n < printed.roads.size(); ++n) {
      CAPTURE(n);
      // Branches lean over the base, as far as their angle lets them, and hold a little more.
      const double lean_mm =
          style == SupportStyle::kTree && n > 9 ? 0.17 * static_cast<double>(n - 9) + 1.3 : 0;
      const Region under = core::offset(base, Length::from_mm(lean_mm), Length::from_units(100));
      for (const Road& road : printed.roads[n]) {
        if (!is_support(road)) continue;
        for (const Point at : road.points) CHECK_FALSE(under.contains(at));
      }
    }
    CHECK_EQ(printed.statistics.hanging.of(core::HangingKind::kIsland).count, 0);
    if (style == SupportStyle::kTree) continue;  // they reach the bed from everywhere
    const Printed everywhere = print(supported(core::SupportPlace::kEverywhere), path);
    CHECK_LT(filament(printed, RoadKind::kSupport), filament(everywhere, RoadKind::kSupport));
  }
}

TEST_CASE("supports are the same for any number of threads, and stand on a raft") {
  const test::PartFolder folder;
  const std::string path = folder.add("mushroom.stl", parts::mushroom());
  for (const SupportStyle style : kStyles) {
    core::Settings settings = supported(core::SupportPlace::kEverywhere, style);
    settings.raft_layers = 2;
    const Printed one = print(settings, path);
    REQUIRE(one.error.empty());
    CHECK(one.texts == print(settings, path, 3).texts);
    const Region raft = one.slices.front().region;
    for (const Road& road : one.roads[2]) {
      for (const Point at : road.points) CHECK(raft.contains(at));
    }
    CHECK(std::any_of(one.roads[2].begin(), one.roads[2].end(), is_support));
  }
}

TEST_CASE("a part that leans out nowhere is printed at once, as without supports") {
  const test::PartFolder folder;
  core::Settings settings = supported(core::SupportPlace::kEverywhere);
  for (const int lookahead : {0, 10}) {
    settings.support_lookahead = lookahead;
    const std::string path = folder.add("dome.stl", parts::dome(8));
    const Printed printed = print(settings, path);
    REQUIRE(printed.error.empty());
    CHECK_EQ(printed.preparations, 0);
    CHECK_EQ(printed.statistics.spilled_bytes, 0);
    core::Settings off = settings;
    off.supports = core::SupportPlace::kOff;
    CHECK(printed.texts == print(off, path).texts);
  }
  settings.support_lookahead = 0;
  const std::string path = folder.add("shelf.stl", shelf());
  const Printed printed = print(settings, path);
  // Each layer is told twice: as it is cut, and as it is looked at from above.
  CHECK_EQ(printed.preparations, 2 * printed.slices.size());
  const host::StageClock& clock = printed.statistics.clock;
  CHECK_GT(clock.worst_layer_ms(host::Stage::kSupport), 0);
  CHECK_LE(clock.worst_layer_ms(host::Stage::kSupport),
           1e3 * clock.seconds(host::Stage::kSupport) + 1e-6);
}

TEST_CASE("with enough layers known ahead, a print is the same, and needs no spool") {
  const test::PartFolder folder;
  const std::string path = folder.add("shelf.stl", shelf());
  for (const core::SupportPlace place :
       {core::SupportPlace::kBed, core::SupportPlace::kEverywhere}) {
    core::Settings settings = supported(place);
    const Printed whole = print(settings, path);
    settings.support_lookahead = 60;
    const Printed ahead = print(settings, path, 1, "/no/such/folder");
    REQUIRE(ahead.error.empty());
    CHECK(ahead.texts == whole.texts);
    CHECK(print(settings, path, 3).texts == whole.texts);
    CHECK(ahead.warnings.empty());
    CHECK_EQ(ahead.statistics.spilled_bytes, 0);
  }
}

TEST_CASE("with too few, what can't be held is told, and no support begins in the air") {
  const test::PartFolder folder;
  const std::string path = folder.add("shelf.stl", shelf());
  core::Settings settings = supported(core::SupportPlace::kEverywhere);
  settings.support_lookahead = 10;
  const Printed printed = print(settings, path);
  REQUIRE(printed.error.empty());
  // Under the island, and under the shelf.
  REQUIRE_EQ(printed.warnings.size(), 3);
  CHECK_NE(printed.warnings[0].find("what hangs above layer 40 was not known"), std::string::npos);
  CHECK_NE(printed.warnings[0].find("support_lookahead = 50"), std::string::npos);
  CHECK_NE(printed.warnings[1].find("an island"), std::string::npos);
  CHECK_NE(printed.warnings[2].find("what hangs above layer 60 was not known"), std::string::npos);
  CHECK_GT(printed.statistics.hanging.of(core::HangingKind::kIsland).count, 0);
  for (std::size_t n = 1; n < printed.roads.size(); ++n) {
    CAPTURE(n);
    const core::PointLocation part(
        core::offset(printed.slices[n - 1].region, Length::from_mm(-0.6), Length::from_units(100)));
    const core::SegmentGrid below(Length::from_mm(1), segments_of(printed.roads[n - 1], true));
    for (const Road& road : printed.roads[n]) {
      if (!is_support(road)) continue;
      for (const Point at : road.points) {
        CHECK((part.contains(at) || below.any_within(at, Length::from_mm(1.5))));
      }
    }
  }
}

TEST_CASE("a print that is stopped while supports are sought ends in good order, whenever") {
  const test::PartFolder folder;
  const std::string path = folder.add("shelf.stl", shelf());
  print_test::check_stops(supported(core::SupportPlace::kBed), path, 140);
}

TEST_CASE("a part that begins in the air has a skirt around its supports, and a raft under them") {
  const test::PartFolder folder;
  // A crumb that no road fits into holds the part's height.
  const std::string path = folder.add(
      "high.stl",
      parts::together({parts::box({2, 2, 0}, 0.1, 0.1, 3), parts::box({5, 5, 2}, 9, 9, 1)}));
  core::Settings settings = supported(core::SupportPlace::kEverywhere);
  const Printed flat = print(settings, path);
  REQUIRE(flat.error.empty());
  REQUIRE_FALSE(flat.roads.front().empty());
  CHECK(flat.roads.front().front().kind == RoadKind::kSkirt);
  CHECK(std::any_of(flat.roads.front().begin(), flat.roads.front().end(), is_support));
  settings.raft_layers = 2;
  const Printed raised = print(settings, path);
  REQUIRE(raised.error.empty());
  CHECK(raised.slices.front().region.contains({400'000, 400'000}));
}

TEST_CASE("a spool that can't be made ends the print with its folder and a remedy") {
  const test::PartFolder folder;
  const std::string path = folder.add("shelf.stl", shelf());
  const Printed printed =
      print(supported(core::SupportPlace::kEverywhere), path, 1, "/no/such/folder");
  CHECK_NE(printed.error.find("/no/such/folder"), std::string::npos);
  CHECK_NE(printed.error.find("--spool"), std::string::npos);
  CHECK(printed.roads.empty());
  CHECK(printed.texts.empty());  // not even the heaters
}
