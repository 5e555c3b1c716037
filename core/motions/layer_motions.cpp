#include "core/motions/layer_motions.h"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "core/motions/road_accelerations.h"
#include "core/motions/road_speeds.h"  // flow_factor
#include "core/regions/polyline.h"     // distance_mm, length_mm

namespace core {
namespace {

// A nozzle that oozes over a finished top leaves a trace.
bool is_top(RoadKind kind) { return kind == RoadKind::kTopSolid || kind == RoadKind::kIroning; }

bool is_outside(RoadKind kind) { return kind == RoadKind::kSkirt || kind == RoadKind::kBrim; }

double length_mm(const std::vector<LaidStretch>& stretches) {
  double sum = 0;
  for (const LaidStretch& each : stretches) sum += length_mm(each.way.points, each.way.closed);
  return sum;
}

}  // namespace

LayerMotions::LayerMotions(const Settings& settings, const LayerPlace& place, const LaidLayer& laid,
                           const TravelSpace* space, MotionState& state, MotionTotals& totals,
                           const MotionSink& sink)
    : settings_(settings),
      place_(place),
      laid_(laid),
      space_(space),
      state_(state),
      totals_(totals),
      sink_(sink),
      nozzle_(settings, state, totals, sink),
      boundary_(place.region),
      object_(kNoObject) {}

void LayerMotions::begin() {
  const LaidRoad& first = laid_.roads.front();
  arrive(first);
  nozzle_.set_fan(first.stretches.front().fan_share);
  nozzle_.set_acceleration(acceleration_of(first.stretches.front()));
}

void LayerMotions::rest() {
  object_ = laid_.roads.front().object;
  for (const LaidRoad& each : laid_.roads) {
    if (last_ != nullptr) arrive(each);
    road(each);
    last_ = &each;
  }
  // The next layer does not know this road.
  const std::optional<SpiralTurn>& turn = laid_.roads.back().spiral;
  const bool turns_on = turn && !turn->last;
  if (settings_.wipe && !turns_on) nozzle_.retract(last_);
  start_object(kNoObject);
}

Length LayerMotions::level_of(const LaidRoad& road) const {
  return road.spiral ? place_.bottom : place_.top();
}

double LayerMotions::acceleration_of(const LaidStretch& stretch) const {
  return road_acceleration_mm_s2(settings_, place_.index, place_.top(), stretch.way.kind);
}

void LayerMotions::arrive(const LaidRoad& road) {
  level_ = level_of(road);
  start_object(road.object);
  if (!joins_turn(road)) travel(road.stretches.front().way.points.front(), road.kind);
}

void LayerMotions::start_object(int object) {
  if (object == object_) return;
  if (object_ != kNoObject) sink_(ObjectEnd{object_});
  if (object != kNoObject) sink_(ObjectStart{object});
  object_ = object;
}

// Whether the road is a turn that the nozzle goes on to from the turn below, as it lays.
bool LayerMotions::joins_turn(const LaidRoad& road) const {
  if (!road.spiral || road.spiral->first() || !state_.position_known || state_.retracted)
    return false;
  const WidthStretch& start = road.stretches.front().way;
  return distance_mm(state_.position, start.points.front()) <= 2 * start.width.mm();
}

void LayerMotions::road(const LaidRoad& road) {
  level_ = level_of(road);
  ++totals_.roads;
  bool first = true;
  if (road.spiral) rise_.emplace(*road.spiral, level_, place_.height, length_mm(road.stretches));
  const int rounds = road.spiral && road.spiral->last ? 2 : 1;
  for (int round = 0; round < rounds; ++round) {
    if (round == 1) rise_->begin_top_round();
    for (const LaidStretch& stretch : road.stretches) {
      const WidthStretch& way = stretch.way;
      nozzle_.set_fan(stretch.fan_share);
      nozzle_.set_acceleration(acceleration_of(stretch));
      if (first) {
        sink_(RoadStart{way.kind, way.width, road.layers});
      } else {
        sink_(RoadChange{way.kind, way.width});
      }
      if (first && rise_) join_turn(way, stretch.speed_mm_s);
      first = false;
      lay(stretch);
    }
  }
  rise_.reset();
}

// From the end of the turn below, at its height.
void LayerMotions::join_turn(const WidthStretch& stretch, double speed) {
  const Point start = stretch.points.front();
  if (state_.position == start) return;
  const double filament = distance_mm(state_.position, start) * filament_per_mm(stretch);
  totals_.filament_mm[static_cast<std::size_t>(stretch.kind)] += filament;
  sink_(Extrude{start, filament, speed});
  state_.position = start;
}

double LayerMotions::filament_per_mm(const WidthStretch& stretch) const {
  const double d = settings_.filament_diameter.mm();
  return flow_factor(settings_, place_.index) * stretch.area_mm2 / (std::numbers::pi * d * d / 4);
}

void LayerMotions::lay(const LaidStretch& stretch) {
  const double per_mm = filament_per_mm(stretch.way);
  for (const RoadPiece& piece : laid_.pieces_of(stretch)) {
    lay(piece, stretch.way.kind, per_mm, stretch.sent_speed_mm_s);
  }
}

void LayerMotions::lay(const RoadPiece& piece, RoadKind kind, double filament_per_mm,
                       double speed) {
  if (rise_) return lay_rising(piece, kind, filament_per_mm, speed);
  const double filament = piece.laid_over_mm * filament_per_mm;
  totals_.filament_mm[static_cast<std::size_t>(kind)] += filament;
  if (piece.is_arc) {
    ++totals_.arcs;
    sink_(ExtrudeArc{piece.to, piece.centre, piece.clockwise, piece.length_mm, filament, speed});
  } else {
    sink_(Extrude{piece.to, filament, speed});
  }
  state_.position = piece.to;
}

void LayerMotions::lay_rising(const RoadPiece& piece, RoadKind kind, double filament_per_mm,
                              double speed) {
  const Point from = state_.position;
  double before = 0;
  for (const SpiralRise::Step& step : rise_->advance(piece.laid_over_mm)) {
    const double mm = piece.laid_over_mm * (step.share - before);
    const double filament = mm * filament_per_mm * step.flow;
    totals_.filament_mm[static_cast<std::size_t>(kind)] += filament;
    state_.position = between(from, piece.to, step.share);
    state_.nozzle_z = step.z;
    sink_(Extrude{state_.position, filament, speed, step.z});
    before = step.share;
  }
}

// Not where the way is inside the part and short, or, if so set, as long as may be.
bool LayerMotions::needs_retraction(const std::vector<Point>& way, RoadKind kind) {
  const bool after_top = last_ != nullptr && is_top(last_->kind);
  const bool any_length =
      settings_.only_retract_when_crossing_perimeters && !after_top && !is_outside(kind);
  if (!any_length && core::length_mm(way, false) > settings_.retraction_travel_min.mm()) {
    return true;
  }
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (boundary_.crossed_by({way[i - 1], way[i]})) return true;
  }
  return false;
}

std::vector<Point> LayerMotions::way_to(Point to) const {
  if (!state_.position_known) return {to, to};
  if (space_ != nullptr) return space_->way(state_.position, to);
  return {state_.position, to};
}

// Whether the nozzle was lifted over finished objects, and has not gone down since.
bool LayerMotions::is_over_objects() const {
  return state_.position_known && state_.highest > place_.top() &&
         state_.nozzle_z.value_or(Length()) > state_.highest;
}

void LayerMotions::travel(Point to, RoadKind kind) {
  if (state_.position_known && state_.position == to) {
    nozzle_.lift(level_);
    nozzle_.unretract();
    return;
  }
  const bool over = is_over_objects();
  std::vector<Point> way = over ? std::vector{state_.position, to} : way_to(to);
  if (!state_.position_known || over || needs_retraction(way, kind)) {
    nozzle_.retract(last_);
    const Length lifted = level_ + settings_.retraction_lift;
    if (state_.nozzle_z.value_or(Length()) < lifted) nozzle_.lift(lifted);
    // A wipe has moved the nozzle.
    if (state_.position != way.front()) way = way_to(to);
  } else {
    nozzle_.lift(level_);
  }
  nozzle_.set_acceleration(travel_acceleration_mm_s2(settings_, place_.top()));
  for (std::size_t i = 1; i < way.size(); ++i) {
    sink_(Travel{way[i], laid_.pace.speed_share * settings_.travel_speed_mm_s});
  }
  ++totals_.travels;
  totals_.travel_mm += core::length_mm(way, false);
  state_.position = to;
  state_.position_known = true;
  nozzle_.lift(level_);
  nozzle_.unretract();
}

}  // namespace core
