// The session against the virtual controller over a wire that damages bytes and lines: whatever it
// does, each command is executed exactly once and in order, or the session ends with a reason; it
// never hangs.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "tests/firmware_link/virtual_link.h"

using namespace link_test;
using namespace std::chrono_literals;

namespace {

constexpr int kSeeds = 10;
constexpr std::size_t kCommands = 120;

struct Outcome {
  int finished = 0;
  int damages = 0;
  int repeated = 0;
  int resyncs = 0;
};

// Fragments that a flush leaves behind come without a number. Almost all are no command at all;
// any that is one must have shown up as an acknowledgement that no line of ours explains.
void check_fragments(const VirtualLink& link) {
  const auto fragments = std::count_if(link.executed.begin(), link.executed.end(), [](auto& one) {
    return !one.numbered && one.known && one.text.substr(0, 4) != "M105";
  });
  if (fragments > 0) {
    CHECK(link.session->statistics().stray_acknowledgements + link.session->statistics().resends >
          0);
  }
}

Outcome check_damage(const Damage& down, const Damage& up, const VirtualControllerOptions& options,
                     const SessionOptions& session_options = {}) {
  Outcome outcome;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    CAPTURE(seed);
    VirtualLink link(options, session_options, down, up, seed);
    const auto commands = moves(kCommands, seed);
    const auto texts = texts_of(commands);
    const bool ended = link.run(commands, 3600s);
    CAPTURE(link.session->reason());
    CAPTURE(link.heard);
    REQUIRE(ended);
    link.let_controller_work();
    const auto printed = link.printed();
    const auto differs = std::mismatch(printed.begin(), printed.end(), texts.begin(), texts.end());
    CAPTURE(printed.size());
    CAPTURE(static_cast<int>(differs.first - printed.begin()));
    CAPTURE((differs.first == printed.end() ? std::string("end") : *differs.first));
    CAPTURE((differs.second == texts.end() ? std::string("end") : *differs.second));
    if (link.session->state() == SessionState::kFinished) {
      ++outcome.finished;
      CHECK(printed == texts);
    } else {
      CHECK(link.session->state() == SessionState::kFaulted);
      CHECK_FALSE(link.session->reason().empty());
      // The one fault that means that a line ran damaged, its checksum none the less right.
      if (link.session->fault_kind() == firmware_link::FaultKind::kPosition) continue;
      REQUIRE(printed.size() <= texts.size());
      CHECK(std::equal(printed.begin(), printed.end(), texts.begin()));
    }
    check_fragments(link);
    const auto statistics = link.session->statistics();
    CHECK(statistics.lines_in_flight_max <= firmware_link::kWindowLinesMax);
    CHECK(statistics.bytes_in_flight_max <= firmware_link::kWindowBytesMax);
    outcome.damages += link.damages();
    outcome.repeated += static_cast<int>(statistics.lines_repeated);
    outcome.resyncs += static_cast<int>(statistics.resyncs);
  }
  MESSAGE("finished " << outcome.finished << " of " << kSeeds << ", damages " << outcome.damages
                      << ", lines repeated " << outcome.repeated << ", resyncs "
                      << outcome.resyncs);
  CHECK(outcome.damages > 0);
  return outcome;
}

VirtualControllerOptions fast() { return {}; }

VirtualControllerOptions real() {
  VirtualControllerOptions options;
  options.baud = 115200;
  options.command_cost = 1100us;
  return options;
}

VirtualControllerOptions advanced() {
  VirtualControllerOptions options = real();
  options.advanced_ok = true;
  return options;
}

}  // namespace

TEST_CASE("damage on the way to the controller") {
  for (const auto& options : {fast(), real(), advanced()}) {
    CAPTURE(options.baud);
    CAPTURE(options.advanced_ok);
    Damage down;
    SUBCASE("lost bytes") { down.lose = 2e-3; }
    SUBCASE("flipped bits") { down.flip = 2e-3; }
    SUBCASE("doubled bytes") { down.duplicate = 2e-3; }
    SUBCASE("lost line ends") { down.lose_line_end = 0.03; }
    SUBCASE("lost lines") { down.lose_line = 0.03; }
    SUBCASE("doubled lines") { down.duplicate_line = 0.03; }
    SUBCASE("all of it") { down = {5e-4, 5e-4, 5e-4, 0.01, 0.01, 0.01, 100}; }
    const Outcome outcome = check_damage(down, {}, options);
    CHECK(outcome.finished >= kSeeds * 9 / 10);
  }
}

TEST_CASE("damage on the way back") {
  for (const auto& options : {fast(), real(), advanced()}) {
    CAPTURE(options.baud);
    CAPTURE(options.advanced_ok);
    Damage up;
    up.distance = 40;
    SUBCASE("lost bytes") { up.lose = 4e-3; }
    SUBCASE("flipped bits") { up.flip = 4e-3; }
    SUBCASE("lost lines") { up.lose_line = 0.03; }
    SUBCASE("doubled lines: an ok more than was said") { up.duplicate_line = 0.03; }
    SUBCASE("all of it") { up = {1e-3, 1e-3, 1e-3, 0.01, 0.01, 0.01, 40}; }
    const Outcome outcome = check_damage({}, up, options);
    CHECK(outcome.finished >= kSeeds * 9 / 10);
  }
}

TEST_CASE("damage both ways, at a rate where a line seldom gets through, ends with a reason") {
  Damage bad;
  SUBCASE("a damage in almost every line") {
    bad.lose = bad.flip = bad.duplicate = 0.02;
    bad.distance = 45;
  }
  SUBCASE("most lines lost") {
    bad.lose_line = 0.9;
    bad.distance = 0;
  }
  (void)check_damage(bad, bad, real());
}

TEST_CASE("numbering that starts again survives damage") {
  SessionOptions options;
  options.line_number_max = 20;
  Damage down;
  Damage up;
  SUBCASE("all of it") {
    down = up = {5e-4, 5e-4, 5e-4, 0.01, 0.01, 0.01, 100};
    up.distance = 60;
  }
  SUBCASE("an ok too many before the numbers end") { up.duplicate_line = 0.15; }
  const Outcome outcome = check_damage(down, up, real(), options);
  CHECK(outcome.finished > kSeeds / 2);
}
