// A window of layers that are split already, for pictures that show why a spot is wall. A layer is
// handed on when all layers that decide its wall are known.
//
//     push(n) ──▶ │ n−2T … │ n−T │ … n │ ──▶ next(): layer() is n−T, neighbours() all around it
//
// wall_reach.h says which layers those are, and how deep the wall reaches into each.
#pragma once

#include <cstddef>
#include <vector>

#include "core/ring_buffer.h"        // RingBuffer
#include "core/settings.h"           // Settings
#include "core/slices/slice.h"       // Slice
#include "core/units.h"              // Length
#include "core/walls/split_layer.h"  // SplitLayer
#include "core/walls/wall_reach.h"   // WallReach

namespace core {

class LayerWindow {
 public:
  struct Neighbour {
    const SplitLayer* layer = nullptr;
    Length depth;  // how deep below this one's contours the wall reaches
  };

  // REQUIRES: settings validated.
  explicit LayerWindow(const Settings& settings);

  // REQUIRES: the layer lies on the last one; next() has returned false since the last push.
  // COSTS: holds at most kWindowLayersMax layers.
  void push(SplitLayer layer);
  // No layer follows.
  void finish() { finished_ = true; }

  // Goes to the next layer all of whose neighbours are known; false: there is none yet.
  [[nodiscard]] bool next();

  // REQUIRES of all that follow: next() returned true.
  [[nodiscard]] const SplitLayer& layer() const { return layers_[current_]; }
  // layer() itself first, then from the nearest outwards.
  [[nodiscard]] std::vector<Neighbour> neighbours() const;
  // The bed or the part's end is that near: what is beyond counts as outside.
  [[nodiscard]] bool reaches_out() const;

  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] std::size_t layers_held() const { return layers_.size(); }

 private:
  [[nodiscard]] bool all_above_known(const Slice& slice) const;

  Settings settings_;
  WallReach reach_;
  RingBuffer<SplitLayer> layers_;
  std::size_t current_ = 0;  // the number in the window of layer()
  std::size_t next_ = 0;     // of the one after it
  bool finished_ = false;
};

}  // namespace core
