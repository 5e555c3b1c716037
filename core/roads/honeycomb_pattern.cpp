#include "core/roads/honeycomb_pattern.h"

#include <cmath>
#include <numbers>

#include "core/roads/row_turn.h"  // RowTurn, TurnedBox

namespace core {
namespace {

// A hexagon's side for a distance of 1: a wave has four sides on an area of 3 · √3/2 squares of it.
constexpr double kSide = 4 / (3 * std::numbers::sqrt3 / 2);

}  // namespace

PatternLines HoneycombPattern::lines(const PatternPlace& place) const {
  const RowTurn turn(place.angle_degrees);
  const TurnedBox box = turned_box(place.box, turn);
  const double side = kSide * place.distance, wave = side * std::numbers::sqrt3 / 2;
  const double apart = place.width / 2;
  const double period = 3 * side;
  const auto first = static_cast<std::int64_t>(std::floor(box.bottom / wave)) - 1;
  const auto last = static_cast<std::int64_t>(std::ceil(box.top / wave));
  const auto begin = static_cast<std::int64_t>(std::floor(box.low / period)) - 1;
  const auto end = static_cast<std::int64_t>(std::ceil(box.high / period)) + 1;
  PatternLines lines;
  for (std::int64_t number = first; number <= last; ++number) {
    const double base = static_cast<double>(number) * wave;
    // Neighbours are each other's mirror images.
    const bool up = number % 2 == 0;
    const double low = base + (up ? apart : wave - apart),
                 high = base + (up ? wave - apart : apart);
    std::vector<Point>& line = lines.emplace_back();
    for (std::int64_t i = begin; i <= end; ++i) {
      const double x = static_cast<double>(i) * period;
      line.push_back(turn.to_plane(x, low));
      line.push_back(turn.to_plane(x + side, low));
      line.push_back(turn.to_plane(x + 1.5 * side, high));
      line.push_back(turn.to_plane(x + 2.5 * side, high));
    }
  }
  return lines;
}

}  // namespace core
