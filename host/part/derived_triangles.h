// A mesh's triangles as another source gives them, each looked at or changed on its way.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/geometry.h"                 // Triangle
#include "core/result.h"                   // Result
#include "host/formats/triangle_source.h"  // TriangleSource

namespace host {

class DerivedTriangles : public TriangleSource {
 public:
  explicit DerivedTriangles(std::unique_ptr<TriangleSource> under) : under_(std::move(under)) {}

  [[nodiscard]] std::string format() const override { return under_->format(); }
  [[nodiscard]] std::vector<std::string> items() const override { return under_->items(); }
  [[nodiscard]] std::size_t item() const override { return under_->item(); }

  [[nodiscard]] core::Result<bool> rewind() override {
    core::Result<bool> rewound = under_->rewind();
    if (rewound.ok() && rewound.value()) facets_ = 0;
    return rewound;
  }

  [[nodiscard]] core::Result<std::optional<core::Triangle>> next() override {
    core::Result<std::optional<core::Triangle>> read = under_->next();
    facets_ = under_->facets();
    if (warnings_.size() != under_->warnings().size()) warnings_ = under_->warnings();
    if (read.ok() && read.value()) return derived(*read.value());
    doubt_ = under_->doubt();
    return read;
  }

 private:
  // What is given for a triangle. Errors are final. After rewind() all triangles come once more.
  [[nodiscard]] virtual core::Result<std::optional<core::Triangle>> derived(
      const core::Triangle& triangle) = 0;

  std::unique_ptr<TriangleSource> under_;
};

}  // namespace host
