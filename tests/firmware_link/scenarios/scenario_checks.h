// How a scenario is played and judged: all motions executed exactly once and in order, or a safe
// stop for a reason that the scenario names. Simulated time is bounded: nothing hangs.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "tests/firmware_link/scenarios/scenario_run.h"
#include "tools/faults/scenario.h"

namespace link_test {

using namespace std::chrono_literals;

// How many seeds each: RIND_SCENARIO_SEEDS, otherwise `usual`.
inline std::uint64_t seeds_or(std::uint64_t usual) {
  const char* wanted = std::getenv("RIND_SCENARIO_SEEDS");
  const std::uint64_t count = wanted == nullptr ? 0 : std::strtoull(wanted, nullptr, 10);
  return count > 0 ? count : usual;
}
inline constexpr std::size_t kCommands = 30;
// The mishap comes before this many lines have passed, the heating after.
inline constexpr std::size_t kMishapLines = 10;

// Whether a scenario's word is one that its user writes.
inline bool is_users(std::string_view word) {
  return !word.empty() && word != "G92" && word != "M114" && word != "M109" && word != "M107" &&
         word != "M84";
}

// Short moves with filament, no two the same; a wait for heat among them.
inline std::vector<Command> print_of(const Scenario& scenario, std::uint64_t seed) {
  SplitMix random(seed);
  std::vector<Command> commands;
  commands.emplace_back(std::get<Verbatim>(verbatim_from("M83")));
  while (commands.size() < kCommands) {
    if (commands.size() == 16) commands.emplace_back(SetTemperature{Heater::kNozzle, 600, true});
    if (commands.size() == 20 && is_users(scenario.word)) {
      commands.emplace_back(std::get<Verbatim>(verbatim_from(scenario.word)));
    }
    Move move;
    move.extruding = true;
    move.x_um = 20'000 + static_cast<std::int64_t>(random.below(160'000));
    move.y_um = 20'000 + static_cast<std::int64_t>(commands.size());
    if (scenario.every_move_extrudes) {
      move.e_10nm = 2'000 + static_cast<std::int64_t>(random.below(7'000));
    } else if (random.below(3) > 0) {
      move.e_10nm = static_cast<std::int64_t>(random.below(9'000));
    }
    if (commands.size() == 1) move.f_mm_min = 12'000;
    commands.emplace_back(move);
  }
  if (scenario.word == "M107") commands.emplace_back(SetFan{});
  if (scenario.word == "M84") {
    commands.emplace_back(std::get<Verbatim>(verbatim_from(scenario.word)));
  }
  return commands;
}

inline std::int64_t filament_of(const std::vector<Command>& commands) {
  std::int64_t sum = 0;
  for (const Command& command : commands) {
    if (const auto* move = std::get_if<Move>(&command)) sum += move->e_10nm.value_or(0);
  }
  return sum;
}

inline std::vector<std::string> texts_of(const std::vector<Command>& commands) {
  std::vector<std::string> texts;
  for (const Command& command : commands) {
    TextBuffer buffer;
    texts.emplace_back(encode(command, buffer));
  }
  return texts;
}

struct Ends {
  int finished = 0;
  int faulted = 0;
  int happened = 0;
  int strays = 0;
  std::int64_t damages = 0;
  Duration stood_max{0};
};

inline void check_end(const Scenario& scenario, ScenarioRun& run,
                      const std::vector<Command>& commands, Ends& ends) {
  const Session& session = *run.session;
  const auto texts = texts_of(commands);
  CAPTURE(session.reason());
  const Duration stood = run.controller->controller().totals().stood_max;
  ends.stood_max = std::max(ends.stood_max, stood);
  CAPTURE(stood.count());
  CHECK(stood <= scenario.stood_max);
  run.let_controller_work();
  if (session.state() == SessionState::kFinished) {
    ++ends.finished;
    CHECK(scenario.may_finish);
    CHECK(run.printed == texts);
    // What ran without a number was noticed, and its filament taken back: two tellings round.
    const std::int64_t excess =
        run.controller->controller().totals().filament_10nm - filament_of(commands);
    CAPTURE(session.statistics().filament_corrections);
    CAPTURE(session.statistics().positions_checked);
    CAPTURE(run.strays.size());
    CHECK(std::abs(excess) <= 1'100);
    return;
  }
  if (session.state() == SessionState::kStopped) {
    ++ends.finished;
    CHECK(scenario.mishap == Mishap::kStopHoming);
    REQUIRE(run.printed.size() >= 10);
    CHECK(std::equal(texts.begin(), texts.begin() + 8, run.printed.begin()));
    CHECK(run.printed.back() == "M107");
    return;
  }
  ++ends.faulted;
  REQUIRE(session.state() == SessionState::kFaulted);
  CHECK_FALSE(session.reason().empty());
  CAPTURE(static_cast<int>(session.fault_kind()));
  CHECK((scenario.faults & fault_bit(session.fault_kind())) != 0);
  CHECK(session.reason().find(scenario.says) != std::string::npos);
  if (session.fault_kind() == FaultKind::kPosition) return;
  REQUIRE(run.printed.size() <= texts.size());
  CHECK(std::equal(run.printed.begin(), run.printed.end(), texts.begin()));
}

inline Ends run_scenario(const Scenario& scenario, std::uint64_t seeds) {
  Ends ends;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    VirtualControllerOptions options;
    // An unpaced wire, a real one with a real processor, and one that reads while more comes.
    if (seed % 3 == 1) {
      options.baud = 250000;
      options.command_cost = 1100us;
    } else if (seed % 3 == 2) {
      options.baud = 115200;
    }
    ScenarioRun run(scenario, seed, kMishapLines, options);
    const auto commands = print_of(scenario, seed);
    const bool ended = run.run(commands, 4h);
    CAPTURE(run.session->reason());
    REQUIRE(ended);
    check_end(scenario, run, commands, ends);
    ends.happened += run.controller->mishap_happened() ? 1 : 0;
    ends.damages += run.controller->damages();
    ends.strays += static_cast<int>(run.strays.size());
  }
  return ends;
}

inline bool damages(const WireDamage& wire) {
  return wire.lose_byte + wire.flip_byte + wire.double_byte + wire.lose_line_end + wire.lose_line +
             wire.double_line + wire.insert_line + wire.delay_line + wire.cut_behind_number >
         0;
}

// Plays those that `chosen` picks, so many seeds each unless the environment says otherwise.
inline void play(const std::function<bool(const Scenario&)>& chosen, std::uint64_t usual = 1000) {
  const std::uint64_t seeds = seeds_or(usual);
  for (const Scenario& scenario : scenarios()) {
    if (!chosen(scenario)) continue;
    const std::string name(scenario.name);
    CAPTURE(name);
    const Ends ends = run_scenario(scenario, seeds);
    MESSAGE(name << ": " << ends.finished << " finished, " << ends.faulted << " stopped, "
                 << ends.damages << " damages, " << ends.strays << " strays, stood "
                 << ends.stood_max.count() / 1000 << " ms");
    if (scenario.mishap != Mishap::kNone) CHECK(ends.happened == static_cast<int>(seeds));
    const bool noise = scenario.mishap == Mishap::kNone && scenario.faults != 0;
    if (noise && name != "clean" && name != "packed")
      CHECK(ends.damages > static_cast<std::int64_t>(seeds) / 10);
    // A link that gives up at the first noise would pass the rest.
    if (noise && name != "reprap-lost-lines" && name != "klipper-lost-ends") {
      CHECK(ends.finished > static_cast<int>(seeds) * 9 / 10);
    }
  }
}

}  // namespace link_test
