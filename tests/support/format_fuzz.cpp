#include "tests/support/format_fuzz.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "core/check.h"
#include "host/formats/sif_reader.h"

namespace test {
namespace {

// Longer inputs find nothing that shorter ones do not.
constexpr std::size_t kSizeMax = 1 << 16;
// Copies of copies may be many; enough of them are enough.
constexpr int kItemsMax = 10'000;

void read_from(host::LayerReader& layers) {
  std::optional<core::Slice> last;
  for (int i = 0; i < kItemsMax; ++i) {
    core::Result<std::optional<core::Slice>> slice = layers.next();
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

void read_from(host::TriangleSource& triangles) {
  for (int i = 0; i < kItemsMax; ++i) {
    const auto triangle = triangles.next();
    if (!triangle.ok() || !triangle.value()) return;
  }
}

void read_from(host::ShellTree& tree) {
  for (const std::vector<host::Shell>& shells : tree.operands) {
    for (const host::Shell& shell : shells) {
      if (!tree.store.add_item(shell.key, shell.transform, shell.reversed, shell.role).empty()) {
        return;
      }
    }
  }
  for (int i = 0; i < kItemsMax && tree.store.next().triangle; ++i) {
  }
}

void read_triangles(host::FileKind kind, host::InputFile file) {
  if (kind == host::FileKind::kSif) {
    auto tree = host::read_sif(std::move(file));
    if (!tree.ok() || !tree.value()->is_plain()) return;
    return read_from(*host::plain_triangles(std::move(tree).value()));
  }
  auto triangles = host::open_triangles(kind, std::move(file));
  if (triangles.ok()) read_from(*triangles.value());
}

}  // namespace

void read_as(host::FileKind kind, const std::uint8_t* data, std::size_t size) {
  if (size > kSizeMax) return;
  host::InputFile file =
      host::InputFile::from_bytes("part", std::string(reinterpret_cast<const char*>(data), size));
  if (host::is_layers(kind)) {
    auto layers = host::open_layers(kind, std::move(file));
    if (layers.ok()) read_from(*layers.value());
  } else if (kind == host::FileKind::kZip) {
    auto opened = host::open_zip(std::move(file));
    if (opened.ok()) std::visit([](const auto& found) { read_from(*found); }, opened.value());
  } else {
    read_triangles(kind, std::move(file));
  }
}

}  // namespace test
