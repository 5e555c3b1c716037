#include "host/part/shrinkage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"  // clean
#include "core/limits.h"            // kCoordinateMax
#include "host/part/bed_placing.h"  // mm_text

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Triangle;

class EnlargedTriangles : public TriangleSource {
 public:
  EnlargedTriangles(std::unique_ptr<TriangleSource> triangles, const Enlargement& by,
                    std::string name)
      : triangles_(std::move(triangles)), by_(by), name_(std::move(name)) {}

  [[nodiscard]] std::string format() const override { return triangles_->format(); }

  [[nodiscard]] Result<std::optional<Triangle>> next() override {
    Result<std::optional<Triangle>> read = triangles_->next();
    facets_ = triangles_->facets();
    if (warnings_.size() != triangles_->warnings().size()) warnings_ = triangles_->warnings();
    if (!read.ok() || !read.value()) {
      doubt_ = triangles_->doubt();
      return read;
    }
    Result<Triangle> larger = by_.of(*read.value());
    if (larger.ok()) return std::optional<Triangle>(larger.value());
    return Error{larger.error().code,
                 name_ + ": facet " + std::to_string(facets_) + ": " + larger.error().message};
  }

 private:
  std::unique_ptr<TriangleSource> triangles_;
  Enlargement by_;
  std::string name_;
};

}  // namespace

Result<core::Point> Enlargement::of(core::Point point) const {
  const std::int64_t x = std::llround(point.x * xy_), y = std::llround(point.y * xy_);
  if (std::max(std::abs(x), std::abs(y)) <= core::kCoordinateMax) {
    return core::Point{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
  }
  return Error{ErrorCode::kOutOfBounds, "made larger for shrinkage_xy, it reaches " +
                                            mm_text(std::max(std::abs(x), std::abs(y))) +
                                            " mm from the origin; move it nearer"};
}

Result<Triangle> Enlargement::of(const Triangle& triangle) const {
  Triangle larger;
  for (std::size_t i = 0; i < 3; ++i) {
    const core::Vertex& corner = triangle.corners[i];
    const Result<core::Point> at = of(core::Point{corner.x, corner.y});
    if (!at.ok()) return at.error();
    const auto z = std::llround(static_cast<double>(corner.z) * z_);
    larger.corners[i] = {at.value().x, at.value().y, z};
  }
  return larger;
}

Result<core::Region> Enlargement::of(const core::Region& region) const {
  if (xy_ == 1) return region;
  std::vector<core::Ring> rings = region.rings();
  for (core::Ring& ring : rings) {
    for (core::Point& point : ring) {
      const Result<core::Point> at = of(point);
      if (!at.ok()) return at.error();
      point = at.value();
    }
  }
  return core::clean(rings, core::FillRule::kPositive);
}

Result<core::Box> Enlargement::of(const core::Box& box) const {
  const Result<core::Point> min = of(box.min), max = of(box.max);
  if (!min.ok()) return min.error();
  if (!max.ok()) return max.error();
  return core::Box{min.value(), max.value()};
}

std::unique_ptr<TriangleSource> enlarged(std::unique_ptr<TriangleSource> triangles,
                                         const Enlargement& by, const std::string& name) {
  if (by.none()) return triangles;
  return std::make_unique<EnlargedTriangles>(std::move(triangles), by, name);
}

}  // namespace host
