#include "host/part/plane_check.h"

#include "host/system/stop_signals.h"  // stop_signal_count

namespace host {

core::Result<OpenPlanes> check_planes(core::PlaneSweep& sweep) {
  OpenPlanes open;
  for (core::LayerIndex layer = 0;; ++layer) {
    if (stop_signal_count() > 0) {
      return core::Error{core::ErrorCode::kUnreadable, "stopped while checking the part"};
    }
    const auto defects = sweep.next_defects();
    if (!defects.ok()) return defects.error();
    if (!defects.value()) return open;
    if (defects.value()->dropped_chains == 0) continue;
    if (open.layers++ == 0) open.first = layer;
  }
}

}  // namespace host
