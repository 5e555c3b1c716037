// SIGINT, SIGTERM and SIGHUP as a count that anyone may look at.
//
//     first    the print is brought to a safe end: nozzle off the part, heaters off
//     second   while something is at stake: the controller is halted at once (M112)
//              otherwise: the program ends at once
//
// SIGPIPE and SIGXFSZ are ignored: a closed pipe or a file at its limit is a write error like any
// other, and must not end a print.
#pragma once

namespace host {

// Once, before anything is opened.
void watch_stop_signals();

// How many have come.
[[nodiscard]] int stop_signal_count();

// SIGUSR1: pause a print, and go on with it.
[[nodiscard]] int pause_signal_count();

// Whether the second signal is left to the caller, because a printer hangs on it.
void set_at_stake(bool at_stake);

}  // namespace host
