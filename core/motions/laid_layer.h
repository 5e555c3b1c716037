// How a layer's roads are laid, as far as nothing laid before decides it: in stretches of one
// width, how fast, with how much fan, and in which pieces. So layers are prepared in any thread,
// before their turn, and layers of the same roads and the same pace are prepared once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry.h"                 // Point
#include "core/motions/arc_fit.h"          // RoadPiece
#include "core/motions/height_actions.h"   // HeightActions
#include "core/motions/width_stretches.h"  // WidthStretch
#include "core/roads/road.h"               // Road, RoadKind, SpiralTurn
#include "core/settings.h"                 // Settings
#include "core/slices/slice.h"             // Slice

namespace core {

struct LaidStretch {
  WidthStretch way;
  double speed_mm_s = 0;       // slowed down with its layer
  double sent_speed_mm_s = 0;  // at most; less where its pieces are sent too slowly for it
  double fan_share = 0;
  std::size_t first_piece = 0, end_piece = 0;  // of the layer's
};

// A road, opened at its seam.
struct LaidRoad {
  RoadKind kind = RoadKind::kSolid;
  bool small = false;  // a small perimeter
  int layers = 1;      // Road::layers
  bool loop = false;   // closed, but for the seam's gap
  std::optional<SpiralTurn> spiral;
  int object = kNoObject;
  std::vector<LaidStretch> stretches;
};

// All that decides how roads are laid, besides the roads, the height of their layer, and areas.
struct LayerPace {
  std::size_t actions = 0;  // carried out, of those at heights (height_actions.h)
  bool first = false;       // the part's first layer
  bool above_raft = false;  // likewise, on a raft
  bool arcs = false;        // round roads become arcs
  double speed_share = 1;   // of every speed (height_slowdown.h)
  double fan_growth = 1;    // cooling.h

  bool operator==(const LayerPace&) const = default;
};

struct LaidLayer {
  LayerPace pace;
  double fan_share = 0;  // where its roads begin
  std::vector<LaidRoad> roads;
  std::vector<RoadPiece> pieces;  // of all roads

  [[nodiscard]] std::span<const RoadPiece> pieces_of(const LaidStretch& stretch) const {
    return std::span(pieces).subspan(stretch.first_piece, stretch.end_piece - stretch.first_piece);
  }
};

class LayerLaying {
 public:
  // REQUIRES: settings in their ranges.
  explicit LayerLaying(const Settings& settings);

  // How many actions are due below a layer that starts at `bottom`, of all.
  [[nodiscard]] std::size_t actions_below(Length bottom) const;

  // REQUIRES: there are as many actions.
  [[nodiscard]] LayerPace pace(const Slice& slice, std::size_t actions, bool arcs) const;

  // `from`: where the nozzle is; a spiral's turn begins there. Of the slice, all but the region
  // counts. COSTS: O(n log n) for the roads' points. May be called by several threads at once.
  // REQUIRES: every road has two points or more; pace(slice, …).
  [[nodiscard]] LaidLayer lay(const Slice& slice, const std::vector<Road>& roads,
                              const LayerPace& pace, std::optional<Point> from) const;

  // With the values from heights that the pace counts.
  [[nodiscard]] const Settings& settings_of(const LayerPace& pace) const {
    return settings_.at(pace.actions);
  }

 private:
  HeightActions actions_;
  std::vector<Settings> settings_;  // once so many actions were carried out
};

}  // namespace core
