// CHECK stops the program on a broken contract: our bug, never the user's input.
// It stays on in release builds. DCHECK is for hot loops and is on in debug and sanitizer builds.
#pragma once

namespace core {

[[noreturn]] void check_failed(const char* condition, const char* file, int line);

}  // namespace core

#define CHECK(condition) \
  (static_cast<bool>(condition) ? void(0) : ::core::check_failed(#condition, __FILE__, __LINE__))

#ifdef NDEBUG
#define DCHECK(condition) void(0)
#else
#define DCHECK(condition) CHECK(condition)
#endif
