// What a slicer says of a 3MF's bodies, beside a model that is sound.
#include <string>

#include "tests/support/format_fuzz.h"
#include "tests/support/mesh_files.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string zip =
      test::two_volume_threemf_file(std::string(reinterpret_cast<const char*>(data), size));
  test::read_as(host::FileKind::kZip, reinterpret_cast<const std::uint8_t*>(zip.data()),
                zip.size());
  return 0;
}
