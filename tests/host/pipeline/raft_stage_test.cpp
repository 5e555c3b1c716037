// Whole prints on a raft: the part is the one that would lie on the bed, lifted, and counted on.
#include "host/pipeline/raft_stage.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/raft_heights.h"
#include "host/pipeline/pipeline.h"
#include "host/system/exit_codes.h"
#include "tests/host/print_rig.h"
#include "tests/host/whole_print.h"
#include "tests/support/part_folder.h"

using core::Length;

namespace {

using print_test::print;
using print_test::Printed;

core::Settings on_raft(int layers) {
  core::Settings settings;
  settings.bed_x = settings.bed_y = Length::from_mm(60);
  settings.raft_layers = layers;
  settings.raft_contact_distance = Length::from_mm(0.15);
  settings.first_layer_height = Length::from_mm(0.3);
  settings.first_layer_width = Length::from_mm(0.6);
  settings.first_layer_flow = 1.1;
  settings.first_layer_speed_mm_s = 17;
  settings.layer_time_min_s = 0;
  settings.elephant_foot_compensation = Length::from_mm(0.2);
  settings.nozzle_first_layer_celsius = 222;
  settings.bed_first_layer_celsius = 66;
  settings.arcs = core::ArcUse::kOff;
  return settings;
}

parts::Part stepped() {
  return parts::together(
      {parts::box({5, 5, 0}, 14, 12, 2), parts::box({8, 7, 0}, 6, 5, 4), parts::tube(3, 2, 3, 24)});
}

bool same(const core::Road& a, const core::Road& b) {
  return a.kind == b.kind && a.width == b.width && a.closed == b.closed && a.points == b.points &&
         a.widths == b.widths && a.holds == b.holds && a.layers == b.layers;
}

double fastest_mm_s(const std::vector<core::Motion>& motions) {
  double fastest = 0;
  for (const core::Motion& motion : motions) {
    if (const auto* laid = std::get_if<core::Extrude>(&motion)) {
      fastest = std::max(fastest, laid->speed_mm_s);
    }
  }
  return fastest;
}

template <typename Kind>
std::vector<Kind> of_kind(const std::vector<core::Motion>& motions) {
  std::vector<Kind> found;
  for (const core::Motion& motion : motions) {
    if (const auto* one = std::get_if<Kind>(&motion)) found.push_back(*one);
  }
  return found;
}

}  // namespace

TEST_CASE("the part on a raft is the part without a first layer of its own, lifted") {
  const test::PartFolder folder;
  const std::string path = folder.add("stepped.stl", stepped());
  enum class Way { kPlain, kVase, kHeights };
  for (const auto& asked :
       {std::pair(1, Way::kPlain), {3, Way::kPlain}, {2, Way::kVase}, {2, Way::kHeights}}) {
    const int layers = asked.first;
    CAPTURE(layers);
    core::Settings settings = on_raft(layers);
    settings.spiral_vase = asked.second == Way::kVase;
    settings.adaptive_layer_height = asked.second == Way::kHeights;
    if (settings.adaptive_layer_height) settings.height_range = {"1-1.5 0.1"};
    core::Settings plain = settings;
    plain.raft_layers = 0;
    plain.first_layer_height = plain.first_layer_width = Length();
    plain.elephant_foot_compensation = Length();
    plain.skirt_loops = 0;
    const Printed lifted = print(settings, path), flat = print(plain, path);
    REQUIRE(lifted.error.empty());
    REQUIRE(flat.error.empty());
    const auto raft = static_cast<std::size_t>(layers);
    REQUIRE_EQ(lifted.roads.size(), flat.roads.size() + raft);
    const double lift_mm = 0.3 + 0.2 * (layers - 1) + 0.15;
    for (std::size_t i = 0; i < lifted.roads.size(); ++i) {
      CAPTURE(i);
      CHECK_EQ(lifted.slices[i].index, static_cast<core::LayerIndex>(i));
      CHECK_EQ(lifted.layers[i].index, static_cast<core::LayerIndex>(i));
      CHECK_EQ(lifted.layers[i].top, lifted.slices[i].top());
      if (i < raft) {
        CHECK_EQ(lifted.slices[i].top().mm(), doctest::Approx(0.3 + 0.2 * static_cast<double>(i)));
        continue;
      }
      const std::size_t own = i - raft;
      CHECK(lifted.slices[i].region == flat.slices[own].region);
      CHECK_EQ(lifted.slices[i].height, flat.slices[own].height);
      CHECK_EQ(lifted.slices[i].bottom.mm(),
               doctest::Approx(flat.slices[own].bottom.mm() + lift_mm));
      REQUIRE_EQ(lifted.roads[i].size(), flat.roads[own].size());
      CHECK(std::equal(lifted.roads[i].begin(), lifted.roads[i].end(), flat.roads[own].begin(),
                       same));
    }
    CHECK_EQ(lifted.layers_told, static_cast<core::LayerIndex>(lifted.roads.size()));
    CHECK_EQ(lifted.statistics.layers, static_cast<std::int64_t>(lifted.roads.size()));
    CHECK_GT(lifted.statistics.filament_mm[static_cast<std::size_t>(core::RoadKind::kRaft)], 20);
  }
}

TEST_CASE("the first layer's speed, heat and flow are the raft's; the part's first one is slow") {
  const test::PartFolder folder;
  const std::string path = folder.add("stepped.stl", stepped());
  core::Settings settings = on_raft(3);
  settings.fan_from_layer = 3;
  const Printed printed = print(settings, path);
  REQUIRE(printed.error.empty());
  CHECK_EQ(fastest_mm_s(printed.motions[0]), doctest::Approx(17));
  CHECK_EQ(fastest_mm_s(printed.motions[1]), doctest::Approx(60));
  CHECK_EQ(fastest_mm_s(printed.motions[2]), doctest::Approx(60));
  CHECK_EQ(fastest_mm_s(printed.motions[3]), doctest::Approx(17));
  CHECK_EQ(fastest_mm_s(printed.motions[4]), doctest::Approx(60));
  CHECK(of_kind<core::SetNozzleTemperature>(printed.motions[0]).empty());
  REQUIRE_EQ(of_kind<core::SetNozzleTemperature>(printed.motions[1]).size(), 1);
  CHECK_EQ(of_kind<core::SetNozzleTemperature>(printed.motions[1])[0].celsius, 210);
  REQUIRE_EQ(of_kind<core::SetBedTemperature>(printed.motions[1]).size(), 1);
  // The fan counts the raft's layers.
  CHECK(of_kind<core::SetFan>(printed.motions[1]).empty());
  CHECK_EQ(of_kind<core::SetFan>(printed.motions[2]).size(), 1);
  // Each layer's nozzle is at the layer's top, the part's first one over the gap.
  for (std::size_t i = 0; i < printed.motions.size(); ++i) {
    const auto lifts = of_kind<core::Lift>(printed.motions[i]);
    REQUIRE_FALSE(lifts.empty());
    const bool last = i + 1 == printed.motions.size();  // ends in parking
    CHECK_EQ((last ? lifts.front() : lifts.back()).to, printed.layers[i].top);
  }
  CHECK_EQ(printed.layers[3].top.mm(), doctest::Approx(0.3 + 0.4 + 0.15 + 0.2));
}

TEST_CASE("the same commands for any number of threads, and none of a raft without one") {
  const test::PartFolder folder;
  const std::string path = folder.add("stepped.stl", stepped());
  const Printed one = print(on_raft(4), path);
  REQUIRE_GT(one.texts.size(), 500);
  for (const int threads : {2, 5}) CHECK(print(on_raft(4), path, threads).texts == one.texts);
  core::Settings none = on_raft(0);
  none.raft_expansion = Length::from_mm(9);
  none.raft_contact_distance = Length::from_mm(1);
  none.raft_first_layer_density = 0.5;
  CHECK(print(none, path).texts == print(on_raft(0), path).texts);
}

TEST_CASE("heights at which something is done count from the bed") {
  const test::PartFolder folder;
  const std::string path = folder.add("stepped.stl", stepped());
  core::Settings settings = on_raft(3);
  settings.at_height = {"0.4 nozzle_celsius 199", "0.8 pause"};
  const Printed printed = print(settings, path);
  REQUIRE(printed.error.empty());
  REQUIRE_EQ(of_kind<core::SetNozzleTemperature>(printed.motions[2]).size(), 1);
  CHECK_EQ(of_kind<core::SetNozzleTemperature>(printed.motions[2])[0].celsius, 199);
  for (std::size_t i = 0; i < printed.motions.size(); ++i) {
    CHECK_EQ(of_kind<core::Pause>(printed.motions[i]).size(), i == 3 ? 1 : 0);
  }
}

TEST_CASE("a raft that leaves the bed or the axis is refused") {
  const test::PartFolder folder;
  const std::string path = folder.add("box.stl", parts::box({0, 0, 0}, 10, 8, 2));
  core::Settings settings = on_raft(2);
  settings.bed_x = Length::from_mm(12);
  settings.skirt_loops = 0;
  Printed printed = print(settings, path);
  CHECK_NE(printed.error.find("the raft at"), std::string::npos);
  CHECK_NE(printed.error.find("raft_expansion"), std::string::npos);
  CHECK(printed.texts.empty());
  settings = on_raft(2);
  settings.axis_z = Length::from_mm(2 + 0.3 + 0.2 + 0.15);
  CHECK_EQ(print(settings, path).error, "");
  settings.axis_z = Length::from_mm(2 + 0.3 + 0.2 + 0.14);
  printed = print(settings, path);
  CHECK_NE(printed.error.find("axis above the raft"), std::string::npos);
}

TEST_CASE("a raft with no room for a road is refused before anything is laid") {
  const test::PartFolder folder;
  const std::string path = folder.add(
      "tip.stl",
      parts::together({parts::box({0, 0, 0}, 0.1, 0.1, 0.3), parts::box({-2, -2, 0.3}, 4, 4, 2)}));
  core::Settings settings = on_raft(2);
  settings.raft_expansion = Length();
  settings.skirt_loops = 0;
  const Printed printed = print(settings, path);
  CHECK_NE(printed.error.find("too narrow for a road of a raft"), std::string::npos);
  CHECK(printed.texts.empty());
  settings.raft_expansion = Length::from_mm(1);
  CHECK_EQ(print(settings, path).error, "");
}

TEST_CASE("a file of layers gets a raft, but not one under an empty layer") {
  const test::PartFolder folder;
  const auto cli = [&](const std::string& name, bool begins_empty) {
    std::string text = "$$HEADERSTART\n$$ASCII\n$$UNITS/1\n$$HEADEREND\n$$GEOMETRYSTART\n";
    for (int i = 1; i <= 6; ++i) {
      text += "$$LAYER/" + std::to_string(i * 0.25) + "\n";
      // An empty layer at the start is the height at which the next one begins.
      if (i <= 2 && begins_empty) continue;
      text += "$$POLYLINE/1,1,5,10,10,22,10,22,20,10,20,10,10\n";
    }
    return folder.add_text(name, text + "$$GEOMETRYEND\n");
  };
  const Printed printed = print(on_raft(2), cli("part.cli", false));
  CHECK_EQ(printed.error, "");
  REQUIRE_EQ(printed.layers.size(), 8);
  CHECK_EQ(printed.layers[1].top.mm(), doctest::Approx(0.5));
  CHECK_EQ(printed.layers[2].top.mm(), doctest::Approx(0.5 + 0.15 + 0.25));
  const Printed refused = print(on_raft(2), cli("empty.cli", true));
  CHECK_NE(refused.error.find("no raft can be laid"), std::string::npos);
  CHECK(refused.texts.empty());
}

TEST_CASE("a raft is printed as it is sliced") {
  const test::PartFolder folder;
  const std::string path = folder.add("box.stl", parts::box({0, 0, 0}, 10, 8, 1));
  core::Settings settings = on_raft(2);
  settings.start_gcode = {"G28"};
  const std::vector<std::string> sliced = print_test::given_lines(settings, path);
  print_test::Rig rig(settings, path);
  const host::PrintOutcome outcome = rig.print();
  CHECK_EQ(outcome.exit_code, host::kExitDone);
  CHECK_EQ(outcome.geometry.layers, 7);
  const auto first = std::find(rig.executed.begin(), rig.executed.end(), sliced.front());
  CHECK((std::vector<std::string>(first, rig.executed.end()) == sliced));
}
