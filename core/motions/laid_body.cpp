#include "core/motions/laid_body.h"

#include <variant>

#include "core/motions/height_slowdown.h"     // height_share
#include "core/motions/road_accelerations.h"  // road_acceleration_mm_s2

namespace core {
namespace {

double acceleration_share(const Settings& settings, const LayerPlace& place) {
  return height_share(settings, place.top(), settings.height_slowdown_acceleration);
}

}  // namespace

MotionState state_at_first_road(const Settings& settings, const LayerPlace& place,
                                const LaidLayer& laid) {
  const LaidStretch& first = laid.roads.front().stretches.front();
  MotionState state;
  state.position_known = true;
  state.position = first.way.points.front();
  state.nozzle_z = place.top();
  state.highest = place.top();
  state.fan = first.fan_share;
  state.acceleration_mm_s2 =
      road_acceleration_mm_s2(settings, place.index, place.top(), first.way.kind);
  return state;
}

std::optional<LaidBody> lay_body(const Settings& settings, const LayerPlace& place,
                                 const LaidLayer& laid, const TravelSpace* space,
                                 const MotionSink& sink) {
  for (const LaidRoad& road : laid.roads) {
    if (road.spiral) return std::nullopt;
  }
  LaidBody body;
  body.before = state_at_first_road(settings, place, laid);
  body.after = body.before;
  body.acceleration_share = acceleration_share(settings, place);
  const MotionSink pass = [&](const Motion& motion) {
    if (std::holds_alternative<Lift>(motion)) body.top = place.top();
    sink(motion);
  };
  LayerMotions(settings, place, laid, space, body.after, body.totals, pass).rest();
  return body;
}

bool fits(const LaidBody& body, const MotionState& now, const LayerPlace& place,
          const Settings& settings) {
  const MotionState& wanted = body.before;
  return now.position_known && now.position == wanted.position && now.nozzle_z == place.top() &&
         now.retracted == wanted.retracted && now.fan == wanted.fan &&
         now.acceleration_mm_s2 == wanted.acceleration_mm_s2 &&
         (!body.top || body.top == place.top()) &&
         body.acceleration_share == acceleration_share(settings, place);
}

void end_body(const LaidBody& body, MotionState& now, MotionTotals& totals) {
  now.position = body.after.position;
  // Without a lift, it is where it was.
  if (body.top) now.nozzle_z = body.after.nozzle_z;
  now.retracted = body.after.retracted;
  now.fan = body.after.fan;
  now.acceleration_mm_s2 = body.after.acceleration_mm_s2;
  totals += body.totals;
}

}  // namespace core
