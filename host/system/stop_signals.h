// SIGINT, SIGTERM and SIGHUP, as counts that anyone may look at, and as the program's end where
// nobody looks in time.
//
//     while a printer hangs on the program (set_at_stake)
//       any of them      the print is brought to a safe end: nozzle off the part, heaters off
//       second SIGINT    the controller is halted at once (M112); SIGTERM and SIGHUP never do that,
//                        however often they come: a closed terminal sends several
//     otherwise
//       any of them      whoever looks ends in good order; kStopGrace_ms later the signal's handler
//                        ends the program itself, whatever it computes or waits for: it says the
//                        last words, removes temporary names, and exits with kExitStopped
//       second SIGINT    the same, at once
//
// SIGPIPE and SIGXFSZ are ignored: a closed pipe or a file at its limit is a write error like any
// other, and must not end a print.
#pragma once

#include <string>

namespace host {

inline constexpr int kStopGrace_ms = 100;

// Once, before anything is opened.
void watch_stop_signals();

// How many have come.
[[nodiscard]] int stop_signal_count();

// How urgent it is: 0 nobody wants to stop, 1 a safe end, 2 halt (a second SIGINT).
[[nodiscard]] int stop_urgency();

// SIGUSR1: pause a print, and go on with it.
[[nodiscard]] int pause_signal_count();

// Whether signals are left to the caller, because a printer hangs on it.
void set_at_stake(bool at_stake);

// What is said on either when the handler ends the program; cut off at kLastWordsMax.
struct LastWords {
  std::string standard_output;
  std::string standard_error;
};
inline constexpr std::size_t kLastWordsMax = 2'048;
// Not for two threads at once.
void set_last_words(const LastWords& words);

// While one lives the handler does not end the program: for a step that must not be torn from what
// is said of it, and that is short.
class StopShield {
 public:
  StopShield();
  ~StopShield();
  StopShield(const StopShield&) = delete;
  StopShield& operator=(const StopShield&) = delete;
};

}  // namespace host
