// A part is made larger by as much as its filament shrinks when it cools: by 1 / (1 − shrinkage),
// sideways and in height by themselves. It is done to what is read, before anything else sees it.
#pragma once

#include <memory>
#include <string>

#include "core/geometry.h"                 // Box, Triangle
#include "core/regions/region.h"           // Region
#include "core/result.h"                   // Result
#include "core/settings.h"                 // Settings
#include "host/formats/triangle_source.h"  // TriangleSource

namespace host {

class Enlargement {
 public:
  explicit Enlargement(const core::Settings& settings)
      : xy_(1 / (1 - settings.shrinkage_xy)), z_(1 / (1 - settings.shrinkage_z)) {}

  [[nodiscard]] bool none() const { return xy_ == 1 && z_ == 1; }
  [[nodiscard]] bool of_heights() const { return z_ != 1; }

  // About the origin, to the nearest unit. Errors: a corner beyond ±kCoordinateMax.
  [[nodiscard]] core::Result<core::Triangle> of(const core::Triangle& triangle) const;
  // Sideways. What rounding makes of it is cleaned.
  [[nodiscard]] core::Result<core::Region> of(const core::Region& region) const;
  [[nodiscard]] core::Result<core::Box> of(const core::Box& box) const;

 private:
  [[nodiscard]] core::Result<core::Point> of(core::Point point) const;

  double xy_;
  double z_;
};

// The same triangles, enlarged. `name`: of the file, for messages.
[[nodiscard]] std::unique_ptr<TriangleSource> enlarged(std::unique_ptr<TriangleSource> triangles,
                                                       const Enlargement& by,
                                                       const std::string& name);

}  // namespace host
