#include "core/motions/motion_clock.h"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "core/motions/motion.h"

namespace {

using core::Extrude;
using core::ExtrudeArc;
using core::Length;
using core::Lift;
using core::MotionModel;
using core::MoveFilament;
using core::Point;
using core::Travel;

constexpr MotionModel kModel{.acceleration_mm_s2 = 1'000,
                             .filament_acceleration_mm_s2 = 2'000,
                             .junction_deviation_mm = 0.013};

Point at_mm(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x * core::kUnitsPerMm)),
          static_cast<std::int32_t>(std::lround(y * core::kUnitsPerMm))};
}

// The clock, told in motions.
class MotionClock {
 public:
  explicit MotionClock(const MotionModel& model) : clock_(model) {}

  void add(const Travel& m) { move(m.to, 0, m.speed_mm_s); }
  void add(const Extrude& m) { move(m.to, m.filament_mm, m.speed_mm_s); }
  void add(const Lift& m) {
    at_.z_mm = m.to.mm();
    push(0, m.speed_mm_s);
  }
  void add(const MoveFilament& m) { push(m.filament_mm, m.speed_mm_s); }
  void add(const ExtrudeArc& m) {
    at_.arc = {m.centre.x / core::kUnitsPerMm, m.centre.y / core::kUnitsPerMm, m.clockwise,
               m.length_mm};
    move(m.to, m.filament_mm, m.speed_mm_s);
    at_.arc.reset();
  }
  void add(const core::SetAcceleration& m) {
    MotionModel model = clock_.model();
    model.acceleration_mm_s2 = m.mm_s2;
    clock_.set_model(model);
  }
  void rest(double seconds) { clock_.rest(seconds); }
  [[nodiscard]] double seconds() const { return clock_.seconds(); }

 private:
  void move(Point to, double filament_mm, double speed_mm_s) {
    at_.x_mm = to.x / core::kUnitsPerMm;
    at_.y_mm = to.y / core::kUnitsPerMm;
    push(filament_mm, speed_mm_s);
  }
  void push(double filament_mm, double speed_mm_s) {
    at_.filament_mm = filament_mm;
    at_.speed_mm_s = speed_mm_s;
    clock_.add(at_);
  }

  core::MotionClock clock_;
  core::MotionClock::Move at_;
};

// Time over a path sampled at `steps` places: at each, the fastest speed allowed by the wanted
// speed, by the corners, and by what can be reached from and to every other place.
double sampled_seconds(const std::vector<double>& bound_at_mm, double step_mm, double a) {
  std::vector<double> v = bound_at_mm;
  for (std::size_t i = 1; i < v.size(); ++i) {
    v[i] = std::min(v[i], std::sqrt(v[i - 1] * v[i - 1] + 2 * a * step_mm));
  }
  for (std::size_t i = v.size() - 1; i-- > 0;) {
    v[i] = std::min(v[i], std::sqrt(v[i + 1] * v[i + 1] + 2 * a * step_mm));
  }
  double seconds = 0;
  for (std::size_t i = 1; i < v.size(); ++i) seconds += 2 * step_mm / (v[i - 1] + v[i]);
  return seconds;
}

TEST_CASE("one long move is a trapezoid") {
  MotionClock clock(kModel);
  clock.add(Travel{at_mm(100, 0), 50});
  // 0.05 s up and 0.05 s down over 1.25 mm each, the rest at 50 mm/s.
  CHECK(clock.seconds() == doctest::Approx(0.1 + 97.5 / 50));
}

TEST_CASE("a move has the acceleration that was told last") {
  MotionClock clock(kModel);
  clock.add(core::SetAcceleration{250});
  clock.add(Travel{at_mm(1, 0), 50});
  const double slow_s = 2 * std::sqrt(1.0 / 250);
  CHECK(clock.seconds() == doctest::Approx(slow_s));
  clock.add(core::SetAcceleration{4'000});
  clock.add(MoveFilament{-1, 40});  // so that the moves beside it begin and end at rest
  const double both_s = clock.seconds();
  clock.add(Travel{at_mm(2, 0), 100});
  CHECK(clock.seconds() - both_s == doctest::Approx(2 * std::sqrt(1.0 / 4'000)));
}

TEST_CASE("one short move is a triangle") {
  MotionClock clock(kModel);
  clock.add(Travel{at_mm(1, 0), 50});
  CHECK(clock.seconds() == doctest::Approx(2 * std::sqrt(1.0 / 1'000)));
}

TEST_CASE("a straight line in pieces takes as long as in one, within the look-ahead") {
  MotionClock whole(kModel), pieces(kModel);
  whole.add(Travel{at_mm(20, 0), 30});
  for (int i = 1; i <= 10; ++i) pieces.add(Travel{at_mm(2.0 * i, 0), 30});
  CHECK(pieces.seconds() == doctest::Approx(whole.seconds()));
}

TEST_CASE("very short pieces are slowed by the look-ahead's end") {
  MotionClock whole(kModel), pieces(kModel);
  whole.add(Travel{at_mm(20, 0), 100});
  for (int i = 1; i <= 200; ++i) pieces.add(Travel{at_mm(0.1 * i, 0), 100});
  CHECK(pieces.seconds() > whole.seconds());
  // 1.6 mm of look-ahead allow sqrt(2 · 1000 · 1.6) = 56 mm/s.
  CHECK(pieces.seconds() > 20 / 56.6);
}

TEST_CASE("turning back stops the machine, a filament move too") {
  MotionClock there_and_back(kModel), there(kModel);
  there.add(Travel{at_mm(50, 0), 50});
  there_and_back.add(Travel{at_mm(50, 0), 50});
  there_and_back.add(Travel{at_mm(0, 0), 50});
  CHECK(there_and_back.seconds() == doctest::Approx(2 * there.seconds()));

  MotionClock with_retraction(kModel);
  with_retraction.add(Travel{at_mm(50, 0), 50});
  with_retraction.add(MoveFilament{-1, 1'000});
  with_retraction.add(Travel{at_mm(100, 0), 50});
  CHECK(with_retraction.seconds() ==
        doctest::Approx(2 * there.seconds() + 2 * std::sqrt(1.0 / 2'000)));
}

TEST_CASE("lifts count, and so do moves that go nowhere: as nothing") {
  MotionClock clock(kModel);
  clock.add(Lift{Length::from_mm(1), 1'000});
  clock.add(Lift{Length::from_mm(1), 1'000});
  CHECK(clock.seconds() == doctest::Approx(2 * std::sqrt(1.0 / 1'000)));
}

TEST_CASE("random paths within the look-ahead agree with a finely sampled speed profile") {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> turn(-1.5, 1.5), length(1, 10), speed(10, 100);
    MotionClock clock(kModel);
    double x = 0, y = 0, heading = 0, wanted_before = 0;
    const double step = 0.001;
    std::vector<double> bound{0};
    for (int i = 0; i < 10; ++i) {
      const double angle = i == 0 ? 0 : turn(random);
      heading += angle;
      const double wanted = speed(random);
      const double mm = std::round(length(random));
      x += mm * std::cos(heading);
      y += mm * std::sin(heading);
      clock.add(Extrude{at_mm(x, y), 0.1, wanted});
      if (i > 0) {
        // θ/2 between the moves, measured inside the corner.
        const double s = std::sin((M_PI - std::abs(angle)) / 2);
        const double corner = std::sqrt(1'000 * 0.013 * s / (1 - s));
        bound.back() = std::min({bound.back(), corner, wanted_before, wanted});
      }
      wanted_before = wanted;
      const auto steps = static_cast<int>(std::lround(mm / step));
      for (int k = 0; k < steps; ++k) bound.push_back(wanted);
    }
    bound.back() = 0;
    CHECK(clock.seconds() == doctest::Approx(sampled_seconds(bound, step, 1'000)).epsilon(0.01));
  }
}

TEST_CASE("an arc takes as long as its length, no faster than its radius allows") {
  constexpr double kPi = 3.14159265358979323846;
  // Half a turn of radius 40: along the line, through it, and out along the line again.
  MotionClock clock(kModel);
  clock.add(Travel{at_mm(100, 0), 50});
  clock.add(ExtrudeArc{at_mm(100, 80), at_mm(100, 40), false, 40 * kPi, 1, 50});
  clock.add(Travel{at_mm(0, 80), 50});
  CHECK(clock.seconds() == doctest::Approx(0.1 + (197.5 + 40 * kPi) / 50));
  // The same arc the other way round turns back at its begin: a stop.
  MotionClock back(kModel);
  back.add(Travel{at_mm(100, 0), 50});
  back.add(ExtrudeArc{at_mm(100, 80), at_mm(100, 40), true, 40 * kPi, 1, 50});
  CHECK(back.seconds() > 0.19 + (95 + 40 * kPi) / 50);
  // v² = a r: radius 0.4 at 1000 mm/s² is 20 mm/s.
  MotionClock tight(kModel);
  tight.add(Travel{at_mm(0.4, 0), 20});
  for (int i = 0; i < 100; ++i) {
    tight.add(ExtrudeArc{at_mm(-0.4, 0), at_mm(0, 0), false, 0.4 * kPi, 1, 500});
    tight.add(ExtrudeArc{at_mm(0.4, 0), at_mm(0, 0), false, 0.4 * kPi, 1, 500});
  }
  CHECK(tight.seconds() == doctest::Approx(200 * 0.4 * kPi / 20).epsilon(0.05));
}

TEST_CASE("a pause is counted, and the machine rests before it") {
  MotionClock clock(kModel);
  clock.add(Travel{at_mm(50, 0), 50});
  const double half_s = clock.seconds();
  clock.rest(3);
  clock.add(Travel{at_mm(100, 0), 50});
  CHECK(clock.seconds() == doctest::Approx(2 * half_s + 3));
}

TEST_CASE("no axis is faster, or speeds up more, than it may") {
  MotionModel model = kModel;
  model.speed_max_mm_s = {40, 40, 5, 25};
  model.acceleration_max_mm_s2 = {500, 500, 50, 2'500};
  const auto alone_s = [&](const auto& motion) {
    MotionClock clock(model);
    clock.add(motion);
    return clock.seconds();
  };
  CHECK(alone_s(Travel{at_mm(100, 0), 90}) == doctest::Approx(100.0 / 40 + 40.0 / 500));
  // Both axes at once: along the way they make √2 of it.
  const double way = std::sqrt(2.0) * 100, speed = std::sqrt(2.0) * 40, a = std::sqrt(2.0) * 500;
  CHECK(alone_s(Travel{at_mm(100, 100), 90}) == doctest::Approx(way / speed + speed / a));
  CHECK(alone_s(Lift{Length::from_mm(10), 90}) == doctest::Approx(10.0 / 5 + 5.0 / 50));
  // The filament is half as long as the way here: 25 mm/s of it are 50 mm/s, 40 are less.
  CHECK(alone_s(Extrude{at_mm(100, 0), 100, 90}) == doctest::Approx(100.0 / 25 + 25.0 / 500));
  CHECK(alone_s(MoveFilament{-50, 90}) == doctest::Approx(50.0 / 25 + 25.0 / 2'000));
}

TEST_CASE("with jerks, moves start with them, and corners change no axis by more") {
  MotionModel model = kModel;
  model.jerk_mm_s = {8, 8, 0.4, 4};
  MotionClock line(model);
  line.add(Travel{at_mm(100, 0), 50});
  // From 8 mm/s to 50 and back.
  const double ramp_s = (50.0 - 8) / 1'000, ramp_mm = (50.0 * 50 - 64) / 2'000;
  CHECK(line.seconds() == doctest::Approx(2 * ramp_s + (100 - 2 * ramp_mm) / 50));
  // A right angle: x ends with 8, y begins with 8.
  MotionClock corner(model);
  corner.add(Travel{at_mm(100, 0), 50});
  corner.add(Travel{at_mm(100, 100), 50});
  CHECK(corner.seconds() == doctest::Approx(2 * line.seconds()));
  // A slight turn by 0.1 in y: 8 / 0.0995 mm/s would be allowed, so nothing is lost.
  MotionClock slight(model);
  slight.add(Travel{at_mm(100, 0), 50});
  slight.add(Travel{at_mm(200, 10), 50});
  const double whole_mm = 100 + std::sqrt(10'100.0);
  const double last_mm_s = 8 / (100 / std::sqrt(10'100.0));
  const double in_s = (50.0 - 8) / 1'000, in_mm = (50.0 * 50 - 64) / 2'000;
  const double out_s = (50 - last_mm_s) / 1'000;
  const double out_mm = (50.0 * 50 - last_mm_s * last_mm_s) / 2'000;
  CHECK(slight.seconds() == doctest::Approx(in_s + out_s + (whole_mm - in_mm - out_mm) / 50));
}

TEST_CASE("through a right angle a square corner is taken at its speed") {
  MotionModel model = kModel;
  model.square_corner_mm_s = 5;
  MotionClock clock(model);
  clock.add(Travel{at_mm(100, 0), 50});
  clock.add(Travel{at_mm(100, 100), 50});
  // Both: from rest to 50, and from or to 5.
  const double each_s = 50.0 / 1'000 + 45.0 / 1'000;
  const double ramps_mm = 50.0 * 50 / 2'000 + (50.0 * 50 - 25) / 2'000;
  CHECK(clock.seconds() == doctest::Approx(2 * (each_s + (100 - ramps_mm) / 50)));
}

}  // namespace

TEST_CASE("what another clock has counted of a stretch needs not be counted again") {
  MotionModel jerky = kModel;
  jerky.jerk_mm_s = {8, 8, 0.4, 5};
  for (const MotionModel& model : {kModel, jerky}) {
    int skips = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
      CAPTURE(seed);
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> way(-3, 3), speed(10, 100);
      const auto next = [&](core::MotionClock::Move move) {
        move.x_mm += way(random);
        move.y_mm += way(random);
        if (random() % 8 == 0) move.z_mm += 0.2;
        move.filament_mm = random() % 3 == 0 ? 0 : 0.05;
        move.speed_mm_s = speed(random);
        return move;
      };
      core::MotionClock whole(model), fresh(model);
      core::MotionClock::Move at{.x_mm = 1, .y_mm = 2, .z_mm = 0.2, .speed_mm_s = 50};
      for (unsigned i = 0; i < seed; ++i) whole.add(at = next(at));
      fresh.set_place(at.x_mm, at.y_mm, at.z_mm);
      core::MotionClock skipping = whole;
      // Counted together until they go on alike, then by the fresh one alone.
      std::optional<core::MotionClock> from;
      for (int i = 0; i < 200; ++i) {
        at = next(at);
        whole.add(at);
        fresh.add(at);
        if (from) continue;
        skipping.add(at);
        if (skipping.goes_on_as(fresh, false)) from = fresh;
      }
      if (from) {
        ++skips;
        skipping.skip(*from, fresh, false);
      }
      CHECK_EQ(skipping.seconds(), whole.seconds());
      for (int i = 0; i < 20; ++i) {
        at = next(at);
        whole.add(at);
        skipping.add(at);
      }
      CHECK_EQ(skipping.seconds(), whole.seconds());
    }
    CHECK_GT(skips, 50);
  }
}

TEST_CASE("clocks at other places, or of other machines, do not go on alike") {
  const auto moved = [](double x, double z, const MotionModel& model) {
    core::MotionClock clock(model);
    clock.set_place(x, 0, z);
    clock.rest(1);
    return clock;
  };
  const core::MotionClock clock = moved(1, 1, kModel);
  CHECK(clock.goes_on_as(moved(1, 1, kModel), false));
  CHECK_FALSE(clock.goes_on_as(moved(2, 1, kModel), true));
  CHECK_FALSE(clock.goes_on_as(moved(1, 2, kModel), false));
  CHECK(clock.goes_on_as(moved(1, 2, kModel), true));
  MotionModel other = kModel;
  other.acceleration_mm_s2 = 900;
  CHECK_FALSE(clock.goes_on_as(moved(1, 1, other), true));
}
