#include "firmware_link/session/safe_stop.h"

#include <doctest/doctest.h>

#include <chrono>
#include <string>
#include <vector>

using namespace firmware_link;
using namespace std::chrono_literals;

TEST_CASE("the safe sequence is told command by command, or as plain lines") {
  SafeStop stop(Instant{});
  CHECK(stop.all_taken());
  const Command commands[] = {SetTemperature{Heater::kNozzle, 0, false}, SetFan{}};
  stop.set_sequence(commands);
  CHECK_FALSE(stop.has_start());
  stop.starts_at(12);
  CHECK(stop.has_start());
  CHECK(stop.take() == "M104 S0");
  CHECK(stop.take() == "M107");
  CHECK(stop.all_taken());
  OutputBuffer output;
  stop.put_plain(output);
  const auto bytes = output.pending();
  CHECK(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()) ==
        "\nM104 S0\nM107\nM105\n");
}

TEST_CASE("no more plain lines are put than a window holds") {
  SafeStop stop(Instant{});
  Move move;
  move.x_um = move.y_um = move.z_um = 123'456'789;
  const std::vector<Command> commands(kSafeSequenceMax, move);
  stop.set_sequence(commands);
  OutputBuffer output;
  stop.put_plain(output);
  CHECK(output.pending().size() <= kWindowBytesMax + 5);
  CHECK(output.pending().size() > kWindowBytesMax / 2);
}

TEST_CASE("a stop has ten seconds, behind a long command ten minutes, and says that it waits") {
  const SessionOptions options;
  SafeStop stop(Instant{});
  const Instant start(5s);
  bool works = false;
  Duration limit = 10s;
  SUBCASE("nothing long") { stop.start(std::nullopt, start); }
  SUBCASE("behind a homing") {
    stop.start("G28", start);
    limit = 600s;
  }
  SUBCASE("it says that it works") {
    stop.start(std::nullopt, start);
    works = true;
    limit = 600s;
  }
  CHECK_FALSE(stop.tells_wait(works, start + 2s));
  CHECK(stop.tells_wait(works, start + 3s) == (limit == 600s));
  CHECK_FALSE(stop.tells_wait(works, start + 4s));
  CHECK_FALSE(stop.overdue(options, works, Instant{}, start + limit).has_value());
  CHECK(stop.overdue(options, works, Instant{}, start + limit + 1ms) == limit + 1ms);
  // What was planned moves first.
  CHECK_FALSE(stop.overdue(options, works, start + 2s, start + limit + 2s).has_value());
  stop.bridge(5s, start + limit + 5s);
  CHECK_FALSE(stop.overdue(options, works, Instant{}, start + limit + 5s).has_value());
}

TEST_CASE("what it waited for is over with the first safe line") {
  const SessionOptions options;
  SafeStop stop(Instant{});
  stop.start("G28", Instant{});
  stop.acknowledged(100, Instant(50s));
  CHECK(stop.behind() == "G28");
  stop.starts_at(7);
  stop.acknowledged(7, Instant(60s));
  CHECK(stop.behind() == "G28");
  stop.acknowledged(8, Instant(70s));
  CHECK_FALSE(stop.behind().has_value());
  CHECK_FALSE(stop.overdue(options, false, Instant{}, Instant(80s)).has_value());
  CHECK(stop.overdue(options, false, Instant{}, Instant(81s)).has_value());
}

TEST_CASE("temperatures behind a fault tell whether the heaters are to be off") {
  SafeStop stop(Instant{});
  CHECK_FALSE(stop.listens());
  stop.listen();
  CHECK(stop.listens());
  stop.told(read_reply("ok").temperatures);
  stop.told(read_reply(" T:200.0 /0.0 B:60.0 /60.0").temperatures);
  CHECK_FALSE(stop.confirmed());
  stop.told(read_reply(" T:199.0 /0.0 B:60.0 /0.0").temperatures);
  CHECK(stop.confirmed());
}
