#include "firmware_link/wire/line_codec.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

using namespace firmware_link;

namespace {

std::string text_of(const Command& command) {
  TextBuffer buffer;
  return std::string(encode(command, buffer));
}

std::string fixed(std::int64_t value, int decimals) {
  char text[32];
  return std::string(text, write_fixed(text, value, decimals));
}

Command verbatim(const std::string& line) { return std::get<Verbatim>(verbatim_from(line)); }

}  // namespace

TEST_CASE("numbers in their shortest form") {
  CHECK(fixed(0, 3) == "0");
  CHECK(fixed(-0, 3) == "0");
  CHECK(fixed(1230, 5) == "0.0123");
  CHECK(fixed(-1230, 5) == "-0.0123");
  CHECK(fixed(10'500, 3) == "10.5");
  CHECK(fixed(10'000, 3) == "10");
  CHECK(fixed(-1, 3) == "-0.001");
  CHECK(fixed(7, 0) == "7");
  CHECK(fixed(std::numeric_limits<std::int64_t>::min(), 9) == "-9223372036.854775808");
  CHECK(fixed(std::numeric_limits<std::int64_t>::max(), 0).size() == 19);
}

TEST_CASE("moves in fewer bytes, and spelled out again") {
  const std::pair<const char*, const char*> cases[] = {
      {"G1 X10.5 Y-0.001 E0.0123 F1800", "G1X10.5Y-.001 E.0123F1800"},
      {"G0 X0 Y0", "G0X0Y0"},
      {"G1 E-0.8", "G1 E-.8"},
      {"G1 X100.05 E2", "G1X100.05 E2"},
      {"M104 S0.5", "M104 S0.5"},
      {"G28 X Y", "G28 X Y"},
      {"G10 S0.1", "G10 S0.1"},
      {"M117 G1 X0.5 done", "M117 G1 X0.5 done"}};
  for (const auto& [text, expected] : cases) {
    TextBuffer buffer;
    SpelledBuffer spelled;
    CHECK(shortened(text, buffer) == expected);
    CHECK(spelled_out(expected, spelled) == text);
    CHECK(spelled_out(text, spelled) == text);
  }
}

TEST_CASE("what a command reads like") {
  Move move;
  move.extruding = true;
  move.x_um = 10'500;
  move.e_10nm = 12'345;
  CHECK(text_of(move) == "G1 X10.5 E0.12345");
  move.extruding = false;
  move.y_um = -1;
  move.z_um = 0;
  move.f_mm_min = 9000;
  move.e_10nm.reset();
  CHECK(text_of(move) == "G0 X10.5 Y-0.001 Z0 F9000");
  CHECK(text_of(SetTemperature{Heater::kNozzle, 2100, false}) == "M104 S210");
  CHECK(text_of(SetTemperature{Heater::kNozzle, 2105, true}) == "M109 S210.5");
  CHECK(text_of(SetTemperature{Heater::kBed, 600, false}) == "M140 S60");
  CHECK(text_of(SetTemperature{Heater::kBed, 0, true}) == "M190 S0");
  CHECK(text_of(SetFan{255}) == "M106 S255");
  CHECK(text_of(SetFan{0}) == "M107");
  CHECK(text_of(SetAcceleration{Flavor::kMarlin, 1'250}) == "M204 S1250");
  CHECK(text_of(SetAcceleration{Flavor::kKlipper, 1'250}) == "M204 S1250");
  CHECK(text_of(SetAcceleration{Flavor::kRepRapFirmware, 1'250}) == "M204 P1250 T1250");
  CHECK(text_of(SetPressureAdvance{Flavor::kMarlin, 4'500}) == "M900 K0.045");
  CHECK(text_of(SetPressureAdvance{Flavor::kKlipper, 4'500}) ==
        "SET_PRESSURE_ADVANCE ADVANCE=0.045");
  CHECK(text_of(SetPressureAdvance{Flavor::kRepRapFirmware, 0}) == "M572 D0 S0");
  CHECK(text_of(verbatim("g28 x y")) == "G28 X Y");
}

TEST_CASE("the longest of everything fits a line of 95 bytes") {
  Move move;
  move.extruding = true;
  move.x_um = move.y_um = move.z_um = -(kPositionUmMax - 8);
  move.e_10nm = -(kFilament10nmMax - 8);
  move.f_mm_min = kFeedMmMinMax;
  TextBuffer buffer;
  const std::string_view text = encode(move, buffer);
  CHECK(text.size() == kMoveBytesMax);
  const std::int32_t most = std::numeric_limits<std::int32_t>::max();
  CHECK(text_of(SetAcceleration{Flavor::kRepRapFirmware, most}).size() == kSetAccelerationBytesMax);
  CHECK(text_of(SetPressureAdvance{Flavor::kKlipper, most}).size() == kSetPressureAdvanceBytesMax);
  LineBuffer line;
  CHECK(number_line(kResyncLineNumber, text, line).size() <= kLineBytesMax);
  const std::string full(kTextBytesMax, '~');
  const std::string_view longest = number_line(kResyncLineNumber, full, line);
  CHECK(longest.size() <= kLineBytesMax);
  CHECK(longest.size() >= kLineBytesMax - 2);
}

TEST_CASE("random moves are read back as they were, by us and by strtod") {
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const auto some = [&random](std::int64_t limit) {
    const std::int64_t scale = std::int64_t{1} << random() % 40;
    return static_cast<std::int64_t>(random()) % std::min(limit, scale);
  };
  for (int i = 0; i < 20'000; ++i) {
    Move move;
    move.extruding = random() % 2 == 0;
    if (random() % 2 == 0) move.x_um = some(kPositionUmMax);
    if (random() % 2 == 0) move.y_um = some(kPositionUmMax);
    if (random() % 2 == 0) move.z_um = some(kPositionUmMax);
    if (random() % 2 == 0) move.e_10nm = some(kFilament10nmMax);
    if (random() % 2 == 0) move.f_mm_min = std::abs(some(kFeedMmMinMax));
    const std::string text = text_of(move);
    CAPTURE(text);
    REQUIRE(word(text, 'X', 3) == move.x_um);
    REQUIRE(word(text, 'Y', 3) == move.y_um);
    REQUIRE(word(text, 'Z', 3) == move.z_um);
    REQUIRE(word(text, 'E', 5) == move.e_10nm);
    REQUIRE(word(text, 'F', 0) == move.f_mm_min);
    if (move.e_10nm) {
      const double e = std::strtod(text.c_str() + text.find('E') + 1, nullptr);
      REQUIRE(std::llround(e * 1e5) == *move.e_10nm);
    }
    // Shortest: nothing ends in a needless zero.
    REQUIRE(text.find(".0 ") == std::string::npos);
    const std::int32_t number = static_cast<std::int32_t>(random() % kLineNumberMax);
    LineBuffer buffer;
    const std::string_view line = number_line(number, text, buffer);
    REQUIRE(line.size() <= kLineBytesMax);
    const NumberedText parts = take_apart(line);
    REQUIRE(parts.number == number);
    REQUIRE(parts.text == text);
    REQUIRE(parts.checksum_matches);
  }
}

TEST_CASE("checksums as printed in Marlin's own words") {
  LineBuffer buffer;
  CHECK(number_line(1, "M105", buffer) == "N1M105*6");
  CHECK(number_line(kResyncLineNumber, "M105", buffer) == "N99999999M105*55");
  CHECK_FALSE(take_apart("N2 M105*36").checksum_matches);
  CHECK(take_apart("N10 M110*18").checksum_matches);
}

TEST_CASE("a line with any one byte changed, lost or doubled fails its check") {
  LineBuffer buffer;
  const std::string line(number_line(1234, "G1 X101.25 Y99.999 E0.0321 F4800", buffer));
  for (std::size_t at = 0; at < line.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string bad = line;
      bad[at] = static_cast<char>(bad[at] ^ (1 << bit));
      CAPTURE(bad);
      CHECK_FALSE(take_apart(bad).checksum_matches);
    }
    std::string lost = line;
    lost.erase(at, 1);
    CHECK_FALSE(take_apart(lost).checksum_matches);
    std::string doubled = line;
    doubled.insert(at, 1, line[at]);
    CHECK_FALSE(take_apart(doubled).checksum_matches);
  }
}

TEST_CASE("lines are taken apart like Marlin does it") {
  CHECK(take_apart("N-1 M110*15").number == -1);
  CHECK_FALSE(take_apart(" N1 M105*38").number.has_value());
  CHECK_FALSE(take_apart("n1 M105*38").number.has_value());
  CHECK(take_apart("N1 M105").text == "M105");
  CHECK_FALSE(take_apart("N1 M105").checksum.has_value());
  CHECK(take_apart("N1 M117 a*b*3").text == "M117 a*b");
  CHECK(take_apart("").text.empty());
  CHECK(word("G1 X1 Y2", 'G', 0) == std::nullopt);
  CHECK(word("G1 X", 'X', 3) == 0);
  CHECK(word("G1 X1.23456", 'X', 3) == 1235);
  CHECK(word("G1 X-.5", 'X', 3) == -500);
  CHECK(word("", 'X', 3) == std::nullopt);
}

TEST_CASE("random bytes are taken apart without harm") {
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 50'000; ++i) {
    std::string text;
    for (std::size_t n = random() % 40; n > 0; --n) {
      text.push_back(random() % 3 == 0 ? static_cast<char>(random())
                                       : "N*-+.0129GXE "[random() % 13]);
    }
    const NumberedText parts = take_apart(text);
    REQUIRE(parts.text.size() <= text.size());
    (void)word(text, 'X', static_cast<int>(random() % 10));
  }
}

TEST_CASE(
    "an arc's text: the longest fits a line, zeros are left out, it is shortened and spelled") {
  Move move;
  move.extruding = true;
  move.x_um = -kPositionUmMax;
  move.y_um = -kPositionUmMax;
  move.e_10nm = -kFilament10nmMax;
  move.f_mm_min = kFeedMmMinMax;
  move.arc = Arc{true, -kArcCentreUmMax, -kArcCentreUmMax, 0};
  TextBuffer buffer;
  CHECK(encode(move, buffer).size() == kArcBytesMax);
  move = {};
  move.extruding = true;
  move.x_um = 12'300;
  move.e_10nm = 1'230;
  move.arc = Arc{false, -500, 0, 700};
  const std::string text(encode(move, buffer));
  CHECK(text == "G3 X12.3 I-0.5 E0.0123");
  TextBuffer short_buffer;
  const std::string wire(shortened(text, short_buffer));
  CHECK(wire == "G3X12.3I-.5 E.0123");
  SpelledBuffer spelled;
  CHECK(spelled_out(wire, spelled) == text);
}
