// What of the supports reaches the bed, from layer 0 up: V(n) = U(n) ∩ V(n−1), U(n): what the fold
// found (support_fold.h). So they keep off what is below them all the way up, also right under what
// they hold.
#pragma once

#include <optional>

#include "core/supports/support_fold.h"  // SharedRegion, SupportLayer

namespace core {

class BedColumns {
 public:
  // REQUIRES: layers in order, from 0. COSTS: two intersections, none where nothing has changed.
  [[nodiscard]] SupportLayer standing(const SupportLayer& layer);

 private:
  SharedRegion below_;  // null: the bed
  std::optional<SupportLayer> last_, last_standing_;
};

}  // namespace core
