#include "core/check.h"

#include <cstdio>
#include <cstdlib>

namespace core {

void check_failed(const char* condition, const char* file, int line) {
  // The one place where core writes anything: the program is about to end, and its own log may be
  // what is broken.
  std::fprintf(stderr, "rind: internal error: RIND_CHECK(%s) failed at %s:%d\n", condition, file,
               line);
  std::abort();
}

}  // namespace core
