// A source of triangles from a list, like a file or a pipe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry.h"                 // Triangle
#include "host/formats/triangle_source.h"  // TriangleSource
#include "host/part/mesh_layers.h"         // MeshInput

namespace test {

class ListedTriangles : public host::TriangleSource {
 public:
  // `taken` counts the triangles read.
  ListedTriangles(std::shared_ptr<const std::vector<core::Triangle>> triangles,
                  std::shared_ptr<std::int64_t> taken)
      : triangles_(std::move(triangles)), taken_(std::move(taken)) {}

  [[nodiscard]] std::string format() const override { return "list"; }

  [[nodiscard]] core::Result<std::optional<core::Triangle>> next() override {
    if (next_ == triangles_->size()) return std::optional<core::Triangle>();
    ++facets_;
    ++*taken_;
    return std::optional<core::Triangle>((*triangles_)[next_++]);
  }

 private:
  std::shared_ptr<const std::vector<core::Triangle>> triangles_;
  std::shared_ptr<std::int64_t> taken_;
  std::size_t next_ = 0;
};

struct ListedMesh {
  host::MeshInput input;
  std::shared_ptr<std::int64_t> taken;  // triangles that were read, over all readings
};

inline ListedMesh listed_mesh(std::vector<core::Triangle> triangles, bool pipe) {
  auto list = std::make_shared<const std::vector<core::Triangle>>(std::move(triangles));
  auto taken = std::make_shared<std::int64_t>(0);
  ListedMesh mesh{{"list", std::make_unique<ListedTriangles>(list, taken), {}}, taken};
  if (pipe) return mesh;
  mesh.input.again = [list, taken]() -> core::Result<std::unique_ptr<host::TriangleSource>> {
    return std::unique_ptr<host::TriangleSource>(std::make_unique<ListedTriangles>(list, taken));
  };
  return mesh;
}

}  // namespace test
