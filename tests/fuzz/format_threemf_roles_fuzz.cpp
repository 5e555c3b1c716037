// What a slicer says of a 3MF's bodies, beside a model that is sound; marks for supports, too.
#include <string>
#include <utility>
#include <variant>

#include "core/check.h"
#include "host/formats/formats.h"
#include "tests/support/format_fuzz.h"
#include "tests/support/mesh_files.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string zip =
      test::two_volume_threemf_file(std::string(reinterpret_cast<const char*>(data), size));
  test::read_as(host::FileKind::kZip, reinterpret_cast<const std::uint8_t*>(zip.data()),
                zip.size());
  auto opened = host::open_zip(host::InputFile::from_bytes("part", zip));
  if (!opened.ok()) return 0;
  auto* mesh = std::get_if<std::unique_ptr<host::TriangleSource>>(&opened.value());
  if (mesh == nullptr) return 0;
  auto marks = (*mesh)->marked_facets();
  RIND_CHECK(marks.ok());
  RIND_CHECK((marks.value() != nullptr) == (*mesh)->mark_counts().any());
  return 0;
}
