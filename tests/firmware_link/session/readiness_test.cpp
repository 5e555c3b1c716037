#include "firmware_link/session/readiness.h"

#include <doctest/doctest.h>

#include <chrono>
#include <string>

#include "firmware_link/dialects/klipper_dialect.h"

using namespace firmware_link;
using namespace std::chrono_literals;
using Step = Readiness::Step;

namespace {

struct Bench {
  KlipperDialect dialect;
  Capabilities capabilities;
  Readiness readiness;
  Instant now{};
  bool to_resume = false;

  Bench() {
    readiness.start(now);
    CHECK(ask() == "STATUS");
  }
  std::string ask() {
    readiness.asks();
    return readiness.question(dialect);
  }
  // Lines without the `ok`, which answers.
  Step answer(std::initializer_list<const char*> lines) {
    for (const char* line : lines) readiness.heard(read_reply(line), dialect, capabilities);
    return readiness.answered(dialect, to_resume, now);
  }
  Step tick() { return readiness.tick(120s, now); }
};

}  // namespace

TEST_CASE("one that is ready is ready") {
  Bench bench;
  CHECK(bench.answer({"// Klipper state: Ready"}) == Step::kReady);
}

TEST_CASE("one that becomes ready is asked each second, and its words are told once") {
  Bench bench;
  CHECK(bench.answer({"!! Printer is not ready"}) == Step::kNotReady);
  CHECK(bench.readiness.words() == "Printer is not ready");
  CHECK(bench.tick() == Step::kWait);
  bench.now += 1s;
  CHECK(bench.tick() == Step::kAsk);
  CHECK(bench.ask() == "STATUS");
  CHECK(bench.tick() == Step::kWait);
  CHECK(bench.answer({"!! Printer is not ready"}) == Step::kWait);
  bench.now += 120s;
  CHECK(bench.tick() == Step::kFault);
  CHECK(bench.readiness.reason() ==
        "the controller did not become ready: \"Printer is not ready\"");
}

TEST_CASE("one that never answers, or does not become ready by itself, is a fault") {
  Bench bench;
  SUBCASE("no answer") {
    bench.now += 121s;
    CHECK(bench.tick() == Step::kFault);
    CHECK(bench.readiness.reason() == "the controller did not answer whether it is ready");
  }
  SUBCASE("a fault of its own") {
    CHECK(bench.answer({"!! Option 'x' is not valid"}) == Step::kFault);
    CHECK(bench.readiness.reason() == "the controller is not ready: \"Option 'x' is not valid\"");
  }
  SUBCASE("the host stood still") {
    bench.now += 121s;
    bench.readiness.bridge(100s, bench.now);
    CHECK(bench.tick() == Step::kWait);
  }
}

TEST_CASE("to resume, its position, its commands and whether it is homed are asked for") {
  for (const bool homed : {true, false}) {
    Bench bench;
    bench.to_resume = true;
    CHECK(bench.answer({}) == Step::kAsk);
    CHECK(bench.ask() == "M114");
    CHECK(bench.answer({"X:10.500 Y:20.000 Z:5.200 E:1.000"}) == Step::kAsk);
    CHECK(bench.ask() == "HELP");
    CHECK(bench.answer({"// SET_KINEMATIC_POSITION: Force a position"}) == Step::kAsk);
    CHECK(bench.capabilities.sets_position);
    CHECK(bench.ask() == "G90");
    CHECK(bench.answer({}) == Step::kAsk);
    CHECK(bench.ask() == "G1 Z5.201 F60");
    CHECK_FALSE(bench.readiness.found_homed().has_value());
    const char* refused = "!! Must home axis first: 10.5 20.0 5.2 [0.0]";
    CHECK((homed ? bench.answer({}) : bench.answer({refused})) == Step::kReady);
    CHECK(bench.readiness.found_homed() == homed);
    CHECK(bench.readiness.found_position()->z_mm == 5.2);
  }
}

TEST_CASE("without a height that a printer can have, nothing is moved") {
  Bench bench;
  bench.to_resume = true;
  CHECK(bench.answer({}) == Step::kAsk);
  SUBCASE("none told") { CHECK(bench.answer({}) == Step::kAsk); }
  SUBCASE("too large") {
    CHECK(bench.answer({"X:1.000 Y:2.000 Z:500000.000 E:1.000"}) == Step::kAsk);
  }
  CHECK(bench.ask() == "HELP");
  CHECK(bench.answer({}) == Step::kReady);
}
