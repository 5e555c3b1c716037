// Whole prints whose inside holds up its own roof.
#include "host/pipeline/inside_stage.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/regions/polyline.h"
#include "core/roads/road.h"
#include "host/pipeline/pipeline.h"
#include "tests/host/print_rig.h"
#include "tests/host/whole_print.h"
#include "tests/support/part_folder.h"

using core::Length;
using core::Point;
using core::Road;
using core::RoadKind;
using print_test::print;
using print_test::Printed;

namespace {

core::Settings hollow() {
  core::Settings settings;
  settings.bed_x = settings.bed_y = Length::from_mm(80);
  settings.loose_roof = core::LooseRoof::kCone;
  settings.loose_density = 0;
  settings.arcs = core::ArcUse::kOff;
  return settings;
}

// A box with a wide flat roof, and a dome beside it.
parts::Part box_and_dome() {
  return parts::together({parts::box({26, 2, 0}, 26, 16, 6), parts::dome(10)});
}

double filament(const Printed& printed, RoadKind kind) {
  return printed.statistics.filament_mm[static_cast<std::size_t>(kind)];
}

// Where beads lie, as cells.
class Beads {
 public:
  explicit Beads(const std::vector<Road>& roads) : cells_(kSide * kSide) {
    for (const Road& road : roads) {
      if (road.kind != RoadKind::kSkirt) add(road);
    }
  }

  [[nodiscard]] bool at(Point point) const {
    const int x = cell(point.x), y = cell(point.y);
    return x >= 0 && y >= 0 && x < kSide && y < kSide && cells_[index(x, y)];
  }

 private:
  static constexpr int kSide = 1'600;  // of 0.05 mm
  static constexpr int kCell = 500;
  static int cell(std::int32_t units) { return units / kCell; }
  static std::size_t index(int x, int y) {
    return static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x);
  }

  void add(const Road& road) {
    const std::size_t count = road.points.size();
    for (std::size_t i = 0; i < (road.closed ? count : count - 1); ++i) {
      const Point from = road.points[i], to = road.points[(i + 1) % count];
      const double half = core::width_at(road, i).mm() / 2;
      const int steps = std::max(1, static_cast<int>(core::distance_mm(from, to) / 0.05));
      for (int step = 0; step <= steps; ++step) {
        disc(core::between(from, to, static_cast<double>(step) / steps), half);
      }
    }
  }

  void disc(Point centre, double radius_mm) {
    const int reach = static_cast<int>(radius_mm / 0.05) + 1;
    const int x = cell(centre.x), y = cell(centre.y);
    for (int v = std::max(0, y - reach); v <= std::min(kSide - 1, y + reach); ++v) {
      for (int u = std::max(0, x - reach); u <= std::min(kSide - 1, x + reach); ++u) {
        const Point at{u * kCell + kCell / 2, v * kCell + kCell / 2};
        if (core::distance_mm(at, centre) <= radius_mm) cells_[index(u, v)] = true;
      }
    }
  }

  std::vector<bool> cells_;
};

// The longest stretch of a dense road whose middle no bead of the layer below holds; and the
// longest one that begins or ends a road. Gap fill has a test of its own (hollow_ends_test); where
// the wall begins to get thicker, its first thin road hangs beside a perimeter.
struct InAir {
  double longest = 0;
  double longest_open = 0;
};

InAir in_air(const std::vector<Road>& roads, const std::vector<Road>& below) {
  const Beads beads(below);
  InAir found;
  for (const Road& road : roads) {
    if (road.kind == RoadKind::kSkirt || road.kind == RoadKind::kGapFill) continue;
    double air = 0;
    bool open = !road.closed;
    const std::size_t count = road.points.size();
    for (std::size_t i = 0; i < (road.closed ? count : count - 1); ++i) {
      const Point from = road.points[i], to = road.points[(i + 1) % count];
      const double mm = core::distance_mm(from, to);
      const int steps = std::max(1, static_cast<int>(mm / 0.05));
      for (int step = 0; step < steps; ++step) {
        const bool held = beads.at(core::between(from, to, (step + 0.5) / steps));
        air = held ? 0 : air + mm / steps;
        if (held) open = false;
        found.longest = std::max(found.longest, air);
        if (open) found.longest_open = std::max(found.longest_open, air);
      }
    }
    if (!road.closed) found.longest_open = std::max(found.longest_open, air);
  }
  return found;
}

}  // namespace

TEST_CASE("over an empty inside every road is held, none farther than bridge_max apart") {
  const test::PartFolder folder;
  const std::string path = folder.add("part.stl", box_and_dome());
  core::Settings settings = hollow();
  const Printed printed = print(settings, path);
  REQUIRE(printed.error.empty());
  CHECK_EQ(filament(printed, RoadKind::kLoose), 0);
  CHECK_GT(filament(printed, RoadKind::kInternalBridge), 5);
  for (std::size_t n = 1; n < printed.roads.size(); ++n) {
    CAPTURE(n);
    const InAir found = in_air(printed.roads[n], printed.roads[n - 1]);
    CHECK_LE(found.longest, settings.bridge_max.mm());
    CHECK_LE(found.longest_open, 0.8);
  }
  settings.loose_roof = core::LooseRoof::kOff;
  const Printed without = print(settings, path);
  double longest = 0;
  for (std::size_t n = 1; n < without.roads.size(); ++n) {
    longest = std::max(longest, in_air(without.roads[n], without.roads[n - 1]).longest);
  }
  CHECK_GT(longest, 2 * settings.bridge_max.mm());
}

TEST_CASE("with branches every road over the inside is held at both ends, and little is laid") {
  const test::PartFolder folder;
  const std::string path = folder.add("part.stl", box_and_dome());
  core::Settings settings = hollow();
  settings.loose_roof = core::LooseRoof::kOff;
  settings.loose_pattern = core::LoosePattern::kLightning;
  const Printed printed = print(settings, path);
  REQUIRE(printed.error.empty());
  CHECK_GT(filament(printed, RoadKind::kLoose), 5);
  for (std::size_t n = 1; n < printed.roads.size(); ++n) {
    CAPTURE(n);
    const InAir found = in_air(printed.roads[n], printed.roads[n - 1]);
    CHECK_LE(found.longest, settings.bridge_max.mm());
    CHECK_LE(found.longest_open, 0.8);
  }
  CHECK(printed.texts == print(settings, path, 5).texts);
  settings.loose_pattern = core::LoosePattern::kLines;
  settings.loose_density = 0.2;
  const Printed lines = print(settings, path);
  CHECK_LT(filament(printed, RoadKind::kLoose), 0.5 * filament(lines, RoadKind::kLoose));
}

TEST_CASE("loose becomes solid, never the reverse, and what stays loose is filled as before") {
  const test::PartFolder folder;
  const std::string path = folder.add("part.stl", box_and_dome());
  core::Settings settings = hollow();
  settings.loose_density = 0.2;
  const Printed cone = print(settings, path);
  settings.loose_roof = core::LooseRoof::kOff;
  const Printed off = print(settings, path);
  REQUIRE_EQ(cone.roads.size(), off.roads.size());
  for (const RoadKind kind : {RoadKind::kOuterPerimeter, RoadKind::kPerimeter}) {
    CHECK_EQ(filament(cone, kind), filament(off, kind));
  }
  CHECK_LT(filament(cone, RoadKind::kLoose), 0.95 * filament(off, RoadKind::kLoose));
  CHECK_GT(filament(cone, RoadKind::kLoose), 0.3 * filament(off, RoadKind::kLoose));
  CHECK_GT(filament(cone, RoadKind::kSolid), filament(off, RoadKind::kSolid));
}

TEST_CASE("the same commands for any number of threads, with supports, on a raft, in blocks") {
  const test::PartFolder folder;
  const std::string path = folder.add(
      "part.stl", parts::together({parts::box({26, 2, 0}, 20, 14, 4), parts::mushroom()}));
  core::Settings settings = hollow();
  settings.supports = core::SupportPlace::kEverywhere;
  settings.raft_layers = 2;
  settings.layer_height = Length::from_mm(0.15);
  settings.loose_density = 0.15;
  settings.loose_every_layers = 2;
  const Printed one = print(settings, path);
  REQUIRE(one.error.empty());
  CHECK_GT(filament(one, RoadKind::kSupport), 10);
  CHECK_GT(one.statistics.spilled_bytes, 0);
  CHECK_GT(one.statistics.peak_held.layers, 5);
  for (const int threads : {2, 5}) CHECK(one.texts == print(settings, path, threads).texts);
}

TEST_CASE("a print that is stopped while the inside is sought ends in good order, whenever") {
  const test::PartFolder folder;
  const std::string path = folder.add("part.stl", parts::box({2, 2, 0}, 16, 16, 6));
  print_test::check_stops(hollow(), path, 65);
}

TEST_CASE("an inside's spool that can't be made ends the print with its folder and a remedy") {
  const test::PartFolder folder;
  const std::string path = folder.add("box.stl", parts::box({2, 2, 0}, 16, 16, 6));
  const Printed printed = print(hollow(), path, 1, "/no/such/folder");
  CHECK_NE(printed.error.find("/no/such/folder"), std::string::npos);
  CHECK_NE(printed.error.find("--spool"), std::string::npos);
  CHECK(printed.texts.empty());
}
