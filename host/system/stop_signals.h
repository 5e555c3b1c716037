// SIGINT, SIGTERM and SIGHUP. They are counted for the code that polls them, and end the program if
// it does not react in time.
//
//     while a print runs (set_at_stake)
//       any of them      the print is stopped safely: nozzle off the part, heaters off
//       second SIGINT    the controller is halted at once (M112). SIGTERM and SIGHUP never do that,
//                        however often they come: a closed terminal sends several
//     otherwise
//       any of them      code that polls stop_signal_count() ends in good order. kStopGrace_ms
//                        later the signal handler ends the program: it writes the last words,
//                        removes temporary files and exits with kExitStopped
//       second SIGINT    the handler does so at once
//
// SIGPIPE and SIGXFSZ are ignored: a closed pipe or a file at its size limit is an ordinary write
// error and must not end a print.
#pragma once

#include <string>

namespace host {

inline constexpr int kStopGrace_ms = 100;

// Installs the handlers. REQUIRES: called once, before any file is opened.
void watch_stop_signals();

// Stop signals received so far.
[[nodiscard]] int stop_signal_count();

// 0: no stop was requested; 1: stop safely; 2: halt (a second SIGINT).
[[nodiscard]] int stop_urgency();

// SIGUSR1 received so far: each pauses a print or resumes it.
[[nodiscard]] int pause_signal_count();

// True while a print runs: the handler then only counts, and the caller stops the print.
void set_at_stake(bool at_stake);

// Text that the handler writes when it ends the program. Cut off at kLastWordsMax bytes.
struct LastWords {
  std::string standard_output;
  std::string standard_error;
};
inline constexpr std::size_t kLastWordsMax = 2'048;
// REQUIRES: no other thread calls it at the same time.
void set_last_words(const LastWords& words);

// While one exists, the handler does not end the program. For a short step that must not be
// separated from its message.
class StopShield {
 public:
  StopShield();
  ~StopShield();
  StopShield(const StopShield&) = delete;
  StopShield& operator=(const StopShield&) = delete;
};

}  // namespace host
