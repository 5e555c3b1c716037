#include "core/roads/gyroid_pattern.h"

#include <cmath>
#include <numbers>

#include "core/roads/row_turn.h"  // RowTurn, TurnedBox
#include "core/trigonometry.h"    // arc_cosine, arc_tangent, cosine, hypotenuse, sine

namespace core {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// A cell's side for a distance of 1: layers of a cell have this much length on its area, in the
// mean over all heights.
constexpr double kCell = 2.44;

// Where the sheet is at a height: across is φ ± arccos, for each way along.
class Sheet {
 public:
  explicit Sheet(double z) : sine_(sine(z)), cosine_(cosine(z)) {}

  // Whether lines run along x.
  [[nodiscard]] bool along_x() const { return std::abs(cosine_) >= std::abs(sine_); }

  [[nodiscard]] double across(double along, double side) const {
    const double s = sine(along), c = cosine(along);
    // A cos + B sin = −C of what is solved for.
    const double a = along_x() ? s : sine_;
    const double b = along_x() ? cosine_ : c;
    const double rest = along_x() ? sine_ * c : cosine_ * s;
    const double r = hypotenuse(a, b);
    return angle(a, b) + side * arc_cosine(-rest / r);
  }

 private:
  // Of (a, b): b keeps its sign along x, else a does. So that the angle never jumps.
  [[nodiscard]] double angle(double a, double b) const {
    if (along_x() || a > 0) return arc_tangent(b, a);
    return std::numbers::pi - arc_tangent(b, -a);
  }

  double sine_, cosine_;
};

// The remainder, so that angles stay small.
double phase(double units, double cell) { return std::fmod(units, cell) / cell * kTurn; }

}  // namespace

PatternLines GyroidPattern::lines(const PatternPlace& place) const {
  const double cell = kCell * place.distance;
  const Sheet sheet(phase(static_cast<double>(place.middle.units()), cell));
  const RowTurn turn(place.angle_degrees);
  const TurnedBox box = turned_box(place.box, turn);
  const bool along_x = sheet.along_x();
  const double low = along_x ? box.low : box.bottom, high = along_x ? box.high : box.top;
  const double bottom = along_x ? box.bottom : box.low, top = along_x ? box.top : box.high;
  const auto begin = static_cast<std::int64_t>(std::floor(low / cell * kStepsPerCell)) - 1;
  const auto end = static_cast<std::int64_t>(std::ceil(high / cell * kStepsPerCell)) + 1;
  // A wave strays from its cell by one at most.
  const auto first = static_cast<std::int64_t>(std::floor(bottom / cell)) - 2;
  const auto last = static_cast<std::int64_t>(std::ceil(top / cell)) + 1;
  PatternLines lines;
  for (std::int64_t number = first; number <= last; ++number) {
    for (const double side : {-1.0, 1.0}) {
      std::vector<Point>& line = lines.emplace_back();
      for (std::int64_t i = begin; i <= end; ++i) {
        const double along = static_cast<double>(i) / kStepsPerCell;
        const double angle = (along - std::floor(along)) * kTurn;
        const double across = static_cast<double>(number) + sheet.across(angle, side) / kTurn;
        const double x = (along_x ? along : across) * cell, y = (along_x ? across : along) * cell;
        line.push_back(turn.to_plane(x, y));
      }
    }
  }
  return lines;
}

}  // namespace core
