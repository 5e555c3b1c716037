#include "firmware_link/session/temperature_watch.h"

#include <doctest/doctest.h>

#include <chrono>
#include <string>

using namespace firmware_link;
using namespace std::chrono_literals;

TEST_CASE("what is not told keeps its value") {
  TemperatureWatch watch;
  watch.told(read_reply(" T:200.0 /210.0 B:60.0 /60.0").temperatures);
  watch.told(read_reply(" T:201.0 /210.0").temperatures);
  CHECK(watch.known().nozzle_celsius == 201);
  CHECK(watch.known().bed_target_celsius == 60);
}

TEST_CASE("either heater that does not rise is complained of by its name") {
  for (const bool bed : {false, true}) {
    const std::string line = bed ? " T:210.0 /210.0 B:25.0 /60.0" : " T:25.0 /210.0 B:60.0 /60.0";
    TemperatureWatch watch;
    std::optional<std::string> words;
    Instant now{};
    for (; now < Instant(600s) && !words; now += 2s) {
      words = watch.complaint(read_reply(line).temperatures, now);
    }
    REQUIRE(words.has_value());
    CHECK(words->find(bed ? "the bed does not get warmer" : "the nozzle does not get warmer") == 0);
    CHECK(now > Instant(bed ? 240s : 60s));
  }
}
