// What a host may request while it prints, what the controller says by itself, and what a journal
// is told.
#include <doctest/doctest.h>

#include <array>
#include <chrono>
#include <string>
#include <vector>

#include "tests/firmware_link/virtual_link.h"

using namespace firmware_link;
using namespace link_test;
using namespace std::chrono_literals;

namespace {

std::vector<SessionEvent::Kind> events_of(Session& session) {
  std::vector<SessionEvent::Kind> kinds;
  while (const auto event = session.next_event()) kinds.push_back(event->kind);
  return kinds;
}

// Streams commands from `next` on until so many have been accepted.
void stream(VirtualLink& link, const std::vector<Command>& commands, std::size_t& next,
            std::int64_t accepted) {
  while (link.session->accepted() < accepted) {
    while (link.session->can_take() && next < commands.size()) {
      link.session->take(commands[next++], link.now);
    }
    link.turn();
  }
}

}  // namespace

TEST_CASE("feed and flow are told once, before what is taken next, and count as no command") {
  VirtualLink link({}, {});
  const auto commands = moves(40, 1);
  std::size_t next = 0;
  stream(link, commands, next, 10);
  link.session->set_feed_percent(50, link.now);
  link.session->set_feed_percent(80, link.now);
  link.session->set_flow_percent(95, link.now);
  const std::size_t taken = next;
  stream(link, commands, next, 30);
  const auto printed = link.printed();
  const auto feed = std::find(printed.begin(), printed.end(), "M220 S80");
  REQUIRE(feed != printed.end());
  CHECK(std::count(printed.begin(), printed.end(), "M220 S50") <= 1);
  CHECK(static_cast<std::size_t>(feed - printed.begin()) <= taken + 2);
  CHECK(std::find(printed.begin(), printed.end(), "M221 S95") != printed.end());
  CHECK(link.session->accepted() == link.session->statistics().commands_acknowledged);
}

TEST_CASE("what is inserted keeps its place, and the print's count goes on as if it were not") {
  VirtualLink link({}, {});
  const auto commands = moves(20, 2);
  std::size_t next = 0;
  stream(link, commands, next, 10);
  while (!link.session->can_take()) link.turn();
  const std::size_t before = next;
  Move park;
  park.z_um = 50'000;
  link.session->hold(true, link.now);
  link.session->insert(park, link.now);
  for (int i = 0; i < 200; ++i) link.turn();
  CHECK(link.session->accepted() == static_cast<std::int64_t>(before));
  link.session->hold(false, link.now);
  stream(link, commands, next, 20);
  auto printed = link.printed();
  const auto found = std::find(printed.begin(), printed.end(), "G0 Z50");
  REQUIRE(found != printed.end());
  CHECK(static_cast<std::size_t>(found - printed.begin()) == before);
  printed.erase(found);
  CHECK(printed == texts_of(commands));
  CHECK(link.session->statistics().stalls <= 1);  // the one before hold()
}

TEST_CASE("a line number tells how many of the print's commands it stands for") {
  VirtualLink link({}, {});
  const auto commands = moves(60, 3);
  std::size_t next = 0;
  stream(link, commands, next, 40);
  while (link.session->statistics().lines_in_flight > 0) link.turn();
  const auto line = static_cast<std::int32_t>(link.controller->state().last_line);
  CHECK(link.session->accepted_line() == line);
  CHECK(link.session->commands_through_line(line) == link.session->accepted());
  CHECK_FALSE(link.session->commands_through_line(line + 100).has_value());
  CHECK_FALSE(link.session->commands_through_line(1).has_value());

  // The next host, after this one was killed, learns the line from a controller that lives on.
  SessionOptions options;
  options.ask_found_line = true;
  link.session = std::make_unique<Session>(std::make_unique<MarlinDialect>(), options, link.now);
  while (link.session->state() == SessionState::kConnecting) link.turn();
  CHECK(link.session->state() == SessionState::kStreaming);
  CHECK(link.session->found_line() == line);
}

TEST_CASE("actions of the printer's operator, waits and warnings are told as they come") {
  using Kind = SessionEvent::Kind;
  VirtualLink link({}, {});
  while (link.session->state() == SessionState::kConnecting) link.turn();
  CHECK(events_of(*link.session) == std::vector<Kind>{Kind::kDialect});
  for (const char* words :
       {"//action:pause\n", "// action:resume\n", "//action:cancel\r\n", "//action:paused\n",
        "//action:prompt_end\n", "echo:busy: paused for user\n", "Error:G2/G3 bad parameters\n"}) {
    link.controller->say(words, link.now);
  }
  for (int i = 0; i < 10; ++i) link.turn();
  CHECK(events_of(*link.session) ==
        std::vector<Kind>{Kind::kPauseAsked, Kind::kResumeAsked, Kind::kCancelAsked, Kind::kPaused,
                          Kind::kAction, Kind::kWaitsForUser, Kind::kWarning});
  for (int i = 0; i < 100; ++i) {
    link.controller->say("//action:pause\n", link.now);
    link.turn();
  }
  CHECK(events_of(*link.session).size() == kEventsMax);
  CHECK(link.session->statistics().events_dropped == 100 - static_cast<std::int64_t>(kEventsMax));
}

TEST_CASE("one question goes behind a command that waits, so that an M112 is read at once") {
  VirtualLink link({}, {});
  std::vector<Command> commands = moves(6, 4);
  commands.insert(commands.begin() + 2, std::get<Verbatim>(verbatim_from("G4 S20")));
  std::size_t next = 0;
  stream(link, commands, next, 2);
  for (int i = 0; i < 400; ++i) {
    while (link.session->can_take() && next < commands.size()) {
      link.session->take(commands[next++], link.now);
    }
    link.turn();
  }
  CHECK(link.session->statistics().lines_in_flight == 2);
  link.to_controller("\nM112\n");
  link.turn();
  CHECK(link.controller->state().halted);
}

TEST_CASE("filament that ran twice is taken back, much of it is a fault") {
  for (const char* stray : {"G1 E0.2\n", "G1 E3\n", "G1 E0.0002\n"}) {
    CAPTURE(stray);
    VirtualControllerOptions options;
    options.extrude_celsius_min = 0;
    VirtualLink link(options, {});
    const auto commands = moves(60, 5);
    std::int64_t wanted = 0;
    for (const Command& command : commands) {
      if (const auto* move = std::get_if<Move>(&command)) wanted += move->e_10nm.value_or(0);
    }
    std::size_t next = 0;
    stream(link, commands, next, 30);
    link.to_controller(stray);  // as a flushed tail would
    link.session->check_position(link.now);
    const bool ended = [&] {
      for (int i = 0; i < 5000 && !link.ended(); ++i) {
        while (link.session->can_take() && next < commands.size()) {
          link.session->take(commands[next++], link.now);
        }
        if (link.session->can_take()) link.session->finish(link.now);
        link.turn();
      }
      return link.ended();
    }();
    CHECK(ended);
    const std::string text = stray;
    if (text == "G1 E3\n") {
      CHECK(link.session->fault_kind() == FaultKind::kPosition);
      CHECK(link.session->reason().find("mm of filament too much") != std::string::npos);
      continue;
    }
    CHECK(link.session->state() == SessionState::kFinished);
    CHECK(link.session->statistics().filament_corrections == (text == "G1 E0.2\n" ? 1 : 0));
    const std::int64_t excess = link.controller->totals().filament_10nm - wanted;
    CHECK(std::abs(excess) <= 1'100);
  }
}

TEST_CASE("a road that a cold nozzle does not lay is a fault, a cold start of the user's is not") {
  for (const bool laying : {true, false}) {
    CAPTURE(laying);
    VirtualLink link({}, {});
    auto commands = moves(40, 7);
    if (!laying) {
      commands = {std::get<Verbatim>(verbatim_from("M83")),
                  std::get<Verbatim>(verbatim_from("G1 E-2 F1800"))};
    }
    std::size_t next = 0;
    stream(link, commands, next, static_cast<std::int64_t>(commands.size()) - 1);
    link.controller->say("echo: cold extrusion prevented\n", link.now);
    for (int i = 0; i < 20; ++i) link.turn();
    if (laying) {
      CHECK(link.session->fault_kind() == FaultKind::kAlarm);
      CHECK(link.session->reason().find("cold extrusion") != std::string::npos);
    } else {
      CHECK(link.session->state() == SessionState::kStreaming);
      CHECK(link.session->statistics().warnings == 1);
    }
  }
}

TEST_CASE("a stop while it heats ends the wait, and nothing has to be halted") {
  for (int kind = 0; kind < 8; ++kind) {
    const char* wait = kind % 2 == 0 ? "M190 S100" : "M109 S250";
    CAPTURE(kind);
    VirtualControllerOptions controller;
    SessionOptions host;
    controller.emergency_parser = kind / 2 % 2 == 1;
    controller.meatpack = host.pack = kind / 4 == 1;
    VirtualLink link(controller, host);
    const std::vector<Command> commands = {std::get<Verbatim>(verbatim_from("G90")),
                                           std::get<Verbatim>(verbatim_from(wait))};
    std::size_t next = 0;
    stream(link, commands, next, 1);
    for (int i = 0; i < 1000; ++i) {
      if (link.session->can_take() && next < commands.size()) {
        link.session->take(commands[next++], link.now);
      }
      link.turn();
    }
    REQUIRE(link.session->statistics().lines_in_flight == 2);
    const std::vector<Command> safe = {SetTemperature{Heater::kNozzle, 0, false},
                                       SetTemperature{Heater::kBed, 0, false}};
    link.session->stop_now(safe, link.now);
    const Instant began = link.now;
    while (!link.ended()) link.turn();
    CHECK(link.session->state() == SessionState::kStopped);
    CHECK(link.now - began < 5s);
    link.let_controller_work();
    const VirtualControllerState state = link.controller->state();
    CHECK_FALSE(state.halted);
    CHECK(state.nozzle_target_celsius == 0);
    CHECK(state.bed_target_celsius == 0);
  }
}

TEST_CASE("a printer that waits for its user says so once, and hears the user's answer here") {
  VirtualLink link({}, {});
  while (link.session->state() == SessionState::kConnecting) link.turn();
  for (int i = 0; i < 10; ++i) link.turn();
  (void)events_of(*link.session);
  link.session->answer_user(link.now);  // nobody has asked
  CHECK(link.session->output().empty());
  for (int i = 0; i < 3; ++i) {
    link.controller->say("echo:busy: paused for user\n", link.now);
    for (int turn = 0; turn < 10; ++turn) link.turn();
  }
  CHECK(events_of(*link.session) ==
        std::vector<SessionEvent::Kind>{SessionEvent::Kind::kWaitsForUser});
  link.session->answer_user(link.now);
  const auto bytes = link.session->output();
  CHECK(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()) == "\nM108\n");
}

TEST_CASE("filament may be changed days later, and the nozzle cools meanwhile") {
  VirtualLink link({}, {});
  while (link.session->state() == SessionState::kConnecting) link.turn();
  for (int i = 0; i < 10; ++i) link.turn();
  link.session->take(std::get<Verbatim>(verbatim_from("M600")), link.now);
  const std::string busy = "echo:busy: paused for user\nT:90.00 /210.00 B:60.00 /60.00\n";
  for (int minute = 0; minute < 6 * 24 * 60; ++minute) {
    for (int second = 0; second < 60; second += 2) {
      link.now += std::chrono::seconds(2);
      link.session->input(std::as_bytes(std::span(busy)), link.now);
      link.session->tick(link.now);
    }
    REQUIRE(link.session->state() == SessionState::kStreaming);
  }
}

TEST_CASE("a nozzle that stands for want of an `ok` makes the link ask at once") {
  VirtualLink link({}, {});
  const auto commands = moves(60, 9);
  std::size_t next = 0;
  stream(link, commands, next, 20);
  // Lets all moves end, and then loses a whole answer.
  for (int i = 0; i < 4000; ++i) link.turn();
  CHECK(link.session->planner_blocks() == 0);
  link.session->take(commands[next++], link.now);
  const auto bytes = link.session->output();
  link.to_controller(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  link.session->written(bytes.size(), link.now);
  link.controller->advance(link.now);
  std::array<std::byte, 256> lost;
  while (link.controller->output(lost) > 0) {
  }
  const Instant began = link.now;
  while (link.session->statistics().lines_in_flight > 0) link.turn();
  CHECK(link.now - began < 2s);
  CHECK(link.session->statistics().resyncs == 1);
}
