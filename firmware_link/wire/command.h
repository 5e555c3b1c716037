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

// What a line of a file does to the machine besides its move, as far as that is followed.
struct Effect {
  enum class Kind : std::uint8_t {
    kNone,
    kModes,          // value: kRelativePlace, kRelativeFilament, kInches
    kFilamentCount,  // value: what the controller counts from here on, in 10 nm
    kNozzle,         // value: its target in tenths of a degree Celsius; likewise the bed's
    kBed,
    kFan,          // value: 0 … 255
    kFeedPercent,  // M220
    kFlowPercent,  // M221
    kTool,
  };
  static constexpr std::int32_t kRelativePlace = 1;
  static constexpr std::int32_t kRelativeFilament = 2;
  static constexpr std::int32_t kInches = 4;

  Kind kind = Kind::kNone;
  std::int64_t value = 0;
};

// What is known of the nozzle's place behind a line of a file.
enum class PlaceAfter : std::uint8_t {
  kByMove,    // all of it: only what the move says has changed
  kFilament,  // likewise, but the controller's count of filament is not known
  kAsBefore,  // the nozzle comes back to where it was (M600); nobody can tell how exactly
  kAxesLost,  // the axes in lost_axes are not known (G28)
};

// One line of a ready G-code file: it is sent in its own words. `move` is what these mean: absolute
// in x, y, z and relative in e, in millimetres, whatever modes the file is in; empty: no move.
struct ReadyLine {
  Verbatim words;
  Move move;
  Effect effect;
  PlaceAfter place = PlaceAfter::kByMove;
  std::uint8_t lost_axes = 0;  // bits: 1 x, 2 y, 4 z
  // The coordinates are not the machine's own any more (G92 X0), or are again (G28).
  std::optional<bool> shifted = std::nullopt;
};

using Command = std::variant<Move, SetTemperature, SetFan, SetAcceleration, SetPressureAdvance,
                             Verbatim, ReadyLine>;

// The command's move; null: it has none.
[[nodiscard]] inline const Move* move_of(const Command& command) {
  if (const auto* ready = std::get_if<ReadyLine>(&command)) return &ready->move;
  return std::get_if<Move>(&command);
}

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

// True for a move of plain words, such as "G1 X10 Y5.5 E.03", which verbatim_from() leaves as it is
// and nothing refuses: a fast answer for nearly all of a file.
[[nodiscard]] bool is_plain_move(std::string_view line);

// True when a line of G-code holds nothing to send.
[[nodiscard]] bool blank_or_comment(std::string_view line);

}  // namespace firmware_link
