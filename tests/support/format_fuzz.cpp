#include "tests/support/format_fuzz.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/check.h"
#include "host/formats/sif_reader.h"

namespace test {
namespace {

// Longer inputs find nothing that shorter ones do not.
constexpr std::size_t kSizeMax = 1 << 16;
// Copies of copies may be many; enough of them are enough.
constexpr int kItemsMax = 10'000;

void read_layers(host::FileKind kind, host::InputFile file) {
  auto layers = host::open_layers(kind, std::move(file));
  if (!layers.ok()) return;
  std::optional<core::Slice> last;
  for (int i = 0; i < kItemsMax; ++i) {
    core::Result<std::optional<core::Slice>> slice = layers.value()->next();
    if (!slice.ok()) {
      RIND_CHECK(slice.error().message.size() > 20);
      return;
    }
    if (!slice.value()) return;
    RIND_CHECK(slice.value()->height > core::Length());
    RIND_CHECK(slice.value()->index == i);
    if (last) RIND_CHECK(last->top() == slice.value()->bottom);
    last = *std::move(slice).value();
  }
}

void read_triangles(host::FileKind kind, host::InputFile file) {
  if (kind == host::FileKind::kSif) {
    auto tree = host::read_sif(std::move(file));
    if (!tree.ok() || !tree.value()->is_plain()) return;
    const auto triangles = host::plain_triangles(std::move(tree).value());
    for (int i = 0; i < kItemsMax; ++i) {
      const auto triangle = triangles->next();
      if (!triangle.ok() || !triangle.value()) return;
    }
    return;
  }
  auto triangles = host::open_triangles(kind, std::move(file));
  if (!triangles.ok()) return;
  for (int i = 0; i < kItemsMax; ++i) {
    const auto triangle = triangles.value()->next();
    if (!triangle.ok() || !triangle.value()) return;
  }
}

}  // namespace

void read_as(host::FileKind kind, const std::uint8_t* data, std::size_t size) {
  if (size > kSizeMax) return;
  host::InputFile file =
      host::InputFile::from_bytes("part", std::string(reinterpret_cast<const char*>(data), size));
  if (host::is_layers(kind)) {
    read_layers(kind, std::move(file));
  } else {
    read_triangles(kind, std::move(file));
  }
}

}  // namespace test
