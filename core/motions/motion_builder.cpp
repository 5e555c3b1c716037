#include "core/motions/motion_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/check.h"                    // RIND_CHECK
#include "core/motions/height_slowdown.h"  // height_share
#include "core/motions/park_height.h"      // park_height
#include "core/motions/road_accelerations.h"
#include "core/motions/road_speeds.h"  // flow_factor
#include "core/motions/wipe_way.h"     // wipe_plan
#include "core/regions/polyline.h"     // distance_mm, length_mm

namespace core {

namespace {

// How far the nozzle passes above finished objects, at least.
constexpr Length kObjectClearance = Length::from_units(10'000);

// A nozzle that oozes over a finished top leaves a trace.
bool is_top(RoadKind kind) { return kind == RoadKind::kTopSolid || kind == RoadKind::kIroning; }

bool is_outside(RoadKind kind) { return kind == RoadKind::kSkirt || kind == RoadKind::kBrim; }

double length_mm(const std::vector<LaidStretch>& stretches) {
  double sum = 0;
  for (const LaidStretch& each : stretches) sum += length_mm(each.way.points, each.way.closed);
  return sum;
}

}  // namespace

MotionBuilder::MotionBuilder(const Settings& settings)
    : settings_(settings),
      actions_(settings),
      laying_(settings),
      pressure_advance_s_(settings.pressure_advance_s) {
  if (settings.arcs != ArcUse::kAuto) state_.arcs = settings.arcs == ArcUse::kOn;
}

void MotionBuilder::decide_arcs(bool drawn) {
  RIND_CHECK(!state_.arcs && !state_.started);
  state_.arcs = drawn;
}

void MotionBuilder::resume_from(const MotionState& state) {
  RIND_CHECK(!state_.preheated && !state_.started);
  state_ = state;
  actions_.apply(static_cast<std::size_t>(state_.actions), settings_);
}

void MotionBuilder::start_layer(const Slice& slice, const Sink& sink) {
  index_ = slice.index;
  top_ = slice.top();
  height_ = slice.height;
  speed_share_ = height_share(settings_, top_, settings_.height_slowdown_speed);
  state_.highest = std::max(state_.highest, top_);
  ++totals_.layers;
  sink(LayerStart{index_, top_, height_});
}

void MotionBuilder::start_object(int object, const Sink& sink) {
  if (object == object_) return;
  if (object_ != kNoObject) sink(ObjectEnd{object_});
  if (object != kNoObject) sink(ObjectStart{object});
  object_ = object;
}

void MotionBuilder::set_fan(double share, const Sink& sink) {
  if (share != state_.fan) sink(SetFan{share});
  state_.fan = share;
}

void MotionBuilder::set_acceleration(double mm_s2, const Sink& sink) {
  if (mm_s2 == 0 || mm_s2 == state_.acceleration_mm_s2) return;
  sink(SetAcceleration{mm_s2});
  state_.acceleration_mm_s2 = mm_s2;
}

void MotionBuilder::set_up_layer(double fan_share, const Sink& sink) {
  set_fan(fan_share, sink);
  const double celsius =
      index_ == 0 ? settings_.nozzle_first_layer_celsius : settings_.nozzle_celsius;
  if (celsius != state_.nozzle_celsius) sink(SetNozzleTemperature{celsius, false});
  state_.nozzle_celsius = celsius;
  const double bed = index_ == 0 ? bed_first_layer_celsius(settings_) : settings_.bed_celsius;
  if (bed != state_.bed_celsius) sink(SetBedTemperature{bed, false});
  state_.bed_celsius = bed;
}

LayerPace MotionBuilder::pace_of(const Slice& slice) const {
  const auto done = static_cast<std::size_t>(state_.actions);
  const std::size_t due = actions_.due(done, slice.bottom).size();
  return laying_.pace(slice, done + due, state_.arcs.value_or(false));
}

void MotionBuilder::layer(const Slice& slice, const std::vector<Road>& roads, const Sink& sink,
                          const TravelSpace* space) {
  if (roads.empty()) return;
  begin_layer(slice, sink);
  const auto from = state_.position_known ? std::optional(state_.position) : std::nullopt;
  lay(slice, laying_.lay(slice, roads, pace_of(slice), from), sink, space);
}

void MotionBuilder::prepared_layer(const Slice& slice, const LaidLayer& laid, const Sink& sink,
                                   const TravelSpace* space) {
  RIND_CHECK(suits(laid, slice));
  begin_layer(slice, sink);
  lay(slice, laid, sink, space);
}

void MotionBuilder::begin_layer(const Slice& slice, const Sink& sink) {
  RIND_CHECK(!ended_);
  if (!state_.started) preamble(sink);
  start_layer(slice, sink);
  act(slice.bottom, sink);
}

void MotionBuilder::lay(const Slice& slice, const LaidLayer& laid, const Sink& sink,
                        const TravelSpace* space) {
  set_up_layer(laid.fan_share, sink);
  SliceBoundary boundary(slice.region);
  space_ = space;
  laid_ = &laid;
  for (const LaidRoad& each : laid.roads) {
    level_ = each.spiral ? slice.bottom : top_;
    start_object(each.object, sink);
    if (!joins_turn(each)) {
      travel(each.stretches.front().way.points.front(), each.kind, boundary, sink);
    }
    road(each, sink);
    last_ = &each;
  }
  // The next layer does not know this road.
  const std::optional<SpiralTurn>& turn = laid.roads.back().spiral;
  const bool turns_on = turn && !turn->last;
  if (settings_.wipe && !turns_on) retract(sink);
  start_object(kNoObject, sink);
  last_ = nullptr;
  space_ = nullptr;
  laid_ = nullptr;
}

// Whether the road is a turn that the nozzle goes on to from the turn below, as it lays.
bool MotionBuilder::joins_turn(const LaidRoad& road) const {
  if (!road.spiral || road.spiral->first() || !state_.position_known || state_.retracted)
    return false;
  const WidthStretch& start = road.stretches.front().way;
  return distance_mm(state_.position, start.points.front()) <= 2 * start.width.mm();
}

void MotionBuilder::road(const LaidRoad& road, const Sink& sink) {
  ++totals_.roads;
  bool first = true;
  if (road.spiral) rise_.emplace(*road.spiral, level_, height_, length_mm(road.stretches));
  const int rounds = road.spiral && road.spiral->last ? 2 : 1;
  for (int round = 0; round < rounds; ++round) {
    if (round == 1) rise_->begin_top_round();
    for (const LaidStretch& stretch : road.stretches) {
      const WidthStretch& way = stretch.way;
      set_fan(stretch.fan_share, sink);
      set_acceleration(road_acceleration_mm_s2(settings_, index_, top_, way.kind), sink);
      if (first) {
        sink(RoadStart{way.kind, way.width, road.layers});
      } else {
        sink(RoadChange{way.kind, way.width});
      }
      if (first && rise_) join_turn(way, stretch.speed_mm_s, sink);
      first = false;
      lay(stretch, sink);
    }
  }
  rise_.reset();
}

// From the end of the turn below, at its height.
void MotionBuilder::join_turn(const WidthStretch& stretch, double speed, const Sink& sink) {
  const Point start = stretch.points.front();
  if (state_.position == start) return;
  const double filament = distance_mm(state_.position, start) * filament_per_mm(stretch);
  totals_.filament_mm[static_cast<std::size_t>(stretch.kind)] += filament;
  sink(Extrude{start, filament, speed});
  state_.position = start;
}

double MotionBuilder::filament_per_mm(const WidthStretch& stretch) const {
  const double d = settings_.filament_diameter.mm();
  return flow_factor(settings_, index_) * stretch.area_mm2 / (std::numbers::pi * d * d / 4);
}

void MotionBuilder::lay(const LaidStretch& stretch, const Sink& sink) {
  const double per_mm = filament_per_mm(stretch.way);
  for (const RoadPiece& piece : laid_->pieces_of(stretch)) {
    lay(piece, stretch.way.kind, per_mm, stretch.sent_speed_mm_s, sink);
  }
}

void MotionBuilder::lay(const RoadPiece& piece, RoadKind kind, double filament_per_mm, double speed,
                        const Sink& sink) {
  if (rise_) return lay_rising(piece, kind, filament_per_mm, speed, sink);
  const double filament = piece.laid_over_mm * filament_per_mm;
  totals_.filament_mm[static_cast<std::size_t>(kind)] += filament;
  if (piece.is_arc) {
    ++totals_.arcs;
    sink(ExtrudeArc{piece.to, piece.centre, piece.clockwise, piece.length_mm, filament, speed});
  } else {
    sink(Extrude{piece.to, filament, speed});
  }
  state_.position = piece.to;
}

void MotionBuilder::lay_rising(const RoadPiece& piece, RoadKind kind, double filament_per_mm,
                               double speed, const Sink& sink) {
  const Point from = state_.position;
  double before = 0;
  for (const SpiralRise::Step& step : rise_->advance(piece.laid_over_mm)) {
    const double mm = piece.laid_over_mm * (step.share - before);
    const double filament = mm * filament_per_mm * step.flow;
    totals_.filament_mm[static_cast<std::size_t>(kind)] += filament;
    state_.position = between(from, piece.to, step.share);
    state_.nozzle_z = step.z;
    sink(Extrude{state_.position, filament, speed, step.z});
    before = step.share;
  }
}

// Not where the way is inside the part and short, or, if so set, as long as may be.
bool MotionBuilder::needs_retraction(const std::vector<Point>& way, RoadKind kind,
                                     SliceBoundary& boundary) const {
  const bool after_top = last_ != nullptr && is_top(last_->kind);
  const bool any_length =
      settings_.only_retract_when_crossing_perimeters && !after_top && !is_outside(kind);
  if (!any_length && length_mm(way, false) > settings_.retraction_travel_min.mm()) return true;
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (boundary.crossed_by({way[i - 1], way[i]})) return true;
  }
  return false;
}

std::vector<Point> MotionBuilder::way_to(Point to) const {
  if (!state_.position_known) return {to, to};
  if (space_ != nullptr) return space_->way(state_.position, to);
  return {state_.position, to};
}

// Whether the nozzle was lifted over finished objects, and has not gone down since.
bool MotionBuilder::is_over_objects() const {
  return state_.position_known && state_.highest > top_ &&
         state_.nozzle_z.value_or(Length()) > state_.highest;
}

void MotionBuilder::leave_object(const Sink& sink) {
  if (!state_.position_known) return;
  retract(sink);
  lift(std::max(park_height(state_.highest, settings_), state_.highest + kObjectClearance), sink);
}

void MotionBuilder::travel(Point to, RoadKind kind, SliceBoundary& boundary, const Sink& sink) {
  if (state_.position_known && state_.position == to) {
    lift(level_, sink);
    unretract(sink);
    return;
  }
  const bool over = is_over_objects();
  std::vector<Point> way = over ? std::vector{state_.position, to} : way_to(to);
  if (!state_.position_known || over || needs_retraction(way, kind, boundary)) {
    retract(sink);
    const Length lifted = level_ + settings_.retraction_lift;
    if (state_.nozzle_z.value_or(Length()) < lifted) lift(lifted, sink);
    // A wipe has moved the nozzle.
    if (state_.position != way.front()) way = way_to(to);
  } else {
    lift(level_, sink);
  }
  set_acceleration(travel_acceleration_mm_s2(settings_, top_), sink);
  for (std::size_t i = 1; i < way.size(); ++i) {
    sink(Travel{way[i], speed_share_ * settings_.travel_speed_mm_s});
  }
  ++totals_.travels;
  totals_.travel_mm += length_mm(way, false);
  state_.position = to;
  state_.position_known = true;
  lift(level_, sink);
  unretract(sink);
}

void MotionBuilder::lift(Length to, const Sink& sink) {
  if (state_.nozzle_z == to) return;
  sink(Lift{to, settings_.lift_speed_mm_s});
  state_.nozzle_z = to;
}

void MotionBuilder::retract(const Sink& sink) {
  if (state_.retracted || settings_.retraction_mm <= 0) return;
  ++totals_.retractions;
  state_.retracted = true;
  if (settings_.wipe && last_ != nullptr) return wipe(sink);
  sink(MoveFilament{-settings_.retraction_mm, settings_.retraction_speed_mm_s});
}

void MotionBuilder::wipe(const Sink& sink) {
  std::vector<Point> points;
  for (const LaidStretch& stretch : last_->stretches) {
    const std::vector<Point>& way = stretch.way.points;
    points.insert(points.end(), way.begin(), way.end());
  }
  if (last_->stretches.back().way.closed) points.push_back(points.front());
  const WipePlan plan = wipe_plan(points, last_->loop, settings_);
  if (plan.before_mm > 0) {
    sink(MoveFilament{-plan.before_mm, settings_.retraction_speed_mm_s});
  }
  for (std::size_t i = 1; i < plan.way.size(); ++i) {
    const double mm = distance_mm(plan.way[i - 1], plan.way[i]);
    sink(Wipe{plan.way[i], -plan.filament_per_mm * mm, plan.speed_mm_s});
    state_.position = plan.way[i];
  }
}

void MotionBuilder::unretract(const Sink& sink) {
  if (!state_.retracted) return;
  sink(MoveFilament{settings_.retraction_mm, settings_.retraction_speed_mm_s});
  state_.retracted = false;
}

}  // namespace core
