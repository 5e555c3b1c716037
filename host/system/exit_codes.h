// The program's exit codes.
#pragma once

namespace host {

inline constexpr int kExitDone = 0;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitBadInput = 3;   // the part, a setting, or a file that can't be written
inline constexpr int kExitLinkFault = 4;  // the link was lost, or the controller gave up
inline constexpr int kExitStopped = 5;    // by the user

}  // namespace host
