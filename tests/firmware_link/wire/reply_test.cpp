#include "firmware_link/wire/reply.h"

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

using namespace firmware_link;
using Kind = Reply::Kind;

TEST_CASE("answers are told apart by their beginning") {
  const std::pair<const char*, Kind> kLines[] = {
      {"ok", Kind::kOk},
      {"ok\r", Kind::kOk},
      {" ok", Kind::kOk},
      {"ok N1 P15 B3", Kind::kOk},
      {"okay", Kind::kUnknown},
      {"o", Kind::kUnknown},
      {"Resend: 12", Kind::kResend},
      {"Resend:12", Kind::kResend},
      {"rs 12", Kind::kResend},
      {"rs N12", Kind::kResend},
      {"Error:checksum mismatch, Last Line: 1", Kind::kError},
      {"Error:G2/G3 bad parameters", Kind::kError},
      {"Error:Printer halted. kill() called!", Kind::kHalted},
      {"Error:Heating failed, system stopped! Heater_ID: 0", Kind::kHalted},
      {"Error:Thermal Runaway, system stopped! Heater_ID: bed", Kind::kHalted},
      {"echo:busy: processing", Kind::kBusy},
      {"echo:busy: paused for user", Kind::kBusy},
      {"echo:Unknown command: \"m105\"", Kind::kUnknownCommand},
      {"echo: cold extrusion prevented", Kind::kEcho},
      {"wait", Kind::kWait},
      {"start", Kind::kStart},
      {"start of it", Kind::kUnknown},
      {"//action:pause", Kind::kAction},
      {"// action:pause", Kind::kAction},
      {"// Klipper state: Shutdown", Kind::kNote},
      {"!! Move out of range: 999.000 0.000 0.500 [0.000]", Kind::kAlarm},
      {" T:29.60 /40.00 B:25.45 /0.00 @:127 B@:0 W:?", Kind::kTemperatures},
      {"T:29.60 E:0 W:?", Kind::kTemperatures},
      {"B:25.5 /0.0 T0:26.8 /40.0", Kind::kTemperatures},
      {"X:0.00 Y:0.00 Z:5.00 E:0.00 Count X:0 Y:0 Z:2000", Kind::kPosition},
      {"X:70.38 Y:20.03 Z:0.00 E:1.1 Count X:5630 Y:1602 Z:0", Kind::kUnknown},
      {"X:70.38 Y:20.03 Z:0.00 E:1.199 Count X:5630 Y:1602 Z:0", Kind::kUnknown},
      {"FIRMWARE_NAME:Marlin 2.1", Kind::kFirmwareName},
      {"Cap:EEPROM:0", Kind::kCapability},
      {"Marlin bugfix-2.1.x", Kind::kUnknown},
      {"", Kind::kUnknown},
  };
  for (const auto& one : kLines) {
    const std::string line = one.first;
    CAPTURE(line);
    CHECK(read_reply(line).kind == one.second);
  }
}

TEST_CASE("numbers in answers") {
  CHECK(read_reply("Resend: 12").number == 12);
  CHECK(read_reply("rs N12").number == 12);
  CHECK_FALSE(read_reply("Resend: x").number.has_value());
  CHECK_FALSE(read_reply("Resend: 99999999999999999999").number.has_value());
  const Reply advanced = read_reply("ok N17 P15 B3");
  CHECK(advanced.number == 17);
  CHECK(advanced.planner_free == 15);
  CHECK(advanced.slots_free == 3);
  const Reply bare = read_reply("ok");
  CHECK_FALSE(bare.number.has_value());
  CHECK_FALSE(bare.planner_free.has_value());
  CHECK(read_reply("//action:cancel\r").text == "cancel");
  CHECK(read_reply("echo:Unknown command: \"G5\"").text == "\"G5\"");
}

TEST_CASE("temperatures in their dialects") {
  const Temperatures marlin = read_reply("ok T:25.45 /0.00 B:26.50 /60.00 @:0 B@:0").temperatures;
  CHECK(marlin.nozzle_celsius == 25.45);
  CHECK(marlin.nozzle_target_celsius == 0);
  CHECK(marlin.bed_celsius == 26.5);
  CHECK(marlin.bed_target_celsius == 60);
  CHECK_FALSE(read_reply("ok T:25.45 /0.00 B:26.50 /60.00 @:0 B@:0").slots_free.has_value());
  const Temperatures klipper = read_reply("ok B:25.5 /0.0 T0:26.8 /40.0").temperatures;
  CHECK(klipper.nozzle_celsius == 26.8);
  CHECK(klipper.nozzle_target_celsius == 40);
  CHECK(klipper.bed_celsius == 25.5);
  CHECK_FALSE(read_reply(" T:nan /inf B:").temperatures.nozzle_celsius.has_value());
  CHECK(read_reply("ok CHT:30.00 /0.00 T:25.45 /0.00").temperatures.nozzle_celsius == 25.45);
  CHECK_FALSE(read_reply("ok").temperatures.nozzle_celsius.has_value());
}

TEST_CASE("a controller that has stopped is heard in any case of letters") {
  for (const std::string line :
       {"Error:Thermal Runaway, system stopped! Heater_ID: 0", "error:thermal runaway",
        "ERROR: THERMAL RUNAWAY on T0", "Error:MINTEMP triggered, system stopped!",
        "Error:0: Extruder switched off. mintemp triggered !", "error: MaxTemp",
        "fatal:Heater decoupled", "FATAL: heater/sensor error", "Thermal runaway E1",
        "echo:Thermal Runaway, printer stopped", "Error:Heating failed", "error:heating FAILED",
        "Error:Printer halted. kill() called!", "printer halted. kill() called"}) {
    CAPTURE(line);
    CHECK(read_reply(line).kind == Reply::Kind::kHalted);
  }
  // Talk about it is none.
  for (const std::string line : {"echo:Unknown command: \"M117 thermal runaway\"",
                                 "// thermal runaway is watched", "echo:  M301 P22 ; mintemp",
                                 "ok thermal runaway", "Error:checksum mismatch, Last Line: 5"}) {
    CAPTURE(line);
    CHECK(read_reply(line).kind != Reply::Kind::kHalted);
  }
}

TEST_CASE("lines end with either character or both, in either order") {
  for (const std::string end : {"\n", "\r", "\r\n", "\n\r"}) {
    const std::string text = "start" + end + "ok T:20" + end + end + "wait" + end;
    LineSplitter splitter;
    std::vector<std::string> lines;
    auto rest = std::as_bytes(std::span(text));
    while (!rest.empty()) {
      rest = rest.subspan(splitter.take(rest));
      if (const auto line = splitter.line()) lines.emplace_back(*line);
    }
    CHECK(lines == std::vector<std::string>{"start", "ok T:20", "wait"});
  }
}

TEST_CASE("bytes become lines however they are cut") {
  const std::string text = "ok\n\nResend: 5\r\nok\n" + std::string(600, 'x') + "\nwait\npart";
  const std::vector<std::string> expected = {"ok", "Resend: 5", "ok", std::string(512, 'x'),
                                             "wait"};
  for (std::size_t piece = 1; piece <= text.size(); ++piece) {
    LineSplitter splitter;
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size(); at += piece) {
      auto rest = std::as_bytes(std::span(text).subspan(at, std::min(piece, text.size() - at)));
      while (!rest.empty()) {
        const std::size_t taken = splitter.take(rest);
        REQUIRE(taken > 0);
        rest = rest.subspan(taken);
        if (const auto line = splitter.line()) lines.emplace_back(*line);
      }
    }
    REQUIRE(lines == expected);
    REQUIRE(splitter.lines_cut() == 1);
  }
}

TEST_CASE("random bytes, and answers with random damage, are read without harm") {
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const char* const kSeeds[] = {"ok N12 P15 B3",
                                " T:29.60 /40.00 B:25.45 /0.00 @:127 B@:0 W:?",
                                "Resend: 12",
                                "Error:checksum mismatch, Last Line: 1",
                                "echo:busy: processing",
                                "//action:pause"};
  for (int i = 0; i < 50'000; ++i) {
    std::string line = kSeeds[random() % 6];
    for (std::size_t n = random() % 6; n > 0; --n) {
      const std::size_t at = random() % (line.size() + 1);
      if (random() % 2 == 0) {
        line.insert(at, 1, static_cast<char>(random()));
      } else {
        line.resize(at);
      }
    }
    // A copy of the exact size, so that a sanitizer sees any byte read behind it.
    const std::vector<char> exact(line.begin(), line.end());
    const Reply reply = read_reply({exact.data(), exact.size()});
    REQUIRE(reply.text.size() <= line.size());
  }
}
