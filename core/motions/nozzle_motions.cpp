#include "core/motions/nozzle_motions.h"

#include <cstddef>
#include <vector>

#include "core/motions/wipe_way.h"  // wipe_plan
#include "core/regions/polyline.h"  // distance_mm

namespace core {

void NozzleMotions::set_fan(double share) {
  if (share != state_.fan) sink_(SetFan{share});
  state_.fan = share;
}

void NozzleMotions::set_acceleration(double mm_s2) {
  if (mm_s2 == 0 || mm_s2 == state_.acceleration_mm_s2) return;
  sink_(SetAcceleration{mm_s2});
  state_.acceleration_mm_s2 = mm_s2;
}

void NozzleMotions::lift(Length to) {
  if (state_.nozzle_z == to) return;
  sink_(Lift{to, settings_.lift_speed_mm_s});
  state_.nozzle_z = to;
}

void NozzleMotions::retract(const LaidRoad* last) {
  if (state_.retracted || settings_.retraction_mm <= 0) return;
  ++totals_.retractions;
  state_.retracted = true;
  if (settings_.wipe && last != nullptr) return wipe(*last);
  sink_(MoveFilament{-settings_.retraction_mm, settings_.retraction_speed_mm_s});
}

void NozzleMotions::wipe(const LaidRoad& last) {
  std::vector<Point> points;
  for (const LaidStretch& stretch : last.stretches) {
    const std::vector<Point>& way = stretch.way.points;
    points.insert(points.end(), way.begin(), way.end());
  }
  if (last.stretches.back().way.closed) points.push_back(points.front());
  const WipePlan plan = wipe_plan(points, last.loop, settings_);
  if (plan.before_mm > 0) {
    sink_(MoveFilament{-plan.before_mm, settings_.retraction_speed_mm_s});
  }
  for (std::size_t i = 1; i < plan.way.size(); ++i) {
    const double mm = distance_mm(plan.way[i - 1], plan.way[i]);
    sink_(Wipe{plan.way[i], -plan.filament_per_mm * mm, plan.speed_mm_s});
    state_.position = plan.way[i];
  }
}

void NozzleMotions::unretract() {
  if (!state_.retracted) return;
  sink_(MoveFilament{settings_.retraction_mm, settings_.retraction_speed_mm_s});
  state_.retracted = false;
}

}  // namespace core
