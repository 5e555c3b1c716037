// What a controller says, read line by line and told apart by how a line starts.
//
// Controllers have no grammar; the prefixes below are what Marlin, Klipper and their kin were
// measured to say. A line that fits none is kUnknown, and never an error: printers chatter.
//
//     "ok"  "ok T:25.4 /0.0"  "ok N12 P15 B3"    kOk           "start"                  kStart
//     "Resend: 12"  "rs 12"                      kResend       "wait"                   kWait
//     "echo:busy: processing"                    kBusy         "//action:pause"         kAction
//     " T:210.1 /210.0 B:60.0 /60.0 @:64"        kTemperatures "!! Move out of range"   kAlarm
//     "X:0.00 Y:0.00 Z:5.00 E:0.00 Count …"      kPosition     "// Klipper state: …"    kNote
//     "Error:checksum mismatch, Last Line: 1"    kError        "echo:…", "FIRMWARE_NAME:…", "Cap:…"
//     "Error:Printer halted. kill() called!"     kHalted       "echo:Unknown command: …"
//     "fatal:Heater decoupled"                   kHalted
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "firmware_link/wire/limits.h"  // kReplyBytesMax

namespace firmware_link {

struct Temperatures {
  std::optional<double> nozzle_celsius;
  std::optional<double> nozzle_target_celsius;
  std::optional<double> bed_celsius;
  std::optional<double> bed_target_celsius;
};

// What M114 tells first: the logical position, in mm.
struct Position {
  std::optional<double> x_mm;
  std::optional<double> y_mm;
  std::optional<double> z_mm;
  std::optional<double> e_mm;
  friend bool operator==(const Position&, const Position&) = default;
};

struct Reply {
  enum class Kind {
    kUnknown,
    kOk,
    kResend,
    kBusy,
    kTemperatures,
    kError,
    kHalted,
    kStart,
    kWait,
    kAction,
    kPosition,
    kUnknownCommand,
    kEcho,
    kAlarm,
    kNote,
    kFirmwareName,
    kCapability,
  };

  Kind kind = Kind::kUnknown;

  // kResend: the line asked for. kOk: N of an ADVANCED_OK.
  std::optional<std::int64_t> number;

  // kOk: free planner blocks (P) and command slots (B) of an ADVANCED_OK.
  std::optional<std::int32_t> planner_free;
  std::optional<std::int32_t> slots_free;

  // kTemperatures, and kOk that answers M105.
  Temperatures temperatures;

  // kPosition.
  Position position;

  // What follows the prefix: the error's words, the action, the unknown command; of kUnknown the
  // whole line. It points into the line that was read.
  std::string_view text;
};

// Reads one line; \r at its end and blanks at its start are ignored. Never fails, any bytes may
// come. COSTS: linear in the line.
[[nodiscard]] Reply read_reply(std::string_view line);

// Cuts a stream of bytes into lines, at each \n and each \r: some end lines with both, in either
// order, some with \r alone. Empty lines are left out. A line over kReplyBytesMax loses its end and
// is counted.
class LineSplitter {
 public:
  // Takes bytes up to and with the first end of line, and returns how many. line() then has the
  // line that has ended.
  [[nodiscard]] std::size_t take(std::span<const std::byte> bytes);

  // That line, without its end; nullopt when none has ended. Valid until the next take().
  [[nodiscard]] std::optional<std::string_view> line() const;

  [[nodiscard]] std::int64_t lines_cut() const { return lines_cut_; }

 private:
  std::array<char, kReplyBytesMax> bytes_{};
  std::size_t size_ = 0;
  bool complete_ = false;
  bool cutting_ = false;
  std::int64_t lines_cut_ = 0;
};

}  // namespace firmware_link
