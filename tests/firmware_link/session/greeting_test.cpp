#include "firmware_link/session/greeting.h"

#include <doctest/doctest.h>

#include <chrono>
#include <string>

using namespace firmware_link;
using namespace std::chrono_literals;

namespace {

const std::string kGreeting = "\nN0M110*3\n";
const std::string kLineQuestion = "\nN99999999M105*55\n";

struct Bench {
  SessionOptions options;
  Instant now{};
  LifeSigns signs{now};
  Greeting greeting{now};
  OutputBuffer output;
  Phase phase = Phase::kBanner;

  // Until a step other than kWait is due, at most an hour.
  Greeting::Step wait() {
    for (const Instant end = now + 3600s; now < end; now += 50ms) {
      const auto step = greeting.look(phase, options, signs, now);
      if (step != Greeting::Step::kWait) return step;
    }
    return Greeting::Step::kWait;
  }
  std::string put() {
    greeting.put(phase, options, now, output);
    phase = Phase::kGreeting;
    const auto bytes = output.pending();
    std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    output.clear();
    return text;
  }
  bool hear(const std::string& line, Meaning meaning) {
    const Reply reply = read_reply(line);
    signs.heard(reply, meaning, now);
    return greeting.accepted_by(reply, meaning);
  }
};

}  // namespace

TEST_CASE("a controller that says nothing is greeted five times, and given up") {
  Bench bench;
  CHECK(bench.wait() == Greeting::Step::kGreet);
  CHECK(bench.now == Instant(2500ms));
  int greetings = 0;
  auto step = Greeting::Step::kGreet;
  for (; step != Greeting::Step::kGiveUp && greetings < 10; step = bench.wait()) {
    CHECK((step == Greeting::Step::kGreetLate) == (greetings == 1));
    CHECK(bench.put() == kGreeting);
    ++greetings;
  }
  CHECK(greetings == 5);
  CHECK(bench.now == Instant(17500ms));
  CHECK(bench.greeting.reason().find("no answer from the controller") == 0);
}

TEST_CASE("`start` is followed by a greeting when it is quiet, or after three seconds of talk") {
  Bench bench;
  bool talks = false;
  SUBCASE("quiet") {}
  SUBCASE("talk") { talks = true; }
  CHECK(bench.greeting.started(bench.now));
  (void)bench.hear("start", Meaning::kReset);
  auto step = Greeting::Step::kWait;
  for (; step == Greeting::Step::kWait; bench.now += 50ms) {
    if (talks) (void)bench.hear("echo:chatter", Meaning::kAlive);
    step = bench.greeting.look(bench.phase, bench.options, bench.signs, bench.now);
  }
  CHECK(bench.now == Instant(talks ? 3050ms : 250ms));
  for (int i = 0; i < 9; ++i) CHECK(bench.greeting.started(bench.now));
  CHECK_FALSE(bench.greeting.started(bench.now));
}

TEST_CASE("an ok accepts the greeting, but not the one that belongs to a refused line") {
  Bench bench;
  (void)bench.wait();
  (void)bench.put();
  SUBCASE("accepted") {
    CHECK_FALSE(bench.hear("Line: 0", Meaning::kNoise));
    CHECK(bench.hear("ok", Meaning::kAcknowledge));
  }
  SUBCASE("refused") {
    CHECK_FALSE(bench.hear("Error:checksum mismatch, Last Line: 3", Meaning::kRefused));
    CHECK_FALSE(bench.hear("Resend: 4", Meaning::kResend));
    CHECK_FALSE(bench.hear("ok", Meaning::kAcknowledge));
    CHECK_FALSE(bench.hear("ok", Meaning::kAcknowledge));
    const Instant refused = bench.now;
    CHECK(bench.wait() == Greeting::Step::kGreet);
    CHECK(bench.now - refused == 200ms);
    (void)bench.put();
    CHECK(bench.hear("ok", Meaning::kAcknowledge));
  }
}

TEST_CASE("the last line of the host before us is asked for first, at most twice") {
  Bench bench;
  bench.options.ask_found_line = true;
  SUBCASE("told") {
    (void)bench.wait();
    CHECK(bench.put() == kLineQuestion);
    CHECK_FALSE(bench.hear("Resend: 35", Meaning::kResend));
    CHECK(bench.greeting.found_line() == 34);
    CHECK_FALSE(bench.hear("ok", Meaning::kAcknowledge));
    (void)bench.wait();
    CHECK(bench.put() == kGreeting);
    CHECK(bench.greeting.started(bench.now));  // it has forgotten the line
    CHECK_FALSE(bench.greeting.found_line().has_value());
  }
  SUBCASE("it numbers nothing") {
    (void)bench.wait();
    CHECK(bench.put() == kLineQuestion);
    CHECK_FALSE(bench.hear("ok", Meaning::kAcknowledge));
    (void)bench.wait();
    CHECK(bench.put() == kGreeting);
  }
  SUBCASE("not answered") {
    (void)bench.wait();
    CHECK(bench.put() == kLineQuestion);
    (void)bench.wait();
    CHECK(bench.put() == kLineQuestion);
    (void)bench.wait();
    CHECK(bench.put() == kGreeting);
  }
  SUBCASE("it has just started") {
    CHECK(bench.greeting.started(bench.now));
    (void)bench.wait();
    CHECK(bench.put() == kGreeting);
  }
}

TEST_CASE("an unpacker that was left on is reset before every second greeting") {
  Bench bench;
  bench.options.pack = true;
  (void)bench.wait();
  const std::string reset = "\xff\xff\xf9";
  CHECK(bench.put() == kGreeting);
  (void)bench.wait();
  CHECK(bench.put() == reset + kGreeting);
  (void)bench.wait();
  CHECK(bench.put() == kGreeting);
}

TEST_CASE("a name is overdue after fifteen seconds") {
  Greeting greeting(Instant{});
  greeting.next_phase(Instant(10s));
  CHECK_FALSE(greeting.name_overdue(Instant(24s)));
  CHECK(greeting.name_overdue(Instant(25s)));
  greeting.bridge(5s, Instant(26s));
  CHECK_FALSE(greeting.name_overdue(Instant(29s)));
}
