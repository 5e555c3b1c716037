// What a controller is told, in whole numbers of wire units: one struct per kind. How it reads as
// text is line_codec's part.
//
//     x, y, z   µm (three decimals)          e   10 nm of filament (five decimals)
//     f         mm/min                       temperatures in tenths of a degree Celsius
//
// Whole numbers, so that what is sent can be summed and compared without error.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "firmware_link/wire/limits.h"  // kTextBytesMax

namespace firmware_link {

// The largest numbers a Move may carry, so that its text always fits a line: ±9,999 m, and more
// filament in one move than a spool holds.
inline constexpr std::int64_t kPositionUmMax = 9'999'999'999;
inline constexpr std::int64_t kFilament10nmMax = 999'999'999'999;
inline constexpr std::int64_t kFeedMmMinMax = 9'999'999;

// Radii of arcs: ±9,999 mm, so that an arc's text fits a line too.
inline constexpr std::int32_t kArcCentreUmMax = 9'999'999;

// The way of a move that is an arc of a circle in the plane (G2, G3).
struct Arc {
  bool clockwise = false;
  std::int32_t i_um = 0;  // from its start to the centre
  std::int32_t j_um = 0;
  std::int32_t length_um = 0;  // of the way; not sent
};

// A move, straight or along an arc, absolute in x, y, z, relative in e. What is not set stays as it
// was. REQUIRES: numbers within the bounds above; an arc is extruding, ends elsewhere than it
// starts, and has no z.
struct Move {
  bool extruding = false;  // G1, otherwise G0: most controllers make no difference, readers do
  std::optional<std::int64_t> x_um;
  std::optional<std::int64_t> y_um;
  std::optional<std::int64_t> z_um;
  std::optional<std::int64_t> e_10nm;
  std::optional<std::int64_t> f_mm_min;
  std::optional<Arc> arc;
};

enum class Heater { kNozzle, kBed };

// M104, M109, M140, M190. REQUIRES: 0 <= celsius_tenths <= 9999.
struct SetTemperature {
  Heater heater = Heater::kNozzle;
  std::int32_t celsius_tenths = 0;
  bool wait = false;
};

// M106 S<power>, or M107 for 0.
struct SetFan {
  std::uint8_t power = 0;
};

// Firmwares that spell some commands in their own way.
enum class Flavor { kMarlin, kKlipper, kRepRapFirmware };

// Of all moves, in mm/s²: M204. REQUIRES: mm_s2 > 0.
struct SetAcceleration {
  Flavor flavor = Flavor::kMarlin;
  std::int32_t mm_s2 = 0;
};

// How the filament's pressure follows the speed: M900, SET_PRESSURE_ADVANCE, M572.
// REQUIRES: tens_us >= 0.
struct SetPressureAdvance {
  Flavor flavor = Flavor::kMarlin;
  std::int32_t tens_us = 0;  // five decimals of a second
};

// One line of G-code that a user wrote, made safe to send: see verbatim_from().
class Verbatim {
 public:
  [[nodiscard]] std::string_view text() const { return {text_.data(), size_}; }

 private:
  friend std::variant<Verbatim, std::string> verbatim_from(std::string_view line);

  std::array<char, kTextBytesMax> text_{};
  std::uint8_t size_ = 0;
};

using Command =
    std::variant<Move, SetTemperature, SetFan, SetAcceleration, SetPressureAdvance, Verbatim>;

// Turns a line of a user's G-code into a Verbatim, or tells in a sentence why it may not be sent.
//
// Comments (`; …`, `(…)`) are stripped, blanks around them too, and letters become capitals, except
// in the text of commands that carry text (M117 …) and in named commands' values (PROFILE=default).
// Refused are: lines with nothing left (blank_or_comment() tells before), anything but printable
// ASCII, lines with a number or a checksum of their own, over kTextBytesMax, not starting with a
// command word, holding "M110" anywhere (Marlin obeys it inside a text), a command that is never
// sent (refused_commands.h; the others there are whoever asks the user's to refuse), and a text
// that the controller would say and that would be taken for its answer (M118, RESPOND).
[[nodiscard]] std::variant<Verbatim, std::string> verbatim_from(std::string_view line);

// True when a line of G-code holds nothing to send.
[[nodiscard]] bool blank_or_comment(std::string_view line);

}  // namespace firmware_link
