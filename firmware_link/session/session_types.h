// What passes between a session and its host, besides commands and bytes.
#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware_link/wire/instant.h"  // Duration
#include "firmware_link/wire/limits.h"   // kLineNumberMax
#include "firmware_link/wire/reply.h"    // Temperatures

namespace firmware_link {

// Commands in the safe sequence of a stop, at most.
inline constexpr std::size_t kSafeSequenceMax = 16;

enum class SessionState {
  kConnecting,
  kStreaming,
  kFinishing,  // all was taken; answers are waited for
  kFinished,   // the controller has every line, and has acknowledged it
  kStopping,   // the safe sequence is on its way
  kStopped,    // the safe sequence has been acknowledged
  kFaulted,    // final; reason() says why
};

enum class FaultKind {
  kNone,
  kNoAnswer,  // never answered at all
  kSilence,   // answered, and then no more
  kRefusals,  // one line again and again
  kReset,     // `start` in mid-print
  kHalted,    // kill(), a thermal fault that the controller itself saw, a shutdown
  kAlarm,     // `!!`: it refused a command, and still obeys others
  kHeater,    // a heater does not do what it was told: halt the controller, it may burn
  kPosition,  // it is not where it was sent
  kStop,      // the safe sequence was not acknowledged in time
  kPortLost,  // the device has gone
};

struct SessionStatistics {
  std::int64_t commands_taken = 0;
  std::int64_t commands_sent = 0;          // without repeats
  std::int64_t commands_acknowledged = 0;  // as Session::accepted()
  std::int64_t lines_sent = 0;             // with repeats, and with the link's own
  std::int64_t bytes_sent = 0;             // with repeats
  std::int64_t lines_packed = 0;           // of the lines sent
  std::int64_t lines_repeated = 0;
  std::int64_t resends = 0;                 // `Resend:` lines obeyed
  std::int64_t resends_ignored = 0;         // outside of what can be repeated
  std::int64_t resyncs = 0;                 // forced mismatches after a silence
  std::int64_t stalls = 0;                  // nothing in flight and nothing to send in mid-stream
  std::int64_t fragments = 0;               // complaints about damaged lines, or damaged themselves
  std::int64_t warnings = 0;                // unknown commands, errors that are not fatal
  std::int64_t stray_acknowledgements = 0;  // an `ok` that no line of ours explains
  std::int64_t replies_cut = 0;             // over kReplyBytesMax
  std::int64_t positions_checked = 0;
  std::int64_t filament_corrections = 0;  // a line ran in part or twice, and was made up for
  std::int64_t events_dropped = 0;
  std::size_t lines_in_flight = 0;
  std::size_t bytes_in_flight = 0;
  std::size_t lines_in_flight_max = 0;
  std::size_t bytes_in_flight_max = 0;
  double planner_low_s = 0;  // planner_watch.h
  Temperatures temperatures;

  [[nodiscard]] double resend_ratio() const {
    return lines_sent == 0 ? 0 : static_cast<double>(resends) / static_cast<double>(lines_sent);
  }
};

struct SessionOptions {
  // How long a `start` is waited for before the greeting is sent. A boot loader eats what comes in
  // its first 1.5 s.  DEFAULT: 2.5 s.
  Duration banner_wait{2'500'000};

  // How long the answer to a greeting may take before the next is sent, and how many are sent.
  Duration greeting_wait{3'000'000};
  int greetings_max = 5;

  // How often one line may be asked for again, and how many forced mismatches in a row may have no
  // success.
  int repeats_of_a_line_max = 10;
  int resyncs_in_a_row_max = 4;

  // How long a controller that answers may take to be ready to print (Klipper, while it starts).
  Duration ready_wait{120'000'000};

  // Each limit of a wait for an answer (command_waits.h) is at least this.  DEFAULT: none.
  Duration wait_limit{0};

  // How long the safe sequence of stop_now() may take; and how long it may wait before that for a
  // command that takes long by nature (homing, probing), or that says that it works.
  Duration stop_limit{10'000'000};
  Duration long_stop_limit{600'000'000};

  // Temperatures come this often, by M155 or M105.  DEFAULT: 2 s.  REQUIRES: whole seconds.
  // 0: only when something else is said.
  Duration temperature_interval{2'000'000};

  // How much filament is corrected at a time, and how often, where a line ran twice or not at all;
  // more is a fault.  DEFAULT: 0.5 mm, 10 times.
  std::int64_t filament_correction_10nm_max = 50'000;
  int filament_corrections_max = 10;

  // Compare the controller's count of filament with what it was given. It is set to 0 for that now
  // and then (G92 E0), which commands with absolute filament do not bear.
  bool count_filament = true;

  // Ask a controller that did not reset for its last line, before the greeting makes it forget that
  // (Session::found_line()).
  bool ask_found_line = false;

  // Pack lines (MeatPack) where the controller offers it.  DEFAULT: no, because a lost byte takes
  // two characters along, and two that are alike do not change the checksum.
  bool pack = false;

  // Numbering starts again from 1 (by M110) after this line. Lower only in tests.
  std::int32_t line_number_max = kLineNumberMax;
};

}  // namespace firmware_link
