// Seeds: the folder format_samples, which host_formats_damage_test writes (tests/CMakeLists.txt).
#include "tests/support/format_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::read_as(host::FileKind::kAmf, data, size);
  return 0;
}
