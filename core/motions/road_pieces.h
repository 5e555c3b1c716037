// The straight pieces and arcs that a stretch of a road is sent as, and how fast: as few as the
// tolerances allow (arc_fit.h, simplify_pieces.h), and as many as the link can send
// (segment_merger.h).
#pragma once

#include <vector>

#include "core/motions/arc_fit.h"          // ArcFitter, RoadPiece
#include "core/motions/width_stretches.h"  // WidthStretch
#include "core/settings.h"                 // Settings
#include "core/units.h"                    // Length

namespace core {

class RoadPieces {
 public:
  explicit RoadPieces(const Settings& settings)
      : tolerance_(settings.segment_tolerance),
        time_min_s_(settings.segment_time_min_ms / 1'000),
        slowest_mm_s_(settings.slowed_speed_min_mm_s),
        fitter_(settings.arc_fit_tolerance) {}

  // From the stretch's first point, and back to it where closed. `speed_mm_s` becomes less where
  // pieces are sent too slowly for it. Valid until the next call.
  [[nodiscard]] const std::vector<RoadPiece>& of(const WidthStretch& stretch, bool arcs,
                                                 double& speed_mm_s);

 private:
  Length tolerance_;
  double time_min_s_;
  double slowest_mm_s_;
  ArcFitter fitter_;
  ArcFitter segments_{Length()};  // none of them an arc
  std::vector<RoadPiece> pieces_;
};

}  // namespace core
