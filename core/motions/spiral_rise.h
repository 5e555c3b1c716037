// How the nozzle rises along a turn of a spiral vase, and with how much material.
//
//     height above the turn's bottom, and the gap under the nozzle, along the way once round:
//
//     h ┤         ╱         h ┤─────────
//     0 ┤────────╱          0 ┤
//
// A turn on one of the same height has a gap that is one layer high all along. On a turn of
// another height b the gap goes from b to h. Under the first turn is a flat layer, so that its gap
// grows from 0 to h. After the last one comes a round at the top, over a gap that sinks from h to
// 0.
#pragma once

#include <vector>

#include "core/roads/road.h"  // SpiralTurn
#include "core/units.h"       // Length

namespace core {

// A straight piece of a turn is cut where its gap would change by more than this share of h.
inline constexpr double kSpiralGapStep = 1.0 / 32;

class SpiralRise {
 public:
  // REQUIRES: length_mm > 0, of the way once round.
  SpiralRise(SpiralTurn turn, Length bottom, Length height, double length_mm)
      : turn_(turn), bottom_(bottom), height_(height), length_mm_(length_mm) {}

  // A part of a straight piece.
  struct Step {
    double share = 0;  // of the piece, up to where it ends
    double flow = 1;   // share of a whole layer's
    Length z;          // where it ends
  };

  // The parts of the next piece of the way. ENSURES: the last one's share is 1.
  [[nodiscard]] std::vector<Step> advance(double length_mm);

  // The round at the top begins. REQUIRES: it was once round, and the turn is the last.
  void begin_top_round();

 private:
  [[nodiscard]] double flow(double share) const;

  SpiralTurn turn_;
  Length bottom_, height_;
  double length_mm_;
  double done_mm_ = 0;
  bool at_top_ = false;
};

}  // namespace core
