#include "core/offsets/arc_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/rounded.h"       // rounded
#include "core/trigonometry.h"  // arc_tangent, arc_cosine, cosine, sine

namespace core {
namespace {

// How far rounded points may be from the line that they lie on. Units.
constexpr double kOffLineMax = 3;

// No arc about a corner exceeds half a turn: a longer one has ends so near that rounding turned
// them round.
constexpr double kSweepMax = 1.5 * M_PI;

double along(const Arc& arc) { return dot(arc.from, arc.to); }
double across(const Arc& arc) { return arc.side * cross(arc.from, arc.to); }

// 0 … 2π.
double sweep_of(const Arc& arc) {
  const double turn = arc_tangent(across(arc), along(arc));
  return turn < 0 ? turn + 2 * M_PI : turn;
}

// Whether it turns by at most twice the angle with this cosine: told without the angle.
bool turns_at_most_twice(double half_cosine, const Arc& arc, double squared) {
  return across(arc) >= 0 && along(arc) >= (2 * half_cosine * half_cosine - 1) * squared;
}

// How many steps, each of this cosine at least, make an angle up to half a turn of this cosine:
// cos((n + 1) a) = 2 cos(a) cos(n a) − cos((n − 1) a). REQUIRES: −1 <= step, step < 1.
int steps_to(double cosine, double step) {
  double before = 1, here = step;
  int count = 1;
  while (cosine < here) {
    ++count;
    if (here <= -step) break;  // less than a step is left of half a turn
    const double next = 2 * step * here - before;
    before = here;
    here = next;
  }
  return count;
}

double growth_of(const Arc& arc) {
  return std::sqrt(dot(arc.to, arc.to) / std::max(dot(arc.from, arc.from), 1.0)) - 1;
}

bool is_on_line(Point p, Point a, Point b) {
  const Vector way = to_vector(b) - to_vector(a);
  const double off = cross(way, to_vector(p) - to_vector(a));
  return off * off <= kOffLineMax * kOffLineMax * dot(way, way);
}

// Turns a point about the arc's centre, by one angle each time.
class Turning {
 public:
  Turning(const Arc& arc, double angle) : Turning(arc, cosine(angle), sine(angle)) {}
  // By half of an angle up to half a turn, which is told by its cosine.
  static Turning half(const Arc& arc, double cosine) {
    return {arc, std::sqrt((1 + cosine) / 2), std::sqrt((1 - cosine) / 2)};
  }

  [[nodiscard]] double cosine_of_angle() const { return cosine_; }
  void turn(Vector& at) const {
    at = {at.x * cosine_ - at.y * sine_, at.x * sine_ + at.y * cosine_};
  }
  [[nodiscard]] Point point(Vector at, double stretch) const {
    return rounded(centre_ + at * stretch);
  }

 private:
  Turning(const Arc& arc, double cosine, double sine)
      : centre_(arc.centre), cosine_(cosine), sine_(arc.side * sine) {}

  Vector centre_;
  double cosine_, sine_;
};

}  // namespace

void ArcPolygon::set_radius(double radius) {
  if (radius == radius_) return;
  radius_ = radius;
  inside_ = std::max(0.0, 1 - tolerance_ / radius);
  outside_ = radius / (radius + tolerance_);
  angles_found_ = false;
}

void ArcPolygon::find_angles() {
  if (angles_found_) return;
  end_angle_ = arc_cosine(outside_);
  half_step_ = arc_cosine(std::max(0.0, (radius_ - tolerance_) / (radius_ + tolerance_)));
  angles_found_ = true;
}

void ArcPolygon::add_chords(const Arc& arc, Ring& ring) {
  set_radius(std::sqrt(std::max({dot(arc.from, arc.from), dot(arc.to, arc.to), 1.0})));
  if (turns_at_most_twice(inside_, arc, radius_ * radius_)) return;
  const double to_end = across(arc);
  if (to_end < 0 && along(arc) >= 0) return;  // rounding turned the ends round
  const double length = std::sqrt(dot(arc.from, arc.from) * dot(arc.to, arc.to));
  // What rounding has made longer than half a turn is one.
  const double cosine = to_end < 0 ? -1 : std::clamp(along(arc) / length, -1.0, 1.0);
  const int chords = steps_to(cosine, 2 * inside_ * inside_ - 1);
  const Turning turning =
      chords == 2 ? Turning::half(arc, cosine) : Turning(arc, sweep_of(arc) / chords);
  const double growth = growth_of(arc);
  Vector at = arc.from;
  for (int i = 1; i < chords; ++i) {
    turning.turn(at);
    ring.push_back(turning.point(at, 1 + growth * i / chords));
  }
}

bool ArcPolygon::add_between(Point before, const Arc& arc, Point after, Ring& ring) {
  const std::size_t size = ring.size();
  add_outside(arc, ring);
  if (ring.size() > size && is_on_line(rounded(arc.centre + arc.from), before, ring[size]) &&
      is_on_line(rounded(arc.centre + arc.to), ring.back(), after)) {
    return true;
  }
  ring.resize(size);
  return false;
}

void ArcPolygon::add_outside(const Arc& arc, Ring& ring) {
  set_radius(std::sqrt(std::max(dot(arc.from, arc.from), 1.0)));
  const double squared = radius_ * radius_;
  if (turns_at_most_twice(outside_, arc, squared)) {
    const Vector middle = arc.from + arc.to;
    ring.push_back(rounded(arc.centre + middle * (2 * squared / dot(middle, middle))));
    return;
  }
  const double sweep = sweep_of(arc);
  if (sweep > kSweepMax) return;
  find_angles();
  const int steps = std::max(1, static_cast<int>(std::ceil((sweep / 2 - end_angle_) / half_step_)));
  const double share = sweep / 2 / (end_angle_ + steps * half_step_);
  const double growth = growth_of(arc);
  const Turning to_first(arc, end_angle_ * share);
  Vector at = arc.from * (1 / to_first.cosine_of_angle());
  to_first.turn(at);
  const Turning turning(arc, 2 * half_step_ * share);
  for (int i = 0; i <= steps; ++i) {
    if (i > 0) turning.turn(at);
    ring.push_back(turning.point(at, 1 + growth * i / steps));
  }
}

}  // namespace core
