#include "core/motions/laid_layer.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <random>
#include <string>
#include <variant>
#include <vector>

#include "core/motions/motion_builder.h"
#include "tests/core/motions/motion_samples.h"

using namespace core;
using namespace motion_test;

namespace {

struct Described {
  std::string operator()(const Extrude& m) const {
    return fmt::format("lay {} {} {} {}", m.to.x, m.to.y, m.filament_mm, m.speed_mm_s);
  }
  std::string operator()(const ExtrudeArc& m) const {
    return fmt::format("arc {} {} {} {} {} {} {}", m.to.x, m.to.y, m.centre.x, m.centre.y,
                       m.clockwise, m.filament_mm, m.speed_mm_s);
  }
  std::string operator()(const Travel& m) const {
    return fmt::format("travel {} {} {}", m.to.x, m.to.y, m.speed_mm_s);
  }
  std::string operator()(const Wipe& m) const {
    return fmt::format("wipe {} {} {} {}", m.to.x, m.to.y, m.filament_mm, m.speed_mm_s);
  }
  std::string operator()(const MoveFilament& m) const {
    return fmt::format("filament {} {}", m.filament_mm, m.speed_mm_s);
  }
  std::string operator()(const RoadStart& m) const {
    return fmt::format("road {} {} {}", static_cast<int>(m.kind), m.width.units(), m.layers);
  }
  std::string operator()(const RoadChange& m) const {
    return fmt::format("change {} {}", static_cast<int>(m.kind), m.width.units());
  }
  std::string operator()(const SetFan& m) const { return fmt::format("fan {}", m.share); }
  std::string operator()(const Lift& m) const { return fmt::format("lift {}", m.to.units()); }
  template <typename Other>
  std::string operator()(const Other&) const {
    return "other";
  }
};

std::vector<std::string> described(const Recorder& recorder) {
  std::vector<std::string> lines;
  for (const Motion& motion : recorder.motions) {
    lines.push_back(fmt::format("{} {}", motion.index(), std::visit(Described(), motion)));
  }
  return lines;
}

std::vector<Road> any_roads(std::mt19937& random) {
  std::uniform_real_distribution<double> place(1, 49), width(0.35, 0.7);
  std::uniform_int_distribution<int> points(2, 40), kind(0, 3), one_in(0, 3);
  constexpr RoadKind kKinds[] = {RoadKind::kOuterPerimeter, RoadKind::kPerimeter, RoadKind::kBridge,
                                 RoadKind::kTopSolid};
  std::vector<Road> roads;
  for (int i = 0; i < 6; ++i) {
    Road road{kKinds[kind(random)], Length::from_mm(0.45), one_in(random) == 0, {}};
    const double x = place(random), y = place(random), r = 0.1 + place(random) / 20;
    const int count = points(random);
    for (int j = 0; j < count; ++j) {
      const double angle = 2 * M_PI * j / count;
      road.points.push_back(at_mm(x + r * std::cos(angle), y + r * std::sin(angle)));
    }
    if (one_in(random) == 0) {
      for (int j = 0; j < count; ++j) road.widths.push_back(Length::from_mm(width(random)));
    }
    if (road.points.size() < 3) road.closed = false;
    roads.push_back(road);
  }
  return roads;
}

Settings any_settings(std::mt19937& random) {
  std::bernoulli_distribution yes;
  Settings settings;
  settings.arcs = yes(random) ? ArcUse::kOn : ArcUse::kOff;
  settings.wipe = yes(random);
  settings.segment_time_min_ms = yes(random) ? 2 : 0;
  settings.at_height = {"0.3 extrusion_multiplier 1.1", "0.7 pause", "0.7 retraction_mm 2"};
  if (yes(random)) {
    settings.height_slowdown_from = Length::from_mm(0.4);
    settings.height_slowdown_to = Length::from_mm(1.1);
    settings.height_slowdown_speed = 0.5;
  }
  return settings;
}

}  // namespace

TEST_CASE("layers that were prepared give the motions of those that were not") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 40; ++round) {
    const Settings settings = any_settings(random);
    MotionBuilder in_turn(settings), prepared(settings);
    const LayerLaying laying(settings);
    Recorder expected, found;
    for (LayerIndex index = 0; index < 8; ++index) {
      const Slice slice = slice_of(index, kSquare);
      const std::vector<Road> roads = any_roads(random);
      in_turn.layer(slice, roads, expected.sink());
      Slice place = slice;
      place.region = {};  // does not count
      const LayerPace pace =
          laying.pace(place, laying.actions_below(place.bottom), settings.arcs == ArcUse::kOn);
      const LaidLayer laid = laying.lay(place, roads, pace, std::nullopt);
      REQUIRE(prepared.suits(laid, slice));
      prepared.prepared_layer(slice, laid, found.sink());
    }
    in_turn.finish(expected.sink());
    prepared.finish(found.sink());
    REQUIRE(described(found) == described(expected));
  }
}

TEST_CASE("a layer that was prepared for another place does not suit") {
  Settings settings;
  settings.at_height = {"0.3 extrusion_multiplier 1.1"};
  settings.arcs = ArcUse::kOff;
  MotionBuilder builder(settings);
  const LayerLaying& laying = builder.laying();
  const std::vector<Road> roads = {line(1, 1, 5, 1)};
  const auto laid_at = [&](LayerIndex index, bool arcs) {
    const Slice slice = slice_of(index, kSquare);
    return laying.lay(slice, roads, laying.pace(slice, laying.actions_below(slice.bottom), arcs),
                      std::nullopt);
  };
  Recorder recorder;
  builder.layer(slice_of(0, kSquare), roads, recorder.sink());
  CHECK(builder.suits(laid_at(1, false), slice_of(1, kSquare)));
  CHECK(!builder.suits(laid_at(1, true), slice_of(1, kSquare)));
  CHECK(!builder.suits(laid_at(0, false), slice_of(1, kSquare)));  // the first layer
  CHECK(!builder.suits(laid_at(3, false), slice_of(1, kSquare)));  // more flow from 0.3 mm on
  CHECK(builder.suits(laid_at(3, false), slice_of(5, kSquare)));
  CHECK(!builder.suits(LaidLayer(), slice_of(1, kSquare)));
}
