// Tells each layer the corners of the slices above it, so that a seam can be put where a corner
// goes on. For that it keeps a layer back until they are known: the window's lowest layers, which
// leave it at once; all others leave it when T layers above are known.
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "core/regions/corner_index.h"  // CornerIndex
#include "core/settings.h"              // Settings
#include "core/units.h"                 // LayerIndex
#include "core/walls/split_layer.h"     // SplitLayer

namespace core {

// How many layers above each layer count for its seams: T, at most kSeamLayersAheadMax; none where
// seams don't ask for them.
[[nodiscard]] int seam_layers_ahead(const Settings& settings);

class CornersAhead {
 public:
  // `layers` above each layer; none: every layer is passed on at once.
  explicit CornersAhead(int layers) : layers_(layers) {}

  // The next slice up, which goes into the window. REQUIRES: indices without gaps.
  void see(LayerIndex index, std::shared_ptr<const CornerIndex> corners);
  // No slice follows.
  void end() { ended_ = true; }

  // A layer that has left the window.
  void push(SplitLayer layer) { waiting_.push_back(std::move(layer)); }
  // The next layer whose slices above are known. COSTS: holds at most `layers` + 1 layers, and the
  // corners of the window's slices.
  [[nodiscard]] std::optional<SplitLayer> next();

 private:
  int layers_;
  bool ended_ = false;
  LayerIndex first_ = 0;                                 // of seen_
  std::deque<std::shared_ptr<const CornerIndex>> seen_;  // from the lowest waiting layer on
  std::deque<SplitLayer> waiting_;
};

}  // namespace core
