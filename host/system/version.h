// The program's version, "0.1.0+1a2b3c4": the number from CMakeLists.txt (project), and the commit,
// which each build adds (tools/version.cmake).
#pragma once

namespace host {

extern const char* const kVersion;

}  // namespace host
