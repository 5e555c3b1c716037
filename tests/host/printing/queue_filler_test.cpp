#include "host/printing/queue_filler.h"

#include <doctest/doctest.h>

#include <string>
#include <variant>
#include <vector>

#include "firmware_link/wire/line_codec.h"

namespace {

firmware_link::Command move_to(std::int64_t x_um) {
  firmware_link::Move move;
  move.x_um = x_um;
  return move;
}

core::Point at_mm(std::int32_t x) { return {x * 10'000, 0}; }

// A print of two layers with a road of `roads` pieces each, 1 mm and 0.1 s a piece.
void fill(host::QueueFiller& filler, int roads) {
  for (int layer = 0; layer < 2; ++layer) {
    host::Checkpoint checkpoint;
    checkpoint.layer = layer;
    checkpoint.commands = layer * (roads + 1);
    filler.start_layer(checkpoint);
    if (!filler.take(core::LayerStart{layer, core::Length::from_mm(layer + 1), {}}, std::nullopt)) {
      return;
    }
    if (!filler.take(core::Travel{at_mm(0), 10}, move_to(0))) return;
    for (int i = 1; i <= roads; ++i) {
      if (!filler.take(core::Extrude{at_mm(i), 0.5, 10}, move_to(i * 1'000))) return;
    }
  }
}

std::vector<host::QueuedCommand> all_in(host::CommandQueue& queue) {
  std::vector<host::QueuedCommand> all;
  while (auto queued = queue.try_pop()) all.push_back(std::move(*queued));
  return all;
}

host::CommandQueue::Limits limits() { return {1'000, 10'000'000}; }

}  // namespace

TEST_CASE("each command carries its layer, filament, time and hash") {
  host::CommandQueue queue(limits());
  host::QueueFiller filler(queue, core::Settings(), nullptr);
  fill(filler, 3);
  REQUIRE(filler.finish());
  const std::vector<host::QueuedCommand> all = all_in(queue);
  REQUIRE_EQ(all.size(), 8);
  CHECK_EQ(all[0].layer, 1);
  CHECK_FALSE(all[0].lays_road);
  CHECK(all[1].lays_road);
  CHECK_EQ(all[3].filament_mm, doctest::Approx(1.5));
  CHECK_EQ(all[3].seconds, doctest::Approx(0.3));
  CHECK_EQ(all[4].layer, 2);
  CHECK_EQ(all[4].top, core::Length::from_mm(2));
  CHECK_EQ(all[7].filament_mm, doctest::Approx(3));
  CHECK_EQ(filler.seconds_made(), doctest::Approx(all[7].seconds));
  // The hash is of the layer's own texts: both layers have the same ones.
  CHECK_EQ(all[0].hash, all[4].hash);
  CHECK_EQ(all[3].hash, all[7].hash);
  CHECK_NE(all[2].hash, all[3].hash);
  CHECK_EQ(all[1].hash, host::hash_of("G0 X0\nG0 X1\n"));
  CHECK_EQ(all[7].checkpoint->layer, 1);
}

TEST_CASE("a pause goes with the next command, once") {
  host::CommandQueue queue(limits());
  host::QueueFiller filler(queue, core::Settings(), nullptr);
  filler.pause("why");
  fill(filler, 1);
  const std::vector<host::QueuedCommand> all = all_in(queue);
  REQUIRE(all[0].pause != nullptr);
  CHECK_EQ(all[0].pause->why.substr(0, 4), "why;");
  CHECK(all[1].pause == nullptr);
}

TEST_CASE("a resumed print drops what was executed, if it is the same print") {
  host::CommandQueue whole_queue(limits());
  host::QueueFiller whole_filler(whole_queue, core::Settings(), nullptr);
  fill(whole_filler, 5);
  const std::vector<host::QueuedCommand> whole = all_in(whole_queue);

  host::JournalRecord record;
  record.checkpoint = *whole[2].checkpoint;
  record.sure = 3;
  record.sure_hash = whole[2].hash;
  for (const bool same : {true, false}) {
    CAPTURE(same);
    if (!same) ++record.sure_hash;
    host::CommandQueue queue(limits());
    host::QueueFiller filler(queue, core::Settings(), &record);
    fill(filler, 5);
    CHECK_EQ(filler.finish(), same);
    CHECK_EQ(filler.error().has_value(), !same);
    const std::vector<host::QueuedCommand> rest = all_in(queue);
    CHECK_EQ(rest.size(), same ? whole.size() - 3 : 0);
    if (!same) continue;
    REQUIRE(rest[0].before != nullptr);
    CHECK_EQ(rest[0].before->x_um, 2'000);
    CHECK(rest[1].before == nullptr);
    CHECK_EQ(rest[0].hash, whole[3].hash);
    CHECK_EQ(rest.back().filament_mm, whole.back().filament_mm);
  }
}

TEST_CASE("a print that ends before the resume point is another print") {
  host::JournalRecord record;
  record.sure = 100;
  host::CommandQueue queue(limits());
  host::QueueFiller filler(queue, core::Settings(), &record);
  fill(filler, 2);
  CHECK_FALSE(filler.finish());
  REQUIRE(filler.error().has_value());
  CHECK_NE(filler.error()->find("not the one"), std::string::npos);
}

TEST_CASE("a closed queue takes nothing") {
  host::CommandQueue queue(limits());
  host::QueueFiller filler(queue, core::Settings(), nullptr);
  queue.close();
  CHECK_FALSE(filler.take(core::Travel{at_mm(0), 10}, move_to(0)));
}
