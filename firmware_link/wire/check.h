// LINK_CHECK stops the program on a broken contract: our bug, never the user's input.
// It stays on in release builds (the prefix is for doctest, which owns CHECK). LINK_DCHECK is for
// hot loops and is on in debug and sanitizer builds.
#pragma once

namespace firmware_link {

[[noreturn]] void check_failed(const char* condition, const char* file, int line);

}  // namespace firmware_link

#define LINK_CHECK(condition)             \
  (static_cast<bool>(condition) ? void(0) \
                                : ::firmware_link::check_failed(#condition, __FILE__, __LINE__))

#ifdef NDEBUG
#define LINK_DCHECK(condition) void(0)
#else
#define LINK_DCHECK(condition) LINK_CHECK(condition)
#endif
