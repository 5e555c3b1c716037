#include "host/part/part_transform.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"     // clean
#include "core/limits.h"               // kCoordinateMax
#include "host/formats/mesh_extent.h"  // MeshExtent
#include "host/part/bed_placing.h"     // mm_text
#include "host/part/derived_triangles.h"
#include "host/part/transform_words.h"  // read_scale, read_rotation

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;
using core::Triangle;
using Matrix = std::array<std::array<double, 3>, 3>;

constexpr Matrix kIdentity = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
    }
  }
  return c;
}

Matrix diagonal(double x, double y, double z) { return {{{x, 0, 0}, {0, y, 0}, {0, 0, z}}}; }

// Right angles are exact.
double exact(double value) { return std::abs(value) < 1e-15 ? 0 : value; }

Matrix rotation(std::size_t axis, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const double c = exact(std::cos(angle)), s = exact(std::sin(angle));
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  Matrix turn = kIdentity;
  turn[i][i] = turn[j][j] = c;
  turn[i][j] = -s;
  turn[j][i] = s;
  return turn;
}

double unit_mm(core::PartUnits units) {
  constexpr double kInchMm = 25.4, kMetreMm = 1'000;
  if (units == core::PartUnits::kInch) return kInchMm;
  return units == core::PartUnits::kMetre ? kMetreMm : 1;
}

class TransformedTriangles : public DerivedTriangles {
 public:
  TransformedTriangles(std::unique_ptr<TriangleSource> triangles, const PartTransform& by,
                       std::string name)
      : DerivedTriangles(std::move(triangles)), by_(by), name_(std::move(name)) {}

 private:
  Result<std::optional<Triangle>> derived(const Triangle& triangle) override {
    Result<Triangle> made = by_.of(triangle);
    if (made.ok()) return std::optional<Triangle>(made.value());
    return Error{made.error().code,
                 name_ + ": facet " + std::to_string(facets_) + ": " + made.error().message};
  }

  PartTransform by_;
  std::string name_;
};

// A reader that takes the scale itself rounds only once.
std::unique_ptr<TriangleSource> transformed(std::unique_ptr<TriangleSource> triangles,
                                            const PartTransform& by, const std::string& name) {
  const bool read_so = by.scale() != 1 && triangles->read_in(by.scale());
  const PartTransform rest = read_so ? by.with_scale(1) : by;
  if (rest.none()) return triangles;
  return std::make_unique<TransformedTriangles>(std::move(triangles), rest, name);
}

// How long the longest side is, as transformed.
Result<double> longest_side(TriangleSource& triangles) {
  MeshExtent extent;
  while (true) {
    const Result<std::optional<Triangle>> next = triangles.next();
    if (!next.ok()) return next.error();
    if (!next.value()) break;
    extent.add(*next.value());
  }
  if (extent.box.empty()) return 0.0;
  const std::int64_t x = std::int64_t{extent.box.max.x} - extent.box.min.x;
  const std::int64_t y = std::int64_t{extent.box.max.y} - extent.box.min.y;
  const std::int64_t z = extent.highest_z - extent.lowest_z;
  return static_cast<double>(std::max({x, y, z})) / core::kUnitsPerMm;
}

Result<PartTransform> sized(const PartTransform& by, const OpenTriangles& again,
                            const std::string& name) {
  if (!again) {
    return Error{ErrorCode::kBadSetting,
                 name +
                     ": its size is known only when it has been read, and a pipe can't be read "
                     "twice: write it into a file, or give a factor to --scale"};
  }
  Result<std::unique_ptr<TriangleSource>> opened = again();
  if (!opened.ok()) return opened.error();
  const std::unique_ptr<TriangleSource> once =
      transformed(std::move(opened).value(), by.with_scale(1), name);
  const Result<double> side = longest_side(*once);
  if (!side.ok()) return side.error();
  if (side.value() <= 0) return by.with_scale(1);
  return by.with_scale(*by.longest_mm() / side.value());
}

}  // namespace

PartTransform::PartTransform(const core::Settings& settings) : matrix_(kIdentity) {
  const ScaleWords words = read_scale(settings.part_scale).value();
  const std::array<double, 3> turn = read_rotation(settings.part_rotation).value();
  units_told_ = settings.part_units != core::PartUnits::kMillimetre;
  longest_mm_ = words.longest_mm;
  const auto& [x, y, z] = words.factors;
  const bool alike = x == y && y == z;
  scale_ = unit_mm(settings.part_units) * (alike ? x : 1);
  if (!alike) matrix_ = diagonal(x, y, z);
  const auto mirrored = [&settings](core::PartMirror along) {
    return settings.part_mirror == along ? -1.0 : 1.0;
  };
  matrix_ = product(diagonal(mirrored(core::PartMirror::kX), mirrored(core::PartMirror::kY),
                             mirrored(core::PartMirror::kZ)),
                    matrix_);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (turn[axis] != 0) matrix_ = product(rotation(axis, turn[axis]), matrix_);
  }
  const double wider = 1 / (1 - settings.shrinkage_xy), higher = 1 / (1 - settings.shrinkage_z);
  matrix_ = product(diagonal(wider, wider, higher), matrix_);
}

bool PartTransform::none() const { return scale_ == 1 && matrix_ == kIdentity; }

bool PartTransform::tilts() const {
  return matrix_[0][2] != 0 || matrix_[1][2] != 0 || matrix_[2][0] != 0 || matrix_[2][1] != 0;
}

bool PartTransform::keeps_heights() const {
  return !tilts() && !longest_mm_ && scale_ * matrix_[2][2] == 1;
}

PartTransform PartTransform::with_scale(double scale) const {
  PartTransform other = *this;
  other.scale_ = scale;
  other.longest_mm_.reset();
  return other;
}

bool PartTransform::turns_inside_out() const {
  const Matrix& m = matrix_;
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
             m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) <
         0;
}

Result<core::Point> PartTransform::of(core::Point point) const {
  const double x = scale_ * point.x, y = scale_ * point.y;
  const std::int64_t to_x = std::llround(matrix_[0][0] * x + matrix_[0][1] * y);
  const std::int64_t to_y = std::llround(matrix_[1][0] * x + matrix_[1][1] * y);
  if (std::max(std::abs(to_x), std::abs(to_y)) <= core::kCoordinateMax) {
    return core::Point{static_cast<std::int32_t>(to_x), static_cast<std::int32_t>(to_y)};
  }
  return Error{ErrorCode::kOutOfBounds,
               "scaled, turned and made larger for shrinkage_xy, it reaches " +
                   mm_text(std::max(std::abs(to_x), std::abs(to_y))) +
                   " mm from the origin; move it nearer"};
}

Result<Triangle> PartTransform::of(const Triangle& triangle) const {
  Triangle made;
  for (std::size_t i = 0; i < 3; ++i) {
    const core::Vertex& corner = triangle.corners[i];
    const std::array<double, 3> from = {scale_ * corner.x, scale_ * corner.y,
                                        scale_ * static_cast<double>(corner.z)};
    std::array<double, 3> to{};
    for (std::size_t row = 0; row < 3; ++row) {
      to[row] = matrix_[row][0] * from[0] + matrix_[row][1] * from[1] + matrix_[row][2] * from[2];
    }
    const double farthest = std::max(std::abs(to[0]), std::abs(to[1]));
    if (farthest > core::kCoordinateMax || std::abs(to[2]) > 9e18) {
      return Error{ErrorCode::kOutOfBounds,
                   "scaled, turned and made larger for shrinkage_xy, it reaches " +
                       mm_text(std::llround(std::min(farthest, 9e18))) +
                       " mm from the origin; move it nearer, or make it smaller"};
    }
    made.corners[i] = {static_cast<std::int32_t>(std::llround(to[0])),
                       static_cast<std::int32_t>(std::llround(to[1])), std::llround(to[2])};
  }
  if (turns_inside_out()) std::swap(made.corners[1], made.corners[2]);
  return made;
}

Result<core::Region> PartTransform::of(const core::Region& region) const {
  if (none()) return region;
  std::vector<core::Ring> rings = region.rings();
  for (core::Ring& ring : rings) {
    for (core::Point& point : ring) {
      const Result<core::Point> at = of(point);
      if (!at.ok()) return at.error();
      point = at.value();
    }
    if (turns_inside_out()) std::reverse(ring.begin(), ring.end());
  }
  return core::clean(rings, core::FillRule::kPositive);
}

Result<core::Box> PartTransform::of(const core::Box& box) const {
  core::Box made;
  if (box.empty()) return made;
  for (const core::Point corner :
       {box.min, core::Point{box.max.x, box.min.y}, box.max, core::Point{box.min.x, box.max.y}}) {
    const Result<core::Point> at = of(corner);
    if (!at.ok()) return at.error();
    made.add(at.value());
  }
  return made;
}

Status check_part_transform(const core::Settings& settings) {
  if (const auto scale = read_scale(settings.part_scale); !scale.ok()) return scale.error();
  if (const auto turn = read_rotation(settings.part_rotation); !turn.ok()) return turn.error();
  const auto cut = read_cut(settings.cut);
  return cut.ok() ? Status() : cut.error();
}

Status transform(std::unique_ptr<TriangleSource>& triangles, OpenTriangles& again,
                 const core::Settings& settings, const std::string& name) {
  PartTransform by(settings);
  if (by.units_told() && !triangles->read_in(1)) {
    return Error{ErrorCode::kBadSetting,
                 name +
                     ": the file tells its own unit: leave --units out; --scale makes the part "
                     "larger"};
  }
  if (by.longest_mm()) {
    const Result<PartTransform> to_size = sized(by, again, name);
    if (!to_size.ok()) return to_size.error();
    by = to_size.value();
  }
  if (by.none()) return {};
  triangles = transformed(std::move(triangles), by, name);
  if (!again) return {};
  again = [open = std::move(again), by, name]() -> Result<std::unique_ptr<TriangleSource>> {
    Result<std::unique_ptr<TriangleSource>> opened = open();
    if (!opened.ok()) return opened;
    return transformed(std::move(opened).value(), by, name);
  };
  return {};
}

}  // namespace host
