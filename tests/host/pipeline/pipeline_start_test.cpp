// A print that is computed from the middle on: its commands are the whole print's, from there on.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "firmware_link/wire/line_codec.h"
#include "host/pipeline/pipeline.h"
#include "tests/host/print_rig.h"
#include "tests/support/marked_files.h"
#include "tests/support/part_folder.h"

using core::Length;

namespace {

struct Computed {
  std::vector<std::string> texts;
  std::vector<host::Checkpoint> checkpoints;
  std::int64_t layers_held = 0;
};

Computed compute(const core::Settings& settings, const std::string& path,
                 const std::optional<host::Checkpoint>& start, int threads = 0) {
  host::PrintPlan print_plan = print_test::open(settings, path);
  if (threads > 0) print_plan.threads = threads;
  print_plan.start = start;
  Computed computed;
  host::PipelineOutputs outputs;
  outputs.on_checkpoint = [&](const host::Checkpoint& checkpoint) {
    computed.checkpoints.push_back(checkpoint);
  };
  outputs.on_motion = [&](const core::Motion&,
                          const std::optional<firmware_link::Command>& command) {
    firmware_link::TextBuffer buffer;
    if (command) computed.texts.emplace_back(firmware_link::encode(*command, buffer));
    return true;
  };
  host::PipelineSignals signals;
  host::GeometryStatistics statistics;
  const auto end = host::run_pipeline(print_plan, outputs, signals, statistics);
  REQUIRE(end.ok());
  computed.layers_held = statistics.peak_held.layers;
  return computed;
}

core::Settings settings_of(core::WallShape shape, core::BuildStyle style) {
  core::Settings settings;
  settings.layer_height = Length::from_mm(0.3);
  settings.wall_thickness = Length::from_mm(0.9);
  settings.wall_shape = shape;
  settings.style = style;
  settings.nozzle_first_layer_celsius = 215;
  settings.retraction_lift = Length::from_mm(0.2);
  return settings;
}

// From every layer on, the first ones above all, as the whole.
void check_tails(const core::Settings& settings, const std::string& path, const Computed& whole) {
  for (std::size_t i = 0; i < whole.checkpoints.size(); i += i < 6 ? 1 : 5) {
    CAPTURE(i);
    const host::Checkpoint& start = whole.checkpoints[i];
    const Computed tail = compute(settings, path, start);
    REQUIRE_EQ(tail.texts.size() + static_cast<std::size_t>(start.commands), whole.texts.size());
    for (std::size_t k = 0; k < tail.texts.size(); ++k) {
      CAPTURE(k);
      REQUIRE_EQ(tail.texts[k], whole.texts[k + static_cast<std::size_t>(start.commands)]);
    }
    CHECK_LE(tail.layers_held, whole.layers_held);
    REQUIRE_EQ(tail.checkpoints.size(), whole.checkpoints.size() - i);
    CHECK_EQ(tail.checkpoints.back().commands, whole.checkpoints.back().commands);
  }
}

}  // namespace

TEST_CASE("from any layer on, the commands are those of the whole print") {
  const test::PartFolder folder;
  const parts::Part tower = parts::together(
      {parts::box({5, 5, 0}, 14, 12, 4), parts::box({8, 7, 0}, 6, 5, 8), parts::tube(8, 4, 6, 40)});
  const std::string path = folder.add("tower.stl", tower);
  using core::BuildStyle;
  using core::WallShape;
  const std::vector<std::pair<WallShape, BuildStyle>> walls = {
      {WallShape::kBall, BuildStyle::kThinWall},
      {WallShape::kCylinder, BuildStyle::kThinWall},
      {WallShape::kCylinder, BuildStyle::kFast},
      {WallShape::kBall, BuildStyle::kRegular}};
  for (const auto& wall : walls) {
    const auto shape = wall.first;
    const auto style = wall.second;
    CAPTURE(static_cast<int>(shape));
    CAPTURE(static_cast<int>(style));
    const core::Settings settings = settings_of(shape, style);
    const Computed whole = compute(settings, path, {});
    REQUIRE_GT(whole.checkpoints.size(), 20);
    CHECK_EQ(whole.checkpoints.front().commands, 0);
    check_tails(settings, path, whole);
  }
}

TEST_CASE("what bridges ask of the layer below is known, too") {
  const test::PartFolder folder;
  // Slabs on posts, just so thick that there is a layer or a few of loose inside: its roof spans
  // what the slab's underside leaves.
  std::vector<parts::Part> all;
  double z = 0;
  for (const double thickness : {1.8, 2.0, 2.2, 2.4}) {
    all.push_back(parts::box({8, 8, z}, 6, 6, 1));
    all.push_back(parts::box({0, 0, z + 1}, 24, 24, thickness));
    z += 1 + thickness;
  }
  const std::string path = folder.add("slabs.stl", parts::together(std::move(all)));
  for (const core::WallShape shape : {core::WallShape::kBall, core::WallShape::kCylinder}) {
    CAPTURE(static_cast<int>(shape));
    core::Settings settings = settings_of(shape, core::BuildStyle::kThinWall);
    settings.layer_height = Length::from_mm(0.2);
    settings.wall_thickness = Length::from_mm(0.8);
    settings.default_acceleration_mm_s2 = 1'000;
    settings.bridge_acceleration_mm_s2 = 600;
    settings.outer_perimeter_acceleration_mm_s2 = 800;
    settings.first_layer_acceleration_mm_s2 = 500;
    settings.height_slowdown_from = Length::from_mm(1);
    settings.height_slowdown_to = Length::from_mm(7);
    settings.height_slowdown_speed = 0.5;
    settings.height_slowdown_acceleration = 0.25;
    settings.pressure_advance_s = 0.04;
    check_tails(settings, path, compute(settings, path, {}));
  }
}

TEST_CASE("where seams move from layer to layer, they go on as in the whole print") {
  const test::PartFolder folder;
  // Leaning lobes, a dome, and a tower that begins and ends beside them.
  const parts::Part part = parts::together(
      {parts::tower(parts::TowerSize{54, 16, 1}), parts::dome(7), parts::box({30, 0, 0}, 6, 6, 3)});
  const std::string path = folder.add("moving.stl", part);
  for (const core::SeamPosition seam : {core::SeamPosition::kAligned, core::SeamPosition::kNearest,
                                        core::SeamPosition::kRear, core::SeamPosition::kRandom}) {
    CAPTURE(static_cast<int>(seam));
    core::Settings settings = settings_of(core::WallShape::kBall, core::BuildStyle::kThinWall);
    settings.seam = seam;
    const Computed whole = compute(settings, path, {});
    REQUIRE_GT(whole.checkpoints.size(), 20);
    CHECK_EQ(whole.checkpoints[9].seams.empty(), seam != core::SeamPosition::kAligned);
    check_tails(settings, path, whole);
  }
}

TEST_CASE("where the inside is laid once in three layers and the surface is rough, too") {
  const test::PartFolder folder;
  const parts::Part tower = parts::together(
      {parts::box({5, 5, 0}, 14, 12, 4), parts::box({8, 7, 0}, 6, 5, 6), parts::dome(7)});
  const std::string path = folder.add("tower.stl", tower);
  core::Settings settings = settings_of(core::WallShape::kBall, core::BuildStyle::kThinWall);
  settings.layer_height = Length::from_mm(0.13);
  settings.wall_thickness = Length::from_mm(0.52);
  settings.loose_every_layers = 3;
  settings.fuzzy_skin = core::FuzzySkin::kAll;
  check_tails(settings, path, compute(settings, path, {}));
}

TEST_CASE("ways around holes and wipes are those of the whole print, too") {
  const test::PartFolder folder;
  const parts::Part part =
      parts::together({parts::tube(8, 4, 6, 40), parts::box({20, 0, 0}, 10, 4, 5), parts::dome(7)});
  const std::string path = folder.add("holes.stl", part);
  core::Settings settings = settings_of(core::WallShape::kBall, core::BuildStyle::kThinWall);
  settings.wipe = true;
  settings.avoid_crossing_perimeters = true;
  settings.only_retract_when_crossing_perimeters = true;
  const Computed whole = compute(settings, path, {});
  REQUIRE_GT(whole.checkpoints.size(), 15);
  const auto wipes = [](const std::string& text) {
    return text.find('X') != std::string::npos && text.find("E-") != std::string::npos;
  };
  CHECK_GT(std::count_if(whole.texts.begin(), whole.texts.end(), wipes), 50);
  check_tails(settings, path, whole);
}

TEST_CASE("the turns of a spiral vase go on as in the whole print") {
  const test::PartFolder folder;
  const std::string path = folder.add("dome.stl", parts::dome(7));
  core::Settings settings = settings_of(core::WallShape::kBall, core::BuildStyle::kThinWall);
  settings.spiral_vase = true;
  settings.wipe = true;
  const Computed whole = compute(settings, path, {});
  REQUIRE_GT(whole.checkpoints.size(), 15);
  check_tails(settings, path, whole);
}

TEST_CASE("where layers differ in height, too") {
  const test::PartFolder folder;
  const parts::Part tower =
      parts::together({parts::box({5, 5, 0}, 10, 8, 2.6), parts::box({8, 7, 0}, 5, 4, 4.6),
                       parts::dome(4, 32, 16)});
  const std::string path = folder.add("tower.stl", tower);
  for (const bool blocks : {false, true}) {
    CAPTURE(blocks);
    core::Settings settings = settings_of(core::WallShape::kBall, core::BuildStyle::kThinWall);
    settings.layer_height = Length::from_mm(0.2);
    settings.first_layer_height = Length::from_mm(0.25);
    settings.adaptive_layer_height = !blocks;
    settings.cusp_height = Length::from_mm(0.1);
    settings.height_range = {"1.33-2 0.1", "4-4.4 0.15"};
    if (blocks) settings.loose_every_layers = 2;
    const Computed whole = compute(settings, path, {});
    REQUIRE_GT(whole.checkpoints.size(), 20);
    check_tails(settings, path, whole);
  }
}

TEST_CASE("on a raft, from any of its layers and of the part's") {
  const test::PartFolder folder;
  const std::string path = folder.add(
      "part.stl", parts::together({parts::box({5, 5, 0}, 14, 12, 3), parts::tube(6, 3, 4, 40)}));
  for (const int raft : {1, 3}) {
    CAPTURE(raft);
    core::Settings settings = settings_of(core::WallShape::kBall, core::BuildStyle::kThinWall);
    settings.raft_layers = raft;
    settings.first_layer_height = Length::from_mm(0.35);
    settings.avoid_crossing_perimeters = true;
    settings.wipe = true;
    const Computed whole = compute(settings, path, {});
    REQUIRE_GT(whole.checkpoints.size(), 12);
    CHECK_EQ(whole.checkpoints[1].layer, 1);
    check_tails(settings, path, whole);
  }
}

TEST_CASE("supports go on, too: those from the bed depend on all layers below") {
  const test::PartFolder folder;
  const parts::Part part =
      parts::together({parts::box({5, 5, 0}, 4, 12, 6), parts::box({5, 5, 6}, 16, 12, 1),
                       parts::box({12, 8, 0}, 3, 4, 2)});
  const std::string path = folder.add("shelf.stl", part);
  for (const core::SupportPlace place :
       {core::SupportPlace::kBed, core::SupportPlace::kEverywhere}) {
    CAPTURE(static_cast<int>(place));
    core::Settings settings = settings_of(core::WallShape::kBall, core::BuildStyle::kThinWall);
    settings.supports = place;
    check_tails(settings, path, compute(settings, path, {}));
    settings.support_lookahead = 8;
    check_tails(settings, path, compute(settings, path, {}));
    settings.support_lookahead = 0;
    settings.support_style = core::SupportStyle::kTree;
    check_tails(settings, path, compute(settings, path, {}));
  }
}

TEST_CASE("what is marked and between which heights is held, too") {
  const test::PartFolder folder;
  const std::string path = folder.add_text(
      "part.3mf",
      test::prusa_threemf({{parts::ramp(50, 5), "ModelPart",
                            [](std::int64_t facet) { return facet % 2 == 0 ? "8002" : ""; }},
                           {parts::box({0, 4, 3}, 30, 5, 9), "SupportEnforcer"},
                           {parts::box({0, 12, -1}, 30, 3, 5), "SupportBlocker"}}));
  core::Settings settings = settings_of(core::WallShape::kBall, core::BuildStyle::kThinWall);
  settings.supports = core::SupportPlace::kEverywhere;
  settings.support_height_range = {"4-5 off"};
  check_tails(settings, path, compute(settings, path, {}));
}

TEST_CASE("an inside that holds up its own roof is known from any layer on") {
  const test::PartFolder folder;
  const parts::Part part = parts::together({parts::box({20, 5, 0}, 24, 12, 4), parts::dome(8)});
  const std::string path = folder.add("hollow.stl", part);
  core::Settings settings = settings_of(core::WallShape::kBall, core::BuildStyle::kThinWall);
  settings.raft_layers = 1;
  for (const bool branches : {false, true}) {
    CAPTURE(branches);
    settings.loose_roof = branches ? core::LooseRoof::kOff : core::LooseRoof::kCone;
    settings.loose_density = 0;
    if (branches) settings.loose_pattern = core::LoosePattern::kLightning;
    check_tails(settings, path, compute(settings, path, {}));
  }
}

TEST_CASE("modifiers hold from any layer on, through the spools, and for any number of threads") {
  const test::PartFolder folder;
  const auto block = [](double x, double y, double z, double width, double depth, double height) {
    return parts::box({x, y, z}, width, depth, height);
  };
  const std::string path = folder.add_text(
      "block.3mf",
      test::prusa_threemf(
          {{parts::together({block(0, 0, 0, 20, 16, 7), block(0, 0, 7, 26, 16, 2)}), "ModelPart"},
           {block(10, -5, 2, 30, 30, 3), "ParameterModifier", {}, {{"fill_density", "60%"}}},
           {block(-5, 8, 3, 30, 30, 2),
            "ParameterModifier",
            {},
            {{"fill_pattern", "gyroid"},
             {"fill_density", "35%"},
             {"perimeters", "4"},
             {"external_perimeter_speed", "24"}}}}));
  core::Settings plain = settings_of(core::WallShape::kBall, core::BuildStyle::kThinWall);
  core::Settings supported = plain, coned = plain, thick = plain;
  supported.supports = core::SupportPlace::kEverywhere;
  coned.loose_roof = core::LooseRoof::kCone;
  thick.layer_height = Length::from_mm(0.15);
  thick.loose_every_layers = 2;
  const std::string without = folder.add(
      "without.stl", parts::together({block(0, 0, 0, 20, 16, 7), block(0, 0, 7, 26, 16, 2)}));
  for (const core::Settings& settings : {plain, supported, coned, thick}) {
    const Computed whole = compute(settings, path, {}, 1);
    CHECK(whole.texts != compute(settings, without, {}, 1).texts);
    for (const int threads : {2, 3})
      CHECK(compute(settings, path, {}, threads).texts == whole.texts);
    check_tails(settings, path, whole);
  }
}
