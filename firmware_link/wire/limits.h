// Every bound of the link in one place, with its reason; what was measured on controllers is told
// in README.md.
#pragma once

#include <cstddef>
#include <cstdint>

namespace firmware_link {

// Marlin's MAX_CMD_SIZE is 96 with the closing zero: a longer line is cut without a word, its
// checksum with it, and then asked for again for ever.
inline constexpr std::size_t kLineBytesMax = 95;

// Resynchronisation uses a line number that no line ever has, so all others stay below it.
inline constexpr std::int32_t kResyncLineNumber = 99'999'999;
inline constexpr std::int32_t kLineNumberMax = 99'999'998;
inline constexpr std::size_t kLineNumberDigitsMax = 8;

// "N", digits, " " before the text; "*" and at most three digits after it.
inline constexpr std::size_t kTextBytesMax = kLineBytesMax - (1 + kLineNumberDigitsMax + 1) - 4;
static_assert(kTextBytesMax == 81);

// Marlin's receive ring, and how much of it may be in use, because a busy controller reads nothing.
inline constexpr std::size_t kControllerReceiveBytes = 128;
inline constexpr std::size_t kWindowBytesMax = 120;
static_assert(kWindowBytesMax < kControllerReceiveBytes);
static_assert(kLineBytesMax + 1 <= kWindowBytesMax, "the longest line must fit the window");

// Marlin's command slots (BUFSIZE). More lines in flight bring no speed, only latency and loss.
inline constexpr std::size_t kControllerCommandSlots = 4;
inline constexpr std::size_t kWindowLinesMax = 4;
static_assert(kWindowLinesMax <= kControllerCommandSlots);

// Sent lines that are kept: those in flight, and acknowledged ones, because an `ok` may belong to a
// garbled line, which the next line's `Resend:` then uncovers.
inline constexpr std::size_t kHistoryLinesMax = 32;
static_assert(kHistoryLinesMax >= 2 * kWindowLinesMax);

// Longest line that is read from a controller; the rest of a longer one is dropped and counted.
// Marlin's M115 answer starts with one of about 250 bytes.
inline constexpr std::size_t kReplyBytesMax = 512;

// Events that wait for the host, at most; older ones are dropped.
inline constexpr std::size_t kEventsMax = 16;

// Marlin's BLOCK_BUFFER_SIZE, of which one stays empty.
inline constexpr std::size_t kPlannerBlocks = 16;

}  // namespace firmware_link
