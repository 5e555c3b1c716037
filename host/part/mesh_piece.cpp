#include "host/part/mesh_piece.h"

#include <algorithm>
#include <utility>

#include "core/roads/beading.h"     // kRoomSlack
#include "host/part/bed_placing.h"  // mm_text

namespace host {

NextTriangle reopened(const TriangleOpener& open) {
  // Shared: a std::function is copied.
  auto file = std::make_shared<std::unique_ptr<TriangleSource>>();
  return [open, file]() -> core::Result<std::optional<core::Triangle>> {
    if (!*file) {
      core::Result<std::unique_ptr<TriangleSource>> again = open();
      if (!again.ok()) return again.error();
      *file = std::move(again).value();
    }
    return (*file)->next();
  };
}

using core::Error;
using core::ErrorCode;
using core::Length;
using core::Status;

Status MeshPiece::cut(const core::Settings& settings, const MeshSurvey& whole,
                      const std::string& name, const NextTriangle& next) {
  core::Result<std::optional<CutPlane>> plane =
      CutPlane::of(settings, whole.extent().lowest_z, *whole.highest_cut(), name);
  if (!plane.ok()) return plane.error();
  plane_ = plane.value();
  if (!plane_) return {};
  // Only extents, and heights without facets, are asked of it; order does not matter.
  survey_.emplace(2);
  while (true) {
    const core::Result<std::optional<core::Triangle>> read = next();
    if (!read.ok()) return read.error();
    if (!read.value()) return {};
    const core::Triangle& triangle = *read.value();
    if (!can_be_cut(triangle) || !plane_->keeps(triangle)) continue;
    for (const core::Triangle& part : plane_->clipped(triangle)) (void)survey_->add(part);
  }
}

std::optional<core::HeightLimits> MeshPiece::limits(const MeshSurvey& whole) const {
  std::optional<core::HeightLimits> limits = whole.limits();
  if (limits && plane_) limits->add(plane_->face(survey_->extent().box));
  return limits;
}

Status check_not_flat(const MeshSurvey& survey, const std::string& name) {
  if (survey.highest_cut()) return {};
  return Error{ErrorCode::kBadPart,
               name + ": the part is flat, it has no height; export it as a solid"};
}

Status check_size(const MeshExtent& extent, Length height, const core::LayerHeights& heights,
                  const core::Settings& settings, const std::string& name) {
  const bool cut = is_cut(settings);
  const std::string what = name + (cut ? ": the piece is " : ": the part is ");
  const std::optional<std::string> unit = cut ? std::nullopt : unit_question(extent);
  if (heights.count(height) == 0) {
    return Error{
        ErrorCode::kBadPart,
        what + mm_text(height.units()) + " mm high, less than half a layer of " +
            mm_text(heights.height(0).units()) + " mm; " +
            (cut ? "cut it at another height, or"
                 : (unit ? *unit + " Otherwise" : "check its unit, or")) +
            " lower " +
            (settings.first_layer_height > Length() ? "first_layer_height" : "layer_height")};
  }
  const core::Box& box = extent.box;
  const std::int64_t narrowest =
      std::min(std::int64_t{box.max.x} - box.min.x, std::int64_t{box.max.y} - box.min.y);
  if (narrowest >= (settings.road_width_min - core::kRoomSlack).units()) return {};
  return Error{ErrorCode::kBadPart, what + mm_text(narrowest) +
                                        " mm wide, narrower than any road (road_width_min); " +
                                        unit.value_or("make it wider")};
}

}  // namespace host
