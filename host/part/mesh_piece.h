// What is printed of a mesh, all of it or a piece (cut_plane.h), and whether it can be printed.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/geometry.h"                 // Triangle
#include "core/result.h"                   // Status
#include "core/settings.h"                 // Settings
#include "core/slices/layer_heights.h"     // LayerHeights
#include "host/formats/mesh_extent.h"      // MeshExtent
#include "host/formats/triangle_source.h"  // TriangleSource
#include "host/part/cut_plane.h"           // CutPlane
#include "host/part/mesh_survey.h"         // MeshSurvey

namespace host {

using TriangleOpener = std::function<core::Result<std::unique_ptr<TriangleSource>>()>;
using NextTriangle = std::function<core::Result<std::optional<core::Triangle>>()>;

// The triangles of a file that is opened with the first one.
[[nodiscard]] NextTriangle reopened(const TriangleOpener& open);

// Starts as all of the mesh. A piece is surveyed by a pass of its own, since the plane is known
// when the mesh was read.
class MeshPiece {
 public:
  // Reads all facets once more, if there is a cut. REQUIRES: a facet of the mesh can be cut. Errors
  // are those of CutPlane::of() and of `next`.
  [[nodiscard]] core::Status cut(const core::Settings& settings, const MeshSurvey& whole,
                                 const std::string& name, const NextTriangle& next);

  [[nodiscard]] bool is_cut() const { return plane_.has_value(); }
  // Whether the sweep needs the facet.
  [[nodiscard]] bool keeps(const core::Triangle& triangle) const {
    return !plane_ || plane_->keeps(triangle);
  }

  // Of the piece; of the whole mesh if it is not cut.
  [[nodiscard]] MeshSurvey& survey(MeshSurvey& whole) { return plane_ ? *survey_ : whole; }
  // What the facets' slopes and the cut face allow.
  [[nodiscard]] std::optional<core::HeightLimits> limits(const MeshSurvey& whole) const;

 private:
  std::optional<CutPlane> plane_;
  std::optional<MeshSurvey> survey_;
};

// Errors: nothing that a plane can cross.
[[nodiscard]] core::Status check_not_flat(const MeshSurvey& survey, const std::string& name);

// Errors: lower than half a layer, narrower than any road.
[[nodiscard]] core::Status check_size(const MeshExtent& extent, core::Length height,
                                      const core::LayerHeights& heights,
                                      const core::Settings& settings, const std::string& name);

}  // namespace host
