#pragma once

#ifndef RIND_VERSION
#define RIND_VERSION "0.1.0"
#endif

namespace host {

inline constexpr const char* kVersion = RIND_VERSION;

}  // namespace host
