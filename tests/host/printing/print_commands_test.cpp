#include "host/printing/print_commands.h"

#include <doctest/doctest.h>

#include <memory>

#include "tests/host/machine_samples.h"

namespace {

host::QueuedCommand command(std::int64_t x_um, bool lays_road = false) {
  host::QueuedCommand queued;
  firmware_link::Move move;
  move.x_um = x_um;
  queued.command = move;
  queued.lays_road = lays_road;
  queued.layer = x_um;
  return queued;
}

host::CommandQueue::Limits limits() { return {100, 1'000'000}; }

void push(host::CommandQueue& queue, const host::QueuedCommand& queued) {
  REQUIRE(queue.push(queued, sizeof queued));
}

}  // namespace

TEST_CASE("commands are taken in order, and the first road is remembered") {
  host::CommandQueue queue(limits());
  host::PrintCommands commands(queue);
  CHECK(commands.peek() == nullptr);
  CHECK_FALSE(commands.ended());
  for (int i = 0; i < 5; ++i) push(queue, command(i, i >= 2));
  queue.finish();
  for (int i = 0; i < 5; ++i) {
    CAPTURE(i);
    REQUIRE(commands.peek() != nullptr);
    CHECK_EQ(commands.peek()->layer, i);
    CHECK_EQ(commands.next(), i);
    CHECK_FALSE(commands.ended());
    commands.take();
    CHECK_EQ(commands.last().layer, i);
    CHECK_EQ(commands.first_road(), i < 2 ? 0 : 3);
    CHECK_EQ(commands.state().x_um, i);
  }
  CHECK(commands.ended());
}

TEST_CASE(
    "a new session is given from its first command on, out of the history and then the queue") {
  host::CommandQueue queue(limits());
  host::PrintCommands commands(queue);
  for (int i = 0; i < 6; ++i) push(queue, command(i));
  for (int i = 0; i < 4; ++i) commands.take();
  commands.resume(2, 3);
  CHECK_EQ(commands.session_first(), 3);
  CHECK(commands.next_was_executed());
  commands.skip();
  CHECK_EQ(commands.last().layer, 2);
  CHECK_FALSE(commands.next_was_executed());
  for (int i = 3; i < 6; ++i) {
    CAPTURE(i);
    REQUIRE(commands.peek() != nullptr);
    CHECK_EQ(commands.peek()->layer, i);
    commands.take();
  }
  CHECK(commands.peek() == nullptr);
  CHECK_EQ(commands.history().end(), 6);
}

TEST_CASE("a resumed print counts on from its journal, and waits for geometry") {
  host::CommandQueue queue(limits());
  host::PrintCommands commands(queue);
  commands.start_at(1'000, print_test::in_a_road(), {});
  CHECK_EQ(commands.state().x_um, 50'000);
  push(queue, command(1));
  CHECK_FALSE(commands.fill_history(1'002));
  CHECK_EQ(commands.next(), 1'001);
  push(queue, command(2));
  CHECK(commands.fill_history(1'002));
  CHECK_EQ(commands.first_road(), 0);  // nothing was given
  queue.finish();
  CHECK(commands.fill_history(1'003));  // there will be no more
  commands.resume(1'000, 1'001);
  CHECK(commands.next_was_executed());
  CHECK_EQ(commands.peek()->layer, 1);
}
