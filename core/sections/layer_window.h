// The window once more, for those who want to see why a spot is wall: layers that are split
// already, each handed on when all that reach into its wall are known.
//
//     push(n) ──▶ │ n−2T … │ n−T │ … n │ ──▶ next(): layer() is n−T, neighbours() all around it
//
// Which neighbours those are, and at what depth each counts, is what the wall's shape says: the
// paper's cylinder T layers at one depth, the ball all nearer than w at depths of their own
// (wall_depths.h). The splitter decides by its own count; what is told here is an independent one.
#pragma once

#include <cstddef>
#include <vector>

#include "core/ring_buffer.h"        // RingBuffer
#include "core/settings.h"           // Settings
#include "core/slices/slice.h"       // Slice
#include "core/units.h"              // Length
#include "core/walls/split_layer.h"  // SplitLayer

namespace core {

class LayerWindow {
 public:
  struct Neighbour {
    const SplitLayer* layer = nullptr;
    Length depth;       // how deep below this one's contours the wall reaches
    Length vertically;  // from the middle of layer() to its near face; 0 for layer() itself
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
  [[nodiscard]] const SplitLayer& layer() const { return layers_[place_]; }
  // layer() itself first, then from the nearest outwards.
  [[nodiscard]] std::vector<Neighbour> neighbours() const;
  // The bed or the part's end is that near: what is beyond counts as outside.
  [[nodiscard]] bool reaches_out() const;

  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] std::size_t layers_held() const { return layers_.size(); }

 private:
  [[nodiscard]] bool within_reach(const Slice& from, const Slice& to) const;
  [[nodiscard]] bool reaches_below(const Slice& slice) const;
  [[nodiscard]] bool all_above_known(const Slice& slice) const;

  Settings settings_;
  bool cylinder_;
  RingBuffer<SplitLayer> layers_;
  std::size_t place_ = 0;  // of layer()
  std::size_t next_ = 0;   // of the one after it
  bool finished_ = false;
};

}  // namespace core
