// The program's exit codes.
#pragma once

#include <array>
#include <string_view>

namespace host {

inline constexpr int kExitDone = 0;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitBadInput = 3;   // the part, a setting, or a file that can't be written
inline constexpr int kExitLinkFault = 4;  // the link was lost, or the controller gave up
inline constexpr int kExitStopped = 5;    // by the user

// What help and manual pages say of them.
struct ExitText {
  int code;
  std::string_view meaning;
};
inline constexpr std::array kExitTexts = {ExitText{kExitDone, "done"},
                                          ExitText{kExitUsage, "usage"},
                                          ExitText{kExitBadInput, "bad part or setting"},
                                          ExitText{kExitLinkFault, "link lost or controller fault"},
                                          ExitText{kExitStopped, "stopped by the user"}};

}  // namespace host
