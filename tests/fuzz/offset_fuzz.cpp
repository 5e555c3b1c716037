// Offsets of whatever libFuzzer thinks of. ctest replays random bytes through the same checks
// (tests/core/kernel_cases_test.cpp).
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/support/offset_checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kSizeMax = 100;
  if (size > kSizeMax) return 0;
  const std::string wrong = test::check_offset_case({data, size});
  if (!wrong.empty()) {
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
  }
  return 0;
}
