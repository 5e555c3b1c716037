#include "host/part/height_check.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "host/part/bed_placing.h"  // mm_text

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Length;
using core::Status;

constexpr const char* kWhatToDo = "; repair the mesh, or say --tall if it is meant to be so high";

struct Height {
  std::int64_t low, high;
  core::LayerIndex layers;
};

Height height_of(const MeshSurvey& survey, const core::LayerHeights& heights) {
  const std::int64_t low = survey.extent().lowest_z, high = *survey.highest_cut();
  return {low, high, heights.count(Length::from_units(high - low))};
}

Error asked(const std::string& name, const Height& height, const std::string& cause) {
  return {ErrorCode::kOutOfBounds, name + ": the part is " + mm_text(height.high - height.low) +
                                       " mm high, " + std::to_string(height.layers) +
                                       " layers: " + cause + kWhatToDo};
}

std::int64_t wide(const core::Box& box) {
  return std::max(std::int64_t{box.max.x} - box.min.x, std::int64_t{box.max.y} - box.min.y);
}

std::string whole_mm(std::int64_t units) {
  const auto mm = static_cast<std::int64_t>(core::kUnitsPerMm);
  return std::to_string((units + mm / 2) / mm);
}

Status check_strays(const MeshSurvey& survey, const std::string& name, const Height& height) {
  const std::optional<OutermostCorners::End> top = survey.outermost().end(Direction::kUp);
  const std::optional<OutermostCorners::End> bottom = survey.outermost().end(Direction::kDown);
  if (!top || !bottom) return {};
  for (const bool upwards : {true, false}) {
    const OutermostCorners::End& end = upwards ? *top : *bottom;
    const std::int64_t rest =
        std::max<std::int64_t>(upwards ? end.rest - height.low : height.high - end.rest, 0);
    // The other end may have stray corners, too.
    const std::int64_t inner = std::clamp<std::int64_t>(top->rest - bottom->rest, 0, rest);
    const std::int64_t longest = std::max(inner, wide(survey.extent().box));
    if (end.alone < Length::from_mm(kStrayAlone_mm).units() || end.alone / kStrayTimes < longest) {
      continue;
    }
    return asked(name, height,
                 corner_text(end.corner) + ", and all the rest is " + mm_text(inner) + " mm high");
  }
  return {};
}

Status check_gap(MeshSurvey& survey, const std::string& name, const Height& height) {
  const MeshSurvey::Gap gap = survey.widest_gap();
  if (gap.high - gap.low < Length::from_mm(kAirGap_mm).units()) return {};
  const bool below = gap.low - height.low < height.high - gap.high;
  const auto end = survey.outermost().end(below ? Direction::kDown : Direction::kUp);
  return asked(name, height,
               "no facet stands between " + mm_text(gap.low - height.low) + " and " +
                   mm_text(gap.high - height.low) + " mm above its lowest point" +
                   (end ? " (" + corner_text(end->corner) + ")" : ""));
}

Status check_fill(const MeshSurvey& survey, const std::string& name, const Height& height) {
  if (height.layers <= kLayersUnasked) return {};
  const HeightFill::Stretch empty = survey.fill().longest_empty();
  if (empty.high - empty.low <= (height.high - height.low) / kEmptyShare) return {};
  const auto end = survey.outermost().end(Direction::kUp);
  return asked(name, height,
               "between about " + whole_mm(empty.low - height.low) + " and " +
                   whole_mm(empty.high - height.low) +
                   " mm above its lowest point no facet has a corner" +
                   (end ? " (" + corner_text(end->corner) + ")" : ""));
}

}  // namespace

Status check_height(MeshSurvey& survey, const core::LayerHeights& heights,
                    const std::string& name) {
  const Height height = height_of(survey, heights);
  if (Status fine = check_strays(survey, name, height); !fine.ok()) return fine;
  if (Status fine = check_gap(survey, name, height); !fine.ok()) return fine;
  return check_fill(survey, name, height);
}

Status check_height_so_far(const MeshSurvey& survey, const core::LayerHeights& heights,
                           const std::string& name) {
  const MeshSurvey::TallFacet& facet = survey.tallest();
  const core::LayerIndex layers = heights.count(Length::from_units(facet.span));
  if (layers <= kLayersUnasked) return {};
  return Error{ErrorCode::kOutOfBounds, name + ": " + corner_text(facet.corner) +
                                            ", and alone is " + mm_text(facet.span) + " mm high, " +
                                            std::to_string(layers) + " layers" + kWhatToDo};
}

std::string stray_text(const MeshSurvey& survey) {
  const MeshExtent& extent = survey.extent();
  const std::array<std::int64_t, 3> sizes{std::int64_t{extent.box.max.x} - extent.box.min.x,
                                          std::int64_t{extent.box.max.y} - extent.box.min.y,
                                          extent.highest_z - extent.lowest_z};
  std::string text;
  for (std::size_t i = 0; i < kDirections; ++i) {
    const auto end = survey.outermost().end(static_cast<Direction>(i));
    const std::int64_t size = sizes[i / 2];
    if (!end || end->alone < size / 2) continue;
    text += "; " + corner_text(end->corner) + ": without it the part would be only " +
            mm_text(size - end->alone) + (i / 2 == 2 ? " mm high" : " mm wide there");
  }
  return text;
}

}  // namespace host
