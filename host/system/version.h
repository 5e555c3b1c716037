// The program's version. It stands in CMakeLists.txt (project); the commit is added by each build
// (tools/version.cmake), so that two builds differ: "0.1.0+1a2b3c4".
#pragma once

namespace host {

extern const char* const kVersion;

}  // namespace host
