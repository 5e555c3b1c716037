#include "firmware_link/session/packing.h"

#include <doctest/doctest.h>

#include <chrono>
#include <string>

using namespace firmware_link;
using namespace std::chrono_literals;

namespace {

const std::string kAsking = std::string(kMeatPackReset) + std::string(kMeatPackOn);

struct Bench {
  Packing packing;
  OutputBuffer output;
  Instant now{};
  Packing::Sight sight{true, true, 10, 10, false};

  bool may_send() { return packing.may_send(sight, now, output); }
  void tick() { packing.tick(sight, now, output); }
  std::string taken() {
    const auto bytes = output.pending();
    std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    output.clear();
    return text;
  }
  void turn_on() {
    CHECK_FALSE(may_send());
    CHECK(taken() == kAsking);
    packing.heard("[MP] PV01 ON ESP");
    CHECK(packing.on());
  }
};

}  // namespace

TEST_CASE("packing is asked for when nothing is in flight, and lines wait for the answer") {
  Bench bench;
  bench.sight.in_flight = true;
  CHECK_FALSE(bench.may_send());
  CHECK(bench.taken().empty());
  CHECK_FALSE(bench.packing.may_unpack());
  bench.sight.in_flight = false;
  CHECK_FALSE(bench.may_send());
  CHECK(bench.taken() == kAsking);
  CHECK_FALSE(bench.may_send());
  CHECK(bench.packing.may_unpack());
  bench.packing.heard("[MP] PV01 OFF ESP");
  CHECK_FALSE(bench.packing.on());
  bench.packing.heard("[MP] PV01 ON ESP");
  CHECK(bench.packing.on());
  CHECK(bench.may_send());
}

TEST_CASE("it is not asked for where it is not allowed, not calm, or something is repeated") {
  Bench bench;
  SUBCASE("not allowed") { bench.sight.allowed = false; }
  SUBCASE("not calm") { bench.sight.calm = false; }
  SUBCASE("repeated") { bench.sight.sent_end = 12; }
  CHECK(bench.may_send());
  CHECK(bench.taken().empty());
}

TEST_CASE("three questions without an answer are enough, and a late answer changes nothing") {
  Bench bench;
  CHECK_FALSE(bench.may_send());
  for (int i = 0; i < 2; ++i) {
    (void)bench.taken();
    bench.now += 1s;
    bench.tick();
    CHECK(bench.taken() == kAsking);
  }
  bench.now += 500ms;
  bench.packing.bridge(500ms, bench.now);  // the host stood still
  bench.now += 500ms;
  bench.tick();
  CHECK(bench.taken().empty());
  bench.now += 500ms;
  bench.tick();
  CHECK(bench.taken() == kMeatPackReset);
  CHECK(bench.may_send());
  bench.packing.heard("[MP] PV01 ON ESP");
  CHECK_FALSE(bench.packing.on());
}

TEST_CASE("a line goes packed where that is shorter, and eight lines go plain behind a stop") {
  Bench bench;
  bench.turn_on();
  PackedBuffer buffer;
  const auto packed = bench.packing.bytes_of("N12G1X10.5*23", bench.sight, buffer, bench.output);
  REQUIRE(packed.has_value());
  CHECK(packed->size() < 13);
  // Capital letters take a byte more each.
  bench.sight.in_flight = true;
  const std::string words = "N13M117 HELLO WORLD*45";
  CHECK_FALSE(bench.packing.bytes_of(words, bench.sight, buffer, bench.output).has_value());
  bench.sight.in_flight = false;
  const auto plain = bench.packing.bytes_of(words, bench.sight, buffer, bench.output);
  REQUIRE(plain.has_value());
  CHECK(*plain == words + "\n");
  CHECK(bench.taken() == kMeatPackReset);
  CHECK_FALSE(bench.packing.on());
  for (std::int64_t line = 10; line < 20; ++line) {
    bench.sight.next_to_send = bench.sight.sent_end = line;
    CHECK(bench.may_send() == (line < 18));
  }
}
