// Objects that are printed one after another: each is laid as if it were alone, the nozzle passes
// over what is finished, and a print that ends or is resumed anywhere keeps to that.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "firmware_link/wire/line_codec.h"
#include "host/part/object_sequence.h"
#include "host/part/plate.h"
#include "host/pipeline/pipeline.h"
#include "host/system/exit_codes.h"
#include "tests/host/interrupted_print.h"

using core::Length;
using print_test::coarse;
using print_test::Rig;
using test::LaidPiece;
using test::PartFolder;

namespace {

struct Parts {
  PartFolder folder;
  std::vector<std::string> paths{
      folder.add("high.stl", parts::box({0, 0, 0}, 8, 9, 6)),
      folder.add("low.stl", parts::together(
                                {parts::box({5, 5, 0}, 9, 8, 3), parts::box({6, 6, 0}, 3, 3, 4)}))};
};

core::Settings in_turn() {
  core::Settings settings = coarse();
  settings.sequential = true;
  settings.copies = 2;
  settings.clearance_radius = Length::from_mm(30);
  settings.retraction_lift = Length::from_mm(0.2);
  // Nothing else keeps the nozzle off what stands.
  settings.park_lift = Length::from_mm(0.5);
  settings.brim_width = Length::from_mm(2);
  settings.retraction_travel_min = Length::from_mm(1'000);
  return settings;
}

host::PrintPlan open_in_turn(const core::Settings& settings,
                             const std::vector<std::string>& paths) {
  auto part = host::read_whole(host::open_sequence(paths, settings, {}));
  if (!part.ok()) FAIL(part.error().message);
  return {settings, std::move(part).value(), paths.front()};
}

struct Computed {
  std::vector<std::string> texts;
  std::vector<host::Checkpoint> checkpoints;
  std::vector<core::LayerIndex> layers;
};

Computed compute(host::PrintPlan print_plan, const std::optional<host::Checkpoint>& start = {}) {
  print_plan.start = start;
  Computed computed;
  host::PipelineOutputs outputs;
  outputs.on_checkpoint = [&](const host::Checkpoint& checkpoint) {
    computed.checkpoints.push_back(checkpoint);
  };
  outputs.on_motion = [&](const core::Motion& motion,
                          const std::optional<firmware_link::Command>& command) {
    firmware_link::TextBuffer buffer;
    if (command) computed.texts.emplace_back(firmware_link::encode(*command, buffer));
    if (const auto* layer = std::get_if<core::LayerStart>(&motion)) {
      computed.layers.push_back(layer->index);
    }
    return true;
  };
  host::PipelineSignals signals;
  host::GeometryStatistics statistics;
  const auto end = host::run_pipeline(print_plan, outputs, signals, statistics);
  REQUIRE_MESSAGE(end.ok(), (end.ok() ? "" : end.error().message));
  return computed;
}

bool is_in(const core::Box& box, const std::array<double, 2>& at) {
  const double x = at[0] * core::kUnitsPerMm, y = at[1] * core::kUnitsPerMm;
  return x >= box.min.x && x <= box.max.x && y >= box.min.y && y <= box.max.y;
}

std::vector<LaidPiece> laid_in(const core::Box& box, const std::vector<std::string>& lines) {
  std::vector<LaidPiece> pieces = test::laid_by(lines);
  std::erase_if(pieces, [&box](const LaidPiece& piece) { return !is_in(box, piece.to); });
  return pieces;
}

// The distance of a way from a box, 0 where they meet, by points along the way.
double distance_mm(const core::Box& box, const std::array<double, 2>& from,
                   const std::array<double, 2>& to) {
  constexpr int kPoints = 200;
  double least = 1e9;
  for (int i = 0; i <= kPoints; ++i) {
    const double x = from[0] + (to[0] - from[0]) * i / kPoints;
    const double y = from[1] + (to[1] - from[1]) * i / kPoints;
    const double dx = std::max({box.min.x * 1e-4 - x, x - box.max.x * 1e-4, 0.0});
    const double dy = std::max({box.min.y * 1e-4 - y, y - box.max.y * 1e-4, 0.0});
    least = std::min(least, std::hypot(dx, dy));
  }
  return least;
}

// Follows a controller's commands, and knows which objects are finished. The law: a print head of
// this radius never comes beside or into an object that is finished, unless it is over its top.
class HeadWatch {
 public:
  HeadWatch(std::vector<host::PartObject> objects, double radius_mm)
      : objects_(std::move(objects)), radius_mm_(radius_mm), tops_(objects_.size()) {}

  // Returns the first command that breaks the law.
  [[nodiscard]] std::optional<std::string> first_hit(const std::vector<std::string>& lines) {
    std::vector<std::size_t> last_laid(objects_.size(), 0);
    const std::vector<Way> ways = ways_of(lines);
    for (std::size_t line = 0; line < ways.size(); ++line) {
      for (std::size_t i = 0; i < objects_.size(); ++i) {
        if (!ways[line].lays || !is_in(objects_[i].box, ways[line].to)) continue;
        last_laid[i] = line;
        tops_[i] = std::max(tops_[i], ways[line].low);
      }
    }
    for (std::size_t line = 0; line < ways.size(); ++line) {
      for (std::size_t i = 0; i < objects_.size(); ++i) {
        if (line > last_laid[i] && hits(ways[line], i)) return lines[line];
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] std::int64_t laid() const {
    return std::count_if(tops_.begin(), tops_.end(), [](double top) { return top > 0; });
  }

 private:
  struct Way {
    std::array<double, 2> from{}, to{};
    double low = 0;
    bool lays = false;
  };

  [[nodiscard]] static double value(const std::string& line, char letter, double before) {
    const std::size_t at = line.find(std::string(" ") + letter);
    return at == std::string::npos ? before : std::strtod(line.c_str() + at + 2, nullptr);
  }

  // One for each line.
  [[nodiscard]] static std::vector<Way> ways_of(const std::vector<std::string>& lines) {
    std::vector<Way> ways;
    std::array<double, 2> place{0, 0};
    double z = 0;
    for (const std::string& line : lines) {
      Way way{place, place, z};
      if (line.rfind("G28", 0) == 0) way.to = {0, 0};
      if (line.rfind("G92", 0) == 0) z = value(line, 'Z', z);
      if (line.rfind("G0", 0) == 0 || line.rfind("G1", 0) == 0) {
        way.to = {value(line, 'X', place[0]), value(line, 'Y', place[1])};
        const double to_z = value(line, 'Z', z);
        way.low = std::min(z, to_z);
        way.lays = value(line, 'E', 0) > 0 && way.to != place;
        z = to_z;
      }
      place = way.to;
      ways.push_back(way);
    }
    return ways;
  }

  [[nodiscard]] bool hits(const Way& way, std::size_t object) const {
    return way.low < tops_[object] &&
           distance_mm(objects_[object].box, way.from, way.to) < radius_mm_ - 1e-6;
  }

  std::vector<host::PartObject> objects_;
  double radius_mm_;
  std::vector<double> tops_;  // up to which each has been laid; 0: not begun
};

}  // namespace

TEST_CASE("each object is laid as if it were printed alone") {
  const Parts parts;
  core::Settings settings = in_turn();
  settings.skirt_loops = 0;
  settings.brim_width = Length();
  host::PrintPlan print_plan = open_in_turn(settings, parts.paths);
  const std::vector<host::PartObject> objects = print_plan.part.summary.objects;
  REQUIRE_EQ(objects.size(), 4);
  const Computed all = compute(std::move(print_plan));
  std::size_t pieces = 0;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    CAPTURE(i);
    core::Settings one = settings;
    one.sequential = false;
    one.copies = 1;
    one.centre = false;
    one.part_x = Length::from_units(objects[i].box.min.x);
    one.part_y = Length::from_units(objects[i].box.min.y);
    const Computed alone = compute(print_test::open(one, parts.paths[i < 2 ? 1 : 0]));
    const std::vector<LaidPiece> wanted = test::laid_by(alone.texts);
    const std::vector<LaidPiece> laid = laid_in(objects[i].box, all.texts);
    REQUIRE_EQ(laid.size(), wanted.size());
    for (std::size_t k = 0; k < laid.size(); ++k) {
      CAPTURE(k);
      CHECK(laid[k].from == wanted[k].from);
      CHECK(laid[k].to == wanted[k].to);
      CHECK_EQ(laid[k].height, wanted[k].height);
      CHECK_EQ(laid[k].feed, wanted[k].feed);
      // The rounding error is carried on from the object before.
      CHECK(laid[k].filament == doctest::Approx(wanted[k].filament).epsilon(1e-3));
    }
    pieces += laid.size();
  }
  CHECK_EQ(test::laid_by(all.texts).size(), pieces);
  for (std::size_t i = 0; i < all.layers.size(); ++i) {
    CHECK_EQ(all.layers[i], static_cast<core::LayerIndex>(i));
  }
}

TEST_CASE("the print head never comes beside what is finished") {
  const Parts parts;
  const core::Settings settings = in_turn();
  host::PrintPlan print_plan = open_in_turn(settings, parts.paths);
  HeadWatch watch(print_plan.part.summary.objects, settings.clearance_radius.mm());
  const Computed all = compute(std::move(print_plan));
  CHECK_EQ(watch.first_hit(all.texts).value_or("none"), "none");
  CHECK_EQ(watch.laid(), 4);
}

TEST_CASE("the skirt is laid once") {
  const Parts parts;
  core::Settings settings = in_turn();
  const std::size_t with = test::laid_by(compute(open_in_turn(settings, parts.paths)).texts).size();
  settings.skirt_loops = 0;
  const Computed bare = compute(open_in_turn(settings, parts.paths));
  const std::size_t without = test::laid_by(bare.texts).size();
  CHECK_GT(with, without);
  CHECK_LT(with, without + 150);
}

TEST_CASE("from any layer of any object on, the commands are those of the whole print") {
  const Parts parts;
  core::Settings settings = in_turn();
  for (const int raft_layers : {0, 2}) {
    CAPTURE(raft_layers);
    settings.raft_layers = raft_layers;
    const Computed whole = compute(open_in_turn(settings, parts.paths));
    REQUIRE_GT(whole.checkpoints.size(), 50);
    for (std::size_t i = 0; i < whole.checkpoints.size(); i += i % 13 < 2 ? 1 : 4) {
      CAPTURE(i);
      const host::Checkpoint& start = whole.checkpoints[i];
      const Computed tail = compute(open_in_turn(settings, parts.paths), start);
      const std::vector<std::string> wanted(
          whole.texts.begin() + static_cast<std::ptrdiff_t>(start.commands), whole.texts.end());
      CHECK(tail.texts == wanted);
    }
    for (std::size_t i = 0; i < whole.layers.size(); ++i) {
      CHECK_EQ(whole.layers[i], static_cast<core::LayerIndex>(i));
    }
  }
}

TEST_CASE("a print of objects in turn is stopped, or cut, and resumed over what stands") {
  const Parts parts;
  const core::Settings settings = in_turn();
  const std::size_t commands = [&] {
    Rig whole(settings, open_in_turn(settings, parts.paths));
    REQUIRE_EQ(whole.print().exit_code, host::kExitDone);
    return whole.executed.size();
  }();
  // In the second, third and last object, not far above the bed.
  for (const std::size_t part : {28U, 52U, 58U, 82U}) {
    const std::size_t at = commands * part / 100;
    CAPTURE(at);
    for (const bool resets : {false, true}) {
      CAPTURE(resets);
      Rig rig(settings, open_in_turn(settings, parts.paths));
      HeadWatch watch(rig.print_plan.part.summary.objects, settings.clearance_radius.mm());
      const std::string journal_path =
          parts.folder.file("j" + std::to_string(at) + (resets ? "r" : ""));
      auto journal = print_test::new_journal(journal_path);
      REQUIRE(journal.ok());
      {
        host::Journal kept = std::move(journal).value();
        rig.control.kept_journal = &kept;
        rig.on_executed = [&] {
          if (rig.executed.size() != at) return;
          if (resets) rig.wire->unplug();
          if (!resets) rig.control.stop = [] { return 1; };
        };
        CHECK_EQ(rig.print().exit_code, resets ? host::kExitLinkFault : host::kExitStopped);
        rig.control.kept_journal = nullptr;
      }
      rig.on_executed = nullptr;
      rig.control.stop = nullptr;
      if (resets) rig.port->controller().reset(rig.port->simulated_now());
      const auto read = host::read_journal(journal_path);
      REQUIRE(read.ok());
      core::Result<host::Journal> again = host::Journal::reopen(journal_path);
      REQUIRE(again.ok());
      rig.wire = std::make_unique<print_test::BreakablePort>(*rig.port);
      rig.print_plan = open_in_turn(settings, parts.paths);
      rig.control.kept_journal = &again.value();
      rig.options.resumption =
          host::Resumption{read.value().record, true, read.value().record.nozzle_z_um};
      const host::PrintOutcome outcome = rig.print();
      CAPTURE(outcome.message);
      CHECK_EQ(outcome.exit_code, host::kExitDone);
      CHECK_EQ(watch.first_hit(rig.executed).value_or("none"), "none");
      CHECK_EQ(watch.laid(), 4);
    }
  }
}

TEST_CASE("an object that is cancelled is left, and the next one begins") {
  const Parts parts;
  const core::Settings settings = in_turn();
  Rig whole(settings, open_in_turn(settings, parts.paths));
  const std::vector<host::PartObject> objects = whole.print_plan.part.summary.objects;
  REQUIRE_EQ(whole.print().exit_code, host::kExitDone);
  Rig rig(settings, open_in_turn(settings, parts.paths));
  int next = 1;
  rig.control.cancelled = [&]() -> std::optional<int> {
    // The one at hand, and the last one, which has not begun.
    if (rig.executed.size() < 150 || next > 4) return std::nullopt;
    return std::exchange(next, next + 3);
  };
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  CHECK_EQ(outcome.exit_code, host::kExitDone);
  HeadWatch watch(objects, settings.clearance_radius.mm());
  CHECK_EQ(watch.first_hit(rig.executed).value_or("none"), "none");
  CHECK_LT(laid_in(objects[0].box, rig.executed).size(),
           laid_in(objects[0].box, whole.executed).size());
  for (const std::size_t i : {1U, 2U}) {
    CHECK_EQ(laid_in(objects[i].box, rig.executed).size(),
             laid_in(objects[i].box, whole.executed).size());
  }
  CHECK(laid_in(objects[3].box, rig.executed).empty());
}

TEST_CASE("the last object is cancelled near the bed: the nozzle parks over those that stand") {
  const Parts parts;
  const core::Settings settings = in_turn();
  const std::size_t commands = compute(open_in_turn(settings, parts.paths)).texts.size();
  Rig rig(settings, open_in_turn(settings, parts.paths));
  const std::vector<host::PartObject> objects = rig.print_plan.part.summary.objects;
  bool asked = false;
  rig.control.cancelled = [&]() -> std::optional<int> {
    if (asked || rig.executed.size() < commands * 80 / 100) return std::nullopt;
    asked = true;
    return 4;
  };
  CHECK_EQ(rig.print().exit_code, host::kExitDone);
  // It has begun, and is no higher than it was then.
  const std::vector<LaidPiece> last = laid_in(objects[3].box, rig.executed);
  REQUIRE_FALSE(last.empty());
  CHECK_LT(last.back().height, objects[0].height.mm());
  HeadWatch watch(objects, settings.clearance_radius.mm());
  CHECK_EQ(watch.first_hit(rig.executed).value_or("none"), "none");
}
