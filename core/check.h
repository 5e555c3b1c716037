// RIND_CHECK stops the program on a broken contract: our bug, never the user's input.
// It stays on in release builds (the prefix is for doctest, which owns CHECK). RIND_DCHECK is for
// hot loops and is on in debug and sanitizer builds.
#pragma once

namespace core {

[[noreturn]] void check_failed(const char* condition, const char* file, int line);

}  // namespace core

#define RIND_CHECK(condition) \
  (static_cast<bool>(condition) ? void(0) : ::core::check_failed(#condition, __FILE__, __LINE__))

#ifdef NDEBUG
#define RIND_DCHECK(condition) void(0)
#else
#define RIND_DCHECK(condition) RIND_CHECK(condition)
#endif
