#include "firmware_link/wire/check.h"

#include <cstdio>
#include <cstdlib>

namespace firmware_link {

void check_failed(const char* condition, const char* file, int line) {
  // The one place where the link writes anything: the program is about to end, and its own log may
  // be what is broken.
  std::fprintf(stderr, "rind: internal error: LINK_CHECK(%s) failed at %s:%d\n", condition, file,
               line);
  std::abort();
}

}  // namespace firmware_link
