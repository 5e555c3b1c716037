#include "core/roads/straight_pattern.h"

#include <cmath>
#include <numbers>

#include "core/roads/row_turn.h"  // RowTurn, turned_box

namespace core {
namespace {

// How far rows reach beyond the box.
constexpr double kBeyond = 10'000;

void add_rows(const Box& box, double degrees, double distance, double shift, PatternLines& lines) {
  for (const PatternRow& row : rows_over(box, degrees, distance, shift)) {
    lines.push_back({row.line.from, row.line.to});
  }
}

}  // namespace

std::vector<PatternRow> rows_over(const Box& box, double degrees, double distance, double shift) {
  std::vector<PatternRow> rows;
  const RowTurn turn(degrees);
  const auto [low, high, bottom, top] = turned_box(box, turn);
  const auto first = static_cast<std::int64_t>(std::ceil((bottom - shift) / distance - 0.5));
  const auto last = static_cast<std::int64_t>(std::floor((top - shift) / distance - 0.5));
  for (std::int64_t row = first; row <= last; ++row) {
    const double across = (static_cast<double>(row) + 0.5) * distance + shift;
    rows.push_back(
        {row, {turn.to_plane(low - kBeyond, across), turn.to_plane(high + kBeyond, across)}});
  }
  return rows;
}

PatternLines StraightPattern::lines(const PatternPlace& place) const {
  PatternLines lines;
  const double angle = place.angle_degrees;
  switch (kind_) {
    case Kind::kLines:
      add_rows(place.box, angle + (place.layer % 2 == 0 ? 0 : 90), place.distance, 0, lines);
      break;
    case Kind::kGrid:
      for (const double turned : {0, 90}) {
        add_rows(place.box, angle + turned, 2 * place.distance, 0, lines);
      }
      break;
    case Kind::kTriangles:
      for (const double turned : {0, 60, 120}) {
        add_rows(place.box, angle + turned, 3 * place.distance, 0, lines);
      }
      break;
    case Kind::kCubic: {
      // A plane that rises at 35.3° from the vertical moves by 1/√2 of the height.
      const double shift = static_cast<double>(place.middle.units()) / std::numbers::sqrt2;
      for (const double turned : {0, 120, 240}) {
        add_rows(place.box, angle + turned, 3 * place.distance,
                 std::fmod(shift, 3 * place.distance), lines);
      }
      break;
    }
  }
  return lines;
}

}  // namespace core
