#include "host/pipeline/layer_draft.h"

#include <doctest/doctest.h>

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/settings.h"
#include "host/output/gcode_writer.h"
#include "host/part/part_file.h"
#include "host/pipeline/pipeline.h"
#include "tests/support/part_folder.h"
#include "tools/parts/part_maker.h"

using core::Length;
using core::Settings;
using test::PartFolder;

namespace {

struct Written {
  std::string text;
  std::string error;
  std::vector<double> layer_times;
  int drafts = 0;  // whose text was taken
  host::GeometryStatistics statistics;
};

// The G-code, with each motion given out by itself or, with `drafts`, layers' roads as text.
Written write(const Settings& settings, const std::string& path, bool drafts, int threads) {
  Written written;
  core::Result<host::OpenedPart> part = host::open_whole_part(path, settings);
  REQUIRE(part.ok());
  host::PrintPlan plan{settings, std::move(part).value(), "part"};
  plan.threads = threads;
  host::GcodeWriter writer;
  host::PipelineOutputs outputs;
  outputs.on_layer_time = [&](double seconds) { written.layer_times.push_back(seconds); };
  outputs.on_motion = [&](const core::Motion& motion,
                          const std::optional<firmware_link::Command>& command) {
    writer.write(motion, command, written.text);
    return true;
  };
  if (drafts) {
    outputs.writer = &writer;
    outputs.on_roads_text = [&](std::string_view text) {
      ++written.drafts;
      written.text += text;
      return true;
    };
  }
  host::PipelineSignals signals;
  const auto end = host::run_pipeline(plan, outputs, signals, written.statistics);
  if (!end.ok()) written.error = end.error().message;
  return written;
}

// `share`: of the layers, at least, whose roads are taken from drafts.
void check_same(const Settings& settings, const std::string& path, double share) {
  const Written one = write(settings, path, false, 1);
  REQUIRE(one.error.empty());
  REQUIRE_GT(one.layer_times.size(), 10);
  for (const int threads : {1, 2, 3, 16}) {
    CAPTURE(threads);
    const Written drafted = write(settings, path, true, threads);
    CHECK(drafted.text == one.text);
    CHECK(drafted.layer_times == one.layer_times);
    CHECK_EQ(drafted.statistics.time_s, one.statistics.time_s);
    CHECK_EQ(drafted.statistics.needed.mm, one.statistics.needed.mm);
    CHECK(drafted.statistics.filament_mm == one.statistics.filament_mm);
    CHECK_EQ(drafted.statistics.arcs, one.statistics.arcs);
    // One thread makes drafts only of roads that several layers lay.
    if (threads == 1) continue;
    CHECK_GE(drafted.drafts, share * static_cast<double>(one.layer_times.size()));
  }
}

Settings plain() {
  Settings settings;
  settings.arcs = core::ArcUse::kOff;
  return settings;
}

}  // namespace

TEST_CASE("layers' roads as text are what their motions would be, for up to 16 threads") {
  const PartFolder folder;
  const std::string demo = folder.add("demo.stl", parts::demo());
  const std::string mushroom = folder.add("mushroom.stl", parts::mushroom());
  const std::string box = folder.add("box.stl", parts::box({2, 2, 0}, 16, 16, 4));
  Settings settings = plain();
  SUBCASE("as they are by default") { check_same(settings, demo, 0.9); }
  SUBCASE("layers with the same roads") {
    check_same(settings, box, 0.9);
    CHECK_GT(write(settings, box, true, 1).drafts, 10);
  }
  SUBCASE("with arcs") {
    settings.arcs = core::ArcUse::kOn;
    check_same(settings, demo, 0.9);
  }
  SUBCASE("with supports, a raft, and unequal layers") {
    settings.supports = core::SupportPlace::kEverywhere;
    settings.raft_layers = 2;
    settings.adaptive_layer_height = true;
    check_same(settings, mushroom, 0.7);
  }
  SUBCASE("with lifts and wipes, which are laid at one height alone") {
    settings.retraction_lift = Length::from_mm(0.3);
    settings.wipe = true;
    check_same(settings, demo, 0.5);
    check_same(settings, box, 0);
  }
  SUBCASE("with accelerations, also such as sink with the height") {
    settings.default_acceleration_mm_s2 = 1'000;
    settings.outer_perimeter_acceleration_mm_s2 = 500;
    settings.travel_acceleration_mm_s2 = 2'000;
    check_same(settings, demo, 0.9);
    settings.height_slowdown_from = Length::from_mm(1);
    settings.height_slowdown_to = Length::from_mm(3);
    settings.height_slowdown_acceleration = 0.3;
    settings.height_slowdown_speed = 0.5;
    check_same(settings, box, 0.2);
  }
  SUBCASE("around contours, with user's lines that change how it moves") {
    settings.avoid_crossing_perimeters = true;
    settings.start_gcode = {"G28", "M205 X5 Y5", "M220 S80", "M221 S95", "G1 X1 Y1 F900"};
    check_same(settings, demo, 0.9);
  }
  SUBCASE("a feed that is told already is not told again") {
    settings.retraction_mm = 0;
    settings.travel_speed_mm_s = settings.lift_speed_mm_s = settings.outer_perimeter_speed_mm_s;
    settings.perimeter_speed_mm_s = settings.outer_perimeter_speed_mm_s;
    settings.layer_time_min_s = 0;
    check_same(settings, box, 0.9);
    check_same(settings, demo, 0.9);
  }
  SUBCASE("filament that is drawn back by less than is told") {
    settings.retraction_mm = 1e-5;
    check_same(settings, box, 0);
  }
  SUBCASE("so slow to speed up that no clock comes to go on as the draft's") {
    settings.acceleration_mm_s2 = 1;
    check_same(settings, demo, 0);
  }
}
