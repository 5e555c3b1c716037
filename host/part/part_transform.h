// What is done to all that is read of a part, before anything else sees it, in this order:
//
//     part_units      numbers of a file that does not tell its unit, in mm
//     part_scale      "2", "150%", along x, y, z "1,1,2"; "to 100": its longest side is 100 mm
//     part_mirror     along an axis
//     part_rotation   in degrees, about x, then y, then z: "90,0,45"; "45": about z
//     shrinkage       larger by as much as the filament shrinks when it cools: by
//                     1 / (1 − shrinkage_xy) sideways, 1 / (1 − shrinkage_z) in height
//
// About the origin; where the part comes to lie on the bed is bed_placing.h's matter.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/geometry.h"                 // Box, Triangle
#include "core/regions/region.h"           // Region
#include "core/result.h"                   // Result
#include "core/settings.h"                 // Settings
#include "host/formats/triangle_source.h"  // TriangleSource

namespace host {

class PartTransform {
 public:
  // REQUIRES: check_part_transform() is fine.
  explicit PartTransform(const core::Settings& settings);

  [[nodiscard]] bool none() const;
  // Layers stay layers, of the same heights.
  [[nodiscard]] bool keeps_heights() const;
  // The part is turned over, so that its lowest place is another one.
  [[nodiscard]] bool tilts() const;
  // Factor of all three axes, units among it; 1 if they have factors of their own.
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] bool units_told() const { return units_told_; }
  // "to 100": how long the longest side becomes, in mm.
  [[nodiscard]] std::optional<double> longest_mm() const { return longest_mm_; }

  [[nodiscard]] PartTransform with_scale(double scale) const;

  // To the nearest unit. Errors: a corner beyond ±kCoordinateMax.
  [[nodiscard]] core::Result<core::Triangle> of(const core::Triangle& triangle) const;
  // Sideways. What rounding makes of it is cleaned. REQUIRES: not tilts()
  [[nodiscard]] core::Result<core::Region> of(const core::Region& region) const;
  [[nodiscard]] core::Result<core::Box> of(const core::Box& box) const;

 private:
  using Matrix = std::array<std::array<double, 3>, 3>;

  [[nodiscard]] core::Result<core::Point> of(core::Point point) const;
  [[nodiscard]] bool turns_inside_out() const;

  double scale_ = 1;
  bool units_told_ = false;
  std::optional<double> longest_mm_;
  Matrix matrix_;  // without scale_
};

// Whether the settings can be read: --scale, --rotate, --cut and the others.
[[nodiscard]] core::Status check_part_transform(const core::Settings& settings);

using OpenTriangles = std::function<core::Result<std::unique_ptr<TriangleSource>>()>;

// The same triangles, transformed. `again` opens the file once more, and is transformed likewise;
// it may be empty. `name`: of the file, for messages. Reads the file once for longest_mm().
// Errors: the file tells its own unit; longest_mm() of a pipe.
[[nodiscard]] core::Status transform(std::unique_ptr<TriangleSource>& triangles,
                                     OpenTriangles& again, const core::Settings& settings,
                                     const std::string& name);

}  // namespace host
