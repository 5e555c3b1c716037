// Prints to a virtual controller in the same process: what it executes, and how a print ends.
#include "host/printing/print_part.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/system/exit_codes.h"
#include "host/system/limits.h"
#include "tests/host/print_rig.h"
#include "tests/support/laid_roads.h"
#include "tests/support/road_path.h"

using core::Length;
using print_test::Rig;
using test::PartFolder;

namespace {

core::Settings coarse() {
  core::Settings settings;
  settings.layer_height = Length::from_mm(0.3);
  settings.wall_thickness = Length::from_mm(0.9);
  return settings;
}

bool says(const host::PrintOutcome& outcome, const std::string& text) {
  return outcome.message.find(text) != std::string::npos;
}

// Heaters off, fan off, and the nozzle parked above where it was, with the filament drawn back.
void check_made_safe(Rig& rig) {
  const firmware_link::VirtualControllerState state = rig.controller();
  CHECK_EQ(state.nozzle_target_celsius, 0);
  CHECK_EQ(state.bed_target_celsius, 0);
  CHECK_EQ(state.fan, 0);
  REQUIRE_GE(rig.executed.size(), 6);
  const std::vector<std::string> last(rig.executed.end() - 6, rig.executed.end());
  CHECK_EQ(last[0], "G1 E-1 F2400");
  CHECK_EQ(last[1].substr(0, 4), "G0 Z");
  CHECK_EQ(last[2], "G0 X5 Y5 F7800");
  CHECK_EQ(last[3], "M104 S0");
  CHECK_EQ(last[4], "M140 S0");
  CHECK_EQ(last[5], "M107");
}

// A source that ends with an error, or an exception, after some slices.
class FailingSource final : public host::LayerSource {
 public:
  FailingSource(std::unique_ptr<host::LayerSource> inner, int slices, bool throws)
      : inner_(std::move(inner)), slices_(slices), throws_(throws) {}

  [[nodiscard]] core::Result<std::optional<core::Slice>> next() override {
    if (slices_-- > 0) return inner_->next();
    if (throws_) throw std::runtime_error("out of luck");
    return core::Error{core::ErrorCode::kBadPart, "part.stl: slice 20 can't be cut"};
  }

 private:
  std::unique_ptr<host::LayerSource> inner_;
  int slices_;
  bool throws_;
};

}  // namespace

TEST_CASE("what the controller executes is what the file says") {
  const PartFolder folder;
  const parts::Part box = parts::box({5, 5, 0}, 12, 9, 4);
  const std::vector<std::pair<const char*, parts::Part>> cases = {
      {"box.stl", box},
      {"tube.stl", parts::tube(8, 4, 3, 48)},
      {"crossing.stl", parts::together({box, parts::box({9, 8, 1.1}, 12, 9, 4)})},
      {"hole.stl", parts::edited(box,
                                 [](const parts::Facet& facet, std::int64_t number) {
                                   return number == 5 ? std::vector<parts::Facet>{}
                                                      : std::vector<parts::Facet>{facet};
                                 })},
  };
  for (const auto& each : cases) {
    const std::string name = each.first;
    CAPTURE(name);
    const std::string path = folder.add(name, each.second);
    const std::vector<std::string> sliced = print_test::given_lines(coarse(), path);
    Rig rig(coarse(), path);
    const host::PrintOutcome outcome = rig.print();
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    CAPTURE(outcome.message);
    // Before the first command of ours the session asks who is there.
    const auto first = std::find(rig.executed.begin(), rig.executed.end(), sliced.front());
    const std::vector<std::string> executed(first, rig.executed.end());
    REQUIRE_EQ(executed.size(), sliced.size());
    for (std::size_t i = 0; i < sliced.size(); ++i) REQUIRE_EQ(executed[i], sliced[i]);
    CHECK_GT(rig.count("G1 "), 50);
    CHECK_EQ(outcome.geometry.defects.layers() > 0, name == "hole.stl");

    const firmware_link::VirtualControllerTotals& totals = rig.port->controller().totals();
    CHECK_EQ(totals.cold_extrusions, 0);
    CHECK_EQ(totals.clamped_moves, 0);
    CHECK_EQ(totals.unknown_commands, 0);
    // The session's own question, at the end, whether all lines are there.
    CHECK_LE(totals.resends_asked, 1);
    CHECK_EQ(outcome.link.resends, 0);
    // Drawn back once at the end, and never more than given back before.
    CHECK_LT(std::abs(totals.filament_mm() + rig.print_plan.settings.retraction_mm -
                      host::total_mm(outcome.geometry.filament_mm)),
             0.001);
    CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
    CHECK_EQ(rig.controller().bed_target_celsius, 0);
  }
}

// A round part: the way with arcs against the way without, by brute force, layer by layer.
TEST_CASE("arcs lie within their tolerance of the roads, and lay as much") {
  const PartFolder folder;
  const std::string path = folder.add("tube.stl", parts::tube(5, 3, 0.9, 180));
  const auto printed = [&path](core::ArcUse use, firmware_link::VirtualDialect dialect) {
    core::Settings settings = coarse();
    settings.arcs = use;
    firmware_link::VirtualControllerOptions options;
    options.dialect = dialect;
    Rig rig(settings, path, options);
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    CHECK_EQ(outcome.geometry.arcs, rig.count("G2 ") + rig.count("G3 "));
    return std::pair(test::laid_by(rig.executed), rig.port->controller().totals());
  };
  using firmware_link::VirtualDialect;
  const auto [straight, straight_totals] = printed(core::ArcUse::kOff, VirtualDialect::kMarlin);
  const auto [round, round_totals] = printed(core::ArcUse::kAuto, VirtualDialect::kMarlin);
  CHECK_LT(round.size() * 4, straight.size());
  CHECK_LT(std::abs(round_totals.filament_10nm - straight_totals.filament_10nm), 20);
  CHECK_EQ(round_totals.unknown_commands, 0);
  const auto paths_by_height = [](const std::vector<test::LaidPiece>& laid) {
    std::map<double, std::vector<test::Path>> paths;
    for (const test::LaidPiece& piece : laid) {
      std::vector<test::Path>& roads = paths[piece.height];
      if (roads.empty() || roads.back().back() != piece.from) roads.push_back({piece.from});
      if (piece.turn == 0) {
        roads.back().push_back(piece.to);
      } else {
        test::add_arc(piece.from, piece.to, piece.centre, piece.turn < 0, 0.005, roads.back());
      }
    }
    return paths;
  };
  const auto wanted = paths_by_height(straight), got = paths_by_height(round);
  REQUIRE_EQ(got.size(), wanted.size());
  // The tolerance, and two roundings to the wire's micrometres.
  const double most_mm = core::Settings().arc_fit_tolerance.mm() + 0.003;
  for (const auto& [height, roads] : wanted) {
    const std::vector<test::Path>& arcs = got.at(height);
    REQUIRE_EQ(arcs.size(), roads.size());
    for (std::size_t i = 0; i < roads.size(); ++i) {
      REQUIRE_LT(test::farthest_off(arcs[i], roads[i], 0.01), most_mm);
      REQUIRE_LT(test::farthest_off(roads[i], arcs[i], 0.01), most_mm);
    }
  }
}

TEST_CASE("segments merged for a slow line are the same in a file and in print") {
  const PartFolder folder;
  const std::string path = folder.add("tube.stl", parts::tube(5, 3, 0.9, 180));
  core::Settings settings = coarse();
  settings.arcs = core::ArcUse::kOff;
  core::Settings every_segment = settings;
  every_segment.segment_tolerance = Length();
  const std::size_t all = print_test::sliced_lines(every_segment, path).size();
  settings.segment_time_min_ms = 10;
  const std::vector<std::string> sliced = print_test::given_lines(settings, path);
  CHECK_LT(sliced.size() * 5, all * 4);
  Rig rig(settings, path);
  CHECK_EQ(rig.print().exit_code, host::kExitDone);
  const auto first = std::find(rig.executed.begin(), rig.executed.end(), sliced.front());
  CHECK((std::vector<std::string>(first, rig.executed.end()) == sliced));
}

TEST_CASE("a controller that does not say that it draws arcs gets none") {
  const PartFolder folder;
  const std::string path = folder.add("tube.stl", parts::tube(5, 3, 0.9, 180));
  core::Settings settings = coarse();
  firmware_link::VirtualControllerOptions options;
  options.dialect = firmware_link::VirtualDialect::kKlipper;
  Rig rig(settings, path, options);
  const host::PrintOutcome outcome = rig.print();
  CHECK_EQ(outcome.exit_code, host::kExitDone);
  CHECK_EQ(outcome.geometry.arcs, 0);
  CHECK_EQ(rig.port->controller().totals().unknown_commands, 0);
}

TEST_CASE("a signal in mid-print lifts the nozzle and turns the heaters off") {
  const PartFolder folder;
  const std::string path = folder.add("box.stl", parts::box({5, 5, 0}, 12, 9, 4));
  for (const std::int64_t commands : {20, 100, 200}) {
    CAPTURE(commands);
    Rig rig(coarse(), path);
    rig.control.stop = [&] { return std::ssize(rig.executed) > commands ? 1 : 0; };
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitStopped);
    CHECK(says(outcome, "stopped at layer"));
    CHECK(says(outcome, "mm"));
    CHECK(says(outcome, "heaters and fan off"));
    check_made_safe(rig);
    CHECK_GT(rig.controller().z_mm, 10);  // park_lift
    CHECK_EQ(rig.count("M84"), 0);
  }
}

TEST_CASE("a signal while it heats turns the heaters off and moves nothing") {
  const PartFolder folder;
  Rig rig(coarse(), folder.add("box.stl", parts::box({5, 5, 0}, 12, 9, 4)));
  rig.control.stop = [&] { return rig.count("M104") > 0 ? 1 : 0; };
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  CHECK_EQ(outcome.exit_code, host::kExitStopped);
  CHECK(says(outcome, "before the first road"));
  CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
  CHECK_EQ(rig.controller().bed_target_celsius, 0);
  CHECK_EQ(rig.count("G1 E-"), 0);
}

TEST_CASE("a second signal halts the controller at once") {
  const PartFolder folder;
  Rig rig(coarse(), folder.add("box.stl", parts::box({5, 5, 0}, 12, 9, 4)));
  rig.control.stop = [&] { return rig.executed.size() > 50 ? 2 : 0; };
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  CHECK_EQ(outcome.exit_code, host::kExitStopped);
  CHECK(says(outcome, "M112"));
  CHECK(rig.controller().halted);
}

TEST_CASE("a line that goes dead, or a controller that halts, ends the print with code 4") {
  const PartFolder folder;
  const std::string path = folder.add("box.stl", parts::box({5, 5, 0}, 12, 9, 4));
  for (const bool unplugged : {true, false}) {
    CAPTURE(unplugged);
    Rig rig(coarse(), path);
    rig.on_executed = [&] {
      if (rig.executed.size() != 100) return;
      if (unplugged) {
        rig.wire->unplug();
      } else {
        rig.wire->say(
            "Error:Thermal Runaway, system stopped! Heater_ID: 0\n"
            "Error:Printer halted. kill() called!\n");
      }
    };
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitLinkFault);
    CHECK(says(outcome, "stopped at layer"));
    CHECK(says(outcome, "check"));
    CHECK_LT(rig.executed.size(), 120);
    if (!unplugged) CHECK(says(outcome, "Thermal Runaway"));
  }
}

TEST_CASE("geometry that fails in mid-print brings the printer to a safe end") {
  const PartFolder folder;
  const std::string path = folder.add("box.stl", parts::box({5, 5, 0}, 12, 9, 40));
  for (const bool throws : {true, false}) {
    CAPTURE(throws);
    Rig rig(coarse(), path);
    // Late enough for the queue to have been full.
    rig.print_plan.part.layers =
        std::make_unique<FailingSource>(std::move(rig.print_plan.part.layers), 130, throws);
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitBadInput);
    CHECK(says(outcome, throws ? "out of luck" : "slice 20 can't be cut"));
    CHECK(says(outcome, "stopped at layer"));
    check_made_safe(rig);
  }
}

TEST_CASE("a part without any road never heats") {
  const PartFolder folder;
  Rig rig(coarse(),
          folder.add("needles.stl", parts::together({parts::box({5, 5, 0}, 0.1, 0.1, 4),
                                                     parts::box({9, 9, 0}, 0.1, 0.1, 4)})));
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  CHECK_EQ(outcome.exit_code, host::kExitBadInput);
  CHECK(says(outcome, "no road"));
  CHECK_EQ(rig.count("M104"), 0);
  CHECK_EQ(rig.count("M140"), 0);
  CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
}

TEST_CASE("a skirt that leaves the bed is told before anything heats") {
  const PartFolder folder;
  core::Settings settings = coarse();
  settings.bed_x = settings.bed_y = Length::from_mm(14);
  Rig rig(settings, folder.add("box.stl", parts::box({5, 5, 0}, 12, 9, 4)));
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  CHECK_EQ(outcome.exit_code, host::kExitBadInput);
  CHECK(says(outcome, "skirt"));
  CHECK_EQ(rig.count("M104"), 0);
}

TEST_CASE("a tall part starts as early, and holds as little, as a short one") {
  constexpr std::int64_t kLayers = 1'000;
  const PartFolder folder;
  core::Settings settings;
  Rig rig(settings, folder.add("tall.stl", parts::box({5, 5, 0}, 4, 4, 0.2 * kLayers)));
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  REQUIRE_EQ(outcome.exit_code, host::kExitDone);
  CHECK_EQ(outcome.geometry.layers, kLayers);
  const std::int64_t t = core::wall_layers(settings);
  CHECK_LE(outcome.geometry.peak_held.layers, 2 * t + 1);
  CHECK_LE(outcome.geometry.peak_held.regions, 2 * t);
  // Every layer has 8 commands or more: what the queue can hold at most.
  REQUIRE(outcome.link.slices_cut_at_first_road.has_value());
  CHECK_GE(*outcome.link.slices_cut_at_first_road, 1);
  CHECK_LE(*outcome.link.slices_cut_at_first_road,
           t + 2 + static_cast<std::int64_t>(host::kQueuedCommandsMax) / 8);
  CHECK_LT(*outcome.link.first_command_s, *outcome.link.first_road_s);
}
