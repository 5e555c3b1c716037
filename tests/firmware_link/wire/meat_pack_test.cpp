// Packed lines: alone, and in a session whose wire damages them.
#include "firmware_link/wire/meat_pack.h"

#include <doctest/doctest.h>

#include <chrono>
#include <string>

#include "firmware_link/wire/line_codec.h"
#include "tests/firmware_link/controller_bench.h"
#include "tests/firmware_link/scenarios/scenario_checks.h"

using namespace link_test;
using namespace std::chrono_literals;

namespace {

std::string unpacked(MeatUnpacker& unpacker, std::string_view bytes) {
  std::string text;
  for (const char byte : bytes) {
    const MeatUnpacker::Result read = unpacker.take(static_cast<std::uint8_t>(byte));
    CHECK_FALSE(read.refused);
    text.append(read.characters.data(), read.count);
  }
  return text;
}

}  // namespace

TEST_CASE("what is packed is unpacked, every line on a byte of its own") {
  MeatUnpacker unpacker;
  CHECK(unpacked(unpacker, kMeatPackOn).empty());
  CHECK(unpacker.state() == "ON ESP");
  SplitMix random(7);
  for (int i = 0; i < 2'000; ++i) {
    CAPTURE(i);
    std::string line;
    const std::size_t size = 1 + random.below(kLineBytesMax);
    const bool moves = random.below(4) > 0;
    while (line.size() < size) {
      line.push_back(moves ? "0123456789. GXYEN*-"[random.below(19)]
                           : static_cast<char>(' ' + random.below(95)));
    }
    PackedBuffer buffer;
    const std::string_view packed = meat_packed(line, buffer);
    CHECK(packed.size() <= buffer.size());
    CHECK(unpacked(unpacker, packed) == line + "\n");
  }
  PackedBuffer buffer;
  CHECK(meat_packed("G1X10.5", buffer) == std::string("\x1d\x1e\xa0\xc5", 4));
  CHECK(meat_packed("G1X10.", buffer) == std::string("\x1d\x1e\xa0\x0c", 4));
}

TEST_CASE("a move takes three fifths of its bytes") {
  PackedBuffer buffer;
  const std::string line = "N12345G1X123.456Y78.901 E.01234*123";
  CHECK(meat_packed(line, buffer).size() <= (line.size() + 1) * 3 / 5 + 1);
}

// Why it is off unless it is asked for.
TEST_CASE("a byte that holds two digits alike can be lost, and the checksum does not tell") {
  LineBuffer line_buffer;
  PackedBuffer buffer;
  const auto unnoticed = [&](std::string_view text) {
    const std::string packed(meat_packed(number_line(12, text, line_buffer), buffer));
    int count = 0;
    for (std::size_t i = 0; i < packed.size(); ++i) {
      std::string damaged = packed;
      damaged.erase(i, 1);
      MeatUnpacker unpacker;
      (void)unpacked(unpacker, kMeatPackOn);
      std::string line = unpacked(unpacker, damaged);
      if (line.empty() || line.back() != '\n') continue;
      line.pop_back();
      const NumberedText parts = take_apart(line);
      count += parts.number == 12 && parts.checksum_matches && parts.text != text ? 1 : 0;
    }
    return count;
  };
  CHECK(unnoticed("G1X10.5Y23 E.0142") == 0);
  CHECK(unnoticed("G1X33.5") == 1);
}

TEST_CASE("the virtual controller unpacks where it offers to, and says so") {
  VirtualControllerOptions options;
  options.meatpack = true;
  Bench bench(options);
  CHECK(bench.say(std::string(kMeatPackOn)) == "[MP] PV01 ON ESP\n");
  PackedBuffer buffer;
  CHECK(bench.say(std::string(meat_packed("G1X10F600", buffer))) == "ok\n");
  CHECK(bench.say(std::string("\xff\xff\xf8")) == "[MP] PV01 ON ESP\n");
  CHECK(bench.say(std::string("\xff\xff\xf7")) == "[MP] PV01 ON NSP\n");
  CHECK(bench.say(std::string(kMeatPackReset)) == "[MP] PV01 OFF ESP\n");
  CHECK(bench.say("M114\n").substr(0, 7) == "X:10.00");
  CHECK(bench.say("\xd1\n") == "Error:Serial status mismatch\n");
}

TEST_CASE("lines are packed once it answers, and not where nobody wants it") {
  for (const bool wanted : {true, false}) {
    CAPTURE(wanted);
    const Scenario* scenario = find_scenario(wanted ? "packed" : "clean");
    REQUIRE(scenario != nullptr);
    ScenarioRun run(*scenario, 1, kMishapLines);
    const auto commands = print_of(*scenario, 1);
    REQUIRE(run.run(commands, 1h));
    CHECK(run.session->state() == SessionState::kFinished);
    CHECK(run.printed == texts_of(commands));
    const SessionStatistics statistics = run.session->statistics();
    CHECK((statistics.lines_packed > 20) == wanted);
    CHECK(statistics.resends == 0);
  }
}
