#include "firmware_link/session/silence_watch.h"

#include <doctest/doctest.h>

#include <chrono>
#include <string>

#include "firmware_link/dialects/klipper_dialect.h"
#include "firmware_link/dialects/marlin_dialect.h"

using namespace firmware_link;
using namespace std::chrono_literals;
using Step = SilenceWatch::Step;

namespace {

struct Bench {
  LinkRules rules = MarlinDialect().rules();
  SilenceWatch watch{Duration(0)};
  SilenceWatch::Sight sight;
  Instant now{};

  explicit Bench(const char* text) {
    sight.head = 1;
    sight.text = text;
    sight.command = wait_of(text, false);
    sight.may_ask = true;
    sight.may_resynchronise = true;
    CHECK(watch.look(rules, sight, now) == Step::kWait);
  }
  // Until something is to be done, at most two days.
  Step wait() {
    for (const Instant end = now + 48h; now < end;) {
      now += 100ms;
      const Step step = watch.look(rules, sight, now);
      if (step == Step::kAsk) watch.asked(now);
      if (step != Step::kWait) return step;
    }
    return Step::kWait;
  }
};

}  // namespace

TEST_CASE(
    "numbered lines: asked after 5 s, after 1 s where the nozzle stands, then resynchronised") {
  Bench bench("G1X1");
  SUBCASE("it moves") {
    CHECK(bench.wait() == Step::kAsk);
    CHECK(bench.now == Instant(5100ms));
    CHECK(bench.wait() == Step::kResynchronise);
    CHECK(bench.now == Instant(6100ms));
  }
  SUBCASE("it stands") {
    bench.sight.stands = true;
    CHECK(bench.wait() == Step::kAsk);
    CHECK(bench.now == Instant(1100ms));
    CHECK(bench.wait() == Step::kAsk);
    CHECK(bench.now == Instant(2200ms));
    CHECK(bench.wait() == Step::kAsk);
    CHECK(bench.now == Instant(4300ms));  // twice as long
  }
  SUBCASE("no resynchronisation is left") {
    bench.sight.may_ask = bench.sight.may_resynchronise = false;
    CHECK(bench.wait() == Step::kGiveUp);
    CHECK(bench.watch.reason() == "the controller has not answered for 6 s");
  }
}

TEST_CASE("temperatures hide a lost answer for two minutes, and what is planned") {
  Bench bench("G1X1");
  bench.sight.planner_time = 10s;
  Step step = Step::kWait;
  int asked = 0;
  while (step != Step::kGiveUp && bench.now < Instant(1h)) {
    bench.now += 1s;
    bench.sight.last_life = bench.now;
    step = bench.watch.look(bench.rules, bench.sight, bench.now);
    if (step == Step::kAsk) bench.watch.asked(bench.now), ++asked;
  }
  CHECK(bench.now == Instant(131s));
  CHECK(asked == 5);
  CHECK(bench.watch.reason() == "the controller talks, but has not answered for 131 s");
}

TEST_CASE("a long command has its own limit, unless the controller says when it is busy") {
  Bench bench("G28");
  bench.sight.may_ask = false;
  SUBCASE("silent firmware") {
    CHECK(bench.wait() == Step::kGiveUp);
    CHECK(bench.now == Instant(10min + 100ms));
    CHECK(bench.watch.reason() == "the controller has not answered for 600 s, during homing (G28)");
  }
  SUBCASE("it said that it was busy, and stops saying so") {
    bench.watch.worked();
    CHECK(bench.wait() == Step::kResynchronise);
    CHECK(bench.now == Instant(6100ms));
  }
  SUBCASE("busy lines for ever") {
    while (bench.now < Instant(14min)) {
      bench.now += 2s;
      bench.watch.worked();
      bench.sight.last_progress = bench.sight.last_life = bench.now;
      CHECK(bench.watch.look(bench.rules, bench.sight, bench.now) == Step::kWait);
    }
    bench.now += 61s;
    CHECK(bench.watch.look(bench.rules, bench.sight, bench.now) == Step::kGiveUp);
    CHECK(bench.watch.reason().find("has been busy with homing (G28) for") != std::string::npos);
  }
  SUBCASE("busy lines while its user is waited for") {
    bench.watch.await_user(true);
    CHECK(bench.watch.user_awaited());
    bench.now += 23h;
    bench.watch.worked();
    bench.sight.last_progress = bench.sight.last_life = bench.now;
    CHECK(bench.watch.look(bench.rules, bench.sight, bench.now) == Step::kWait);
  }
}

TEST_CASE("one question waits behind a long command, another follows when it is not answered") {
  Bench bench("G28");
  CHECK(bench.wait() == Step::kAsk);
  CHECK(bench.now == Instant(1100ms));
  bench.sight.questions = 1;
  CHECK(bench.wait() == Step::kAsk);
  CHECK(bench.now == Instant(5200ms));
}

TEST_CASE("the host's limit raises each of the others, and a host that stood still is forgiven") {
  Bench bench("G1X1");
  bench.rules = KlipperDialect().rules();
  bench.sight.may_ask = bench.sight.may_resynchronise = false;
  SUBCASE("the limit") {
    bench.watch = SilenceWatch(20min);
    CHECK(bench.wait() == Step::kGiveUp);
    CHECK(bench.now == Instant(20min + 100ms));
  }
  SUBCASE("a gap") {
    bench.now += 100s;
    bench.watch.bridge(100s, bench.now);
    bench.sight.last_life = bench.sight.last_progress = bench.now;
    CHECK(bench.wait() == Step::kGiveUp);
    CHECK(bench.watch.reason() == "the controller has not answered for 900 s");
  }
}

TEST_CASE("a wait is told once, when it takes a while") {
  Bench bench("G28");
  CHECK_FALSE(bench.watch.tells_wait(bench.sight, Instant(4s)));
  CHECK(bench.watch.tells_wait(bench.sight, Instant(5s)));
  CHECK_FALSE(bench.watch.tells_wait(bench.sight, Instant(60s)));
  CHECK(SilenceWatch::what_of(bench.sight) == "homing (G28)");
  bench.sight.head = 2;
  (void)bench.watch.look(bench.rules, bench.sight, Instant(60s));
  CHECK(bench.watch.tells_wait(bench.sight, Instant(66s)));
  bench.watch.over();
  CHECK_FALSE(bench.watch.tells_wait(bench.sight, Instant(100s)));
}
