// Commands as lines of G-code, and lines taken apart again.
//
//     Move{x 10500 µm, e 1230}   ->  "G1 X10.5 E0.0123"      the text; goes to .gcode files as it
//     shortened()                   ->  "G1X10.5 E.0123"
//     is line 12 of it              ->  "N12G1X10.5 E.0123*23"     goes over the wire, with a \n
//
// The checksum is the exclusive or of all bytes before the `*`. Numbers come in their shortest
// form that every firmware and viewer reads: no trailing zeros, a zero before the point.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "firmware_link/wire/command.h"  // Command
#include "firmware_link/wire/limits.h"   // kLineBytesMax, kTextBytesMax

namespace firmware_link {

using TextBuffer = std::array<char, kTextBytesMax>;
using LineBuffer = std::array<char, kLineBytesMax>;

// Largest text of each kind; each fits kTextBytesMax (static_assert beside the encoder).
inline constexpr std::size_t kMoveBytesMax = 2 + 3 * (2 + 12) + (2 + 14) + (2 + 7);
inline constexpr std::size_t kArcBytesMax = 2 + 2 * (2 + 12) + 2 * (2 + 9) + (2 + 14) + (2 + 7);
inline constexpr std::size_t kSetTemperatureBytesMax = 4 + 2 + 5;
inline constexpr std::size_t kSetFanBytesMax = 4 + 2 + 3;
inline constexpr std::size_t kSetAccelerationBytesMax = 4 + 2 * (2 + 10);
inline constexpr std::size_t kSetPressureAdvanceBytesMax = 29 + 11;  // Klipper's

// Writes the command's text into the buffer and returns it: no number, no checksum, no newline.
// REQUIRES: numbers within the bounds that command.h states.
[[nodiscard]] std::string_view encode(const Command& command, TextBuffer& into);

// The same move in fewer bytes: no blanks but before E, because "Y3E2" would be read as 300 by
// some; no zero before a point. Texts other than moves (G0 … G3) come back as they are.
[[nodiscard]] std::string_view shortened(std::string_view text, TextBuffer& into);

// The inverse, for readers of a log: blanks and zeros as encode() writes them. Texts other than
// moves come back as they are. Never fails; a text too long is not changed.
using SpelledBuffer = std::array<char, 2 * kLineBytesMax>;
[[nodiscard]] std::string_view spelled_out(std::string_view text, SpelledBuffer& into);

// Puts number and checksum around a text: "N12text*104", without a newline.
// REQUIRES: 0 <= number <= kResyncLineNumber, text.size() <= kTextBytesMax.
// ENSURES: at most kLineBytesMax bytes.
[[nodiscard]] std::string_view number_line(std::int32_t number, std::string_view text,
                                           LineBuffer& into);

[[nodiscard]] std::uint8_t checksum_of(std::string_view bytes);

// Writes value / 10^decimals in its shortest form: 1230 with 5 decimals is "0.0123".
// Returns the end. REQUIRES: room for 21 bytes from `at`, 0 <= decimals <= 9.
[[nodiscard]] char* write_fixed(char* at, std::int64_t value, int decimals);

// A received line, taken apart: "N12 G1 X3*104" has number 12, text "G1 X3", checksum 104.
struct NumberedText {
  std::optional<std::int64_t> number;
  std::string_view text;  // without number, checksum and the blanks around
  std::optional<std::int64_t> checksum;
  bool checksum_matches = false;  // false when there is none
};

// Never fails: what is not there is not set. The line is taken as Marlin does: a number only at its
// very start and after a capital N, a checksum after the last `*`.
[[nodiscard]] NumberedText take_apart(std::string_view line);

// The number behind a letter in a command's text, in units of 10^-decimals, rounded to the nearest:
// word("G1 X10.5 E0.1", 'X', 3) is 10500. Nothing when the letter isn't there; 0 when no number
// follows it. Looks only after the command word, so that 'G' finds no G1.
[[nodiscard]] std::optional<std::int64_t> word(std::string_view text, char letter, int decimals);

}  // namespace firmware_link
