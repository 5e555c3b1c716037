#include "host/part/bad_layers.h"

#include <fmt/format.h>

namespace host {

std::string bad_layer_word(OnBadLayer action) {
  switch (action) {
    case OnBadLayer::kRepair:
      return "repair";
    case OnBadLayer::kNeighbour:
      return "neighbour";
    case OnBadLayer::kPause:
      return "pause";
    case OnBadLayer::kStop:
      return "stop";
  }
  return "repair";
}

OnBadLayer bad_layer_of(const std::string& word) {
  for (const OnBadLayer action : {OnBadLayer::kNeighbour, OnBadLayer::kPause, OnBadLayer::kStop}) {
    if (bad_layer_word(action) == word) return action;
  }
  return OnBadLayer::kRepair;
}

std::optional<std::string> why_bad(const core::SliceDefects& defects, bool empty, bool more_above) {
  if (defects.dropped_chains > 0) {
    return fmt::format("{} open contour{} can't be closed", defects.dropped_chains,
                       defects.dropped_chains == 1 ? "" : "s");
  }
  if (empty && more_above) return "it is empty, and the part continues above it";
  return std::nullopt;
}

core::Result<std::optional<std::string>> BadLayers::check(core::Slice& slice,
                                                          core::LayerIndex layers) {
  // A part from a pipe ends with its last slice that is not empty.
  const bool more_above = layers == 0 || slice.index + 1 < layers;
  const std::optional<std::string> why = why_bad(slice.defects, slice.region.empty(), more_above);
  if (!why) {
    if (action_ == OnBadLayer::kNeighbour) below_ = slice.region;
    return std::optional<std::string>();
  }
  ++count_;
  const std::string place =
      fmt::format("{}, layer {} at {:g} mm: {}", part_, slice.index + 1, slice.top().mm(), *why);
  if (action_ == OnBadLayer::kStop) {
    return core::Error{core::ErrorCode::kBadPart,
                       place + "; repair the mesh, or say --on-bad-layer repair"};
  }
  if (action_ == OnBadLayer::kPause) {
    warnings_.put(place + "; the print will pause before it");
    return std::optional(place);
  }
  const bool copied = action_ == OnBadLayer::kNeighbour && !below_.empty();
  if (copied) slice.region = below_;
  warnings_.put(place + (copied ? "; the slice below is printed once more" : ""));
  return std::optional<std::string>();
}

}  // namespace host
