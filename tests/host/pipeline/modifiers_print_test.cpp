// Prints of 3MF files with modifiers, as PrusaSlicer and OrcaSlicer write them: what is laid within
// a modifier, and what outside; and that modifiers which change nothing leave no trace.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "core/regions/polyline.h"
#include "firmware_link/wire/line_codec.h"
#include "host/pipeline/pipeline.h"
#include "tests/host/print_rig.h"
#include "tests/support/marked_files.h"
#include "tests/support/part_folder.h"

using core::RoadKind;
using core::Settings;
using test::MarkedBody;
using test::PartFolder;

namespace {

struct LaidMove {
  core::LayerIndex layer = 0;
  RoadKind kind = RoadKind::kSkirt;
  core::Point from, to;
  double speed_mm_s = 0, filament_mm = 0;
};

struct Print {
  std::vector<LaidMove> moves;
  std::vector<std::string> commands;
};

Print print(const Settings& settings, const std::string& path, int threads = 2) {
  host::PrintPlan print_plan = print_test::open(settings, path);
  print_plan.threads = threads;
  Print done;
  LaidMove now;
  host::PipelineOutputs outputs;
  outputs.on_motion = [&](const core::Motion& motion,
                          const std::optional<firmware_link::Command>& command) {
    firmware_link::TextBuffer buffer;
    if (command) done.commands.emplace_back(firmware_link::encode(*command, buffer));
    if (const auto* layer = std::get_if<core::LayerStart>(&motion)) now.layer = layer->index;
    if (const auto* road = std::get_if<core::RoadStart>(&motion)) now.kind = road->kind;
    if (const auto* road = std::get_if<core::RoadChange>(&motion)) now.kind = road->kind;
    if (const auto* travel = std::get_if<core::Travel>(&motion)) now.from = travel->to;
    if (const auto* laid = std::get_if<core::Extrude>(&motion)) {
      now.to = laid->to;
      now.speed_mm_s = laid->speed_mm_s;
      now.filament_mm = laid->filament_mm;
      done.moves.push_back(now);
      now.from = laid->to;
    }
    return true;
  };
  host::PipelineSignals signals;
  host::GeometryStatistics statistics;
  REQUIRE(host::run_pipeline(print_plan, outputs, signals, statistics).ok());
  return done;
}

// A block, and a modifier over its right half, from 2 to 6 mm up.
std::vector<MarkedBody> half(const char* plastic, const char* modifier,
                             test::BodySettings settings) {
  return {{parts::box({0, 0, 0}, 40, 20, 8), plastic},
          {parts::box({20, -5, 2}, 30, 30, 4), modifier, {}, std::move(settings)}};
}

Settings unslowed() {
  Settings settings;
  settings.layer_time_min_s = 0;
  settings.arcs = core::ArcUse::kOff;
  settings.part_x = settings.part_y = core::Length::from_mm(50);
  settings.centre = false;
  return settings;
}

bool within(const LaidMove& move) {
  return move.layer >= 10 && move.layer < 30 && std::min(move.from.x, move.to.x) >= 700'000;
}

}  // namespace

TEST_CASE("speeds and flow: each move within a modifier has its own, and no other") {
  const PartFolder folder;
  const std::string prusa =
      folder.add_text("prusa.3mf", test::prusa_threemf(half("ModelPart", "ParameterModifier",
                                                            {{"perimeter_speed", "25"},
                                                             {"external_perimeter_speed", "22"},
                                                             {"infill_speed", "28"},
                                                             {"solid_infill_speed", "31"},
                                                             {"gap_fill_speed", "11"}})));
  const std::string orca =
      folder.add_text("orca.3mf", test::orca_threemf(half("normal_part", "modifier_part",
                                                          {{"inner_wall_speed", "25"},
                                                           {"outer_wall_speed", "22"},
                                                           {"sparse_infill_speed", "28"},
                                                           {"internal_solid_infill_speed", "31"},
                                                           {"gap_infill_speed", "11"}})));
  const Print first = print(unslowed(), prusa);
  CHECK(first.commands == print(unslowed(), orca).commands);
  CHECK(first.commands == print(unslowed(), prusa, 1).commands);
  CHECK(first.commands == print(unslowed(), prusa, 3).commands);
  const auto slow = [](RoadKind kind) -> double {
    switch (kind) {
      case RoadKind::kPerimeter:
        return 25;
      case RoadKind::kOuterPerimeter:
        return 22;
      case RoadKind::kLoose:
        return 28;
      case RoadKind::kSolid:
        return 31;
      case RoadKind::kGapFill:
        return 11;
      default:
        return 0;
    }
  };
  int inside = 0, outside = 0;
  for (const LaidMove& move : first.moves) {
    if (slow(move.kind) == 0 || move.layer == 0) continue;
    CAPTURE(move.layer);
    CAPTURE(static_cast<int>(move.kind));
    CAPTURE(move.from.x);
    CAPTURE(move.to.x);
    const double own = move.kind == RoadKind::kGapFill ? 40 : 60;
    // Shorter pieces go with what is beside them, and roads begin and end on the border.
    const bool beside = core::distance_mm(move.from, move.to) < 0.3;
    if (within(move)) {
      CHECK((move.speed_mm_s == slow(move.kind) || beside));
      ++inside;
    } else {
      const bool reaches =
          move.layer >= 10 && move.layer < 30 && std::max(move.from.x, move.to.x) > 703'000;
      CHECK_FALSE((reaches && !beside));  // cut at the border
      if (!beside) CHECK_EQ(move.speed_mm_s, own);
      ++outside;
    }
  }
  CHECK_GT(inside, 500);
  CHECK_GT(outside, 500);
  // The same roads, and as much filament.
  double plain_mm = 0, slow_mm = 0;
  const std::string without = folder.add("block.stl", parts::box({0, 0, 0}, 40, 20, 8));
  for (const LaidMove& move : print(unslowed(), without).moves) plain_mm += move.filament_mm;
  for (const LaidMove& move : first.moves) slow_mm += move.filament_mm;
  CHECK_EQ(slow_mm, doctest::Approx(plain_mm).epsilon(1e-5));
}

TEST_CASE("perimeters: as many as asked for within a modifier, the part's own number outside") {
  const PartFolder folder;
  const std::string prusa = folder.add_text(
      "prusa.3mf", test::prusa_threemf(half("ModelPart", "ParameterModifier",
                                            {{"perimeters", "5"}, {"perimeter_speed", "25"}})));
  const std::string orca = folder.add_text(
      "orca.3mf", test::orca_threemf(half("normal_part", "modifier_part",
                                          {{"wall_loops", "5"}, {"inner_wall_speed", "25"}})));
  const Print done = print(unslowed(), prusa);
  CHECK(done.commands == print(unslowed(), orca).commands);
  CHECK(done.commands == print(unslowed(), prusa, 1).commands);
  CHECK(done.commands == print(unslowed(), prusa, 3).commands);
  // Perimeters under a way from the front to the middle of the block, in each layer.
  const auto passed = [&](core::LayerIndex layer, std::int32_t x) {
    return std::count_if(done.moves.begin(), done.moves.end(), [&](const LaidMove& move) {
      const bool perimeter =
          move.kind == RoadKind::kPerimeter || move.kind == RoadKind::kOuterPerimeter;
      const bool under =
          std::min(move.from.x, move.to.x) < x && std::max(move.from.x, move.to.x) > x;
      return move.layer == layer && perimeter && under && move.to.y < 600'000;
    });
  };
  for (core::LayerIndex layer = 1; layer < 40; ++layer) {
    CAPTURE(layer);
    CHECK_EQ(passed(layer, 600'000), 2);
    CHECK_EQ(passed(layer, 800'000), layer >= 10 && layer < 30 ? 5 : 2);
  }
  // Where five perimeters are deeper than the wall, they are dense instead of the inside.
  const Print plain = print(unslowed(), folder.add("block.stl", parts::box({0, 0, 0}, 40, 20, 8)));
  const auto filament_mm = [](const Print& one, core::LayerIndex layer) {
    double sum = 0;
    for (const LaidMove& move : one.moves) {
      if (move.layer == layer) sum += move.filament_mm;
    }
    return sum;
  };
  const double mm2 = 3.14159265 * 1.75 * 1.75 / 4;
  // The wall is 0.8 mm; five perimeters are 5 spacings.
  const double spacing = 0.45 - 0.2 * (1 - 3.14159265 / 4), deep = 5 * spacing - 0.8;
  const double further_mm2 = deep * (2 * 20 + 20 - 2 * (0.8 + deep / 2));
  const double more = (filament_mm(done, 20) - filament_mm(plain, 20)) * mm2 / 0.2;
  CHECK_EQ(more, doctest::Approx(0.8 * further_mm2).epsilon(0.08));
}

TEST_CASE("a modifier that is empty, or asks for what the part has, changes no byte") {
  const PartFolder folder;
  const Settings settings = unslowed();
  const std::string plain = folder.add_text(
      "plain.3mf", test::prusa_threemf({{parts::box({0, 0, 0}, 40, 20, 8), "ModelPart"}}));
  const std::vector<std::string> expected = print(settings, plain).commands;
  const auto same = [&](const char* name, test::BodySettings modifier) {
    const std::string path = folder.add_text(
        name, test::prusa_threemf(half("ModelPart", "ParameterModifier", std::move(modifier))));
    return print(settings, path).commands == expected;
  };
  CHECK(same("empty.3mf", {{"name", "Nothing"}}));
  CHECK(same("same.3mf", {{"perimeters", "2"},
                          {"fill_density", "20%"},
                          {"perimeter_speed", "60"},
                          {"external_perimeter_speed", "100%"},
                          {"bridge_flow_ratio", "1"}}));
  CHECK_FALSE(same("three.3mf", {{"perimeters", "3"}}));
  CHECK_FALSE(same("slow.3mf", {{"perimeter_speed", "59"}}));
}
