// rind test first-layer: nine squares of one layer, as far out as the bed allows.
//
//     ┌───────────┐       a square lies on the way from the middle outwards, where it and its skirt
//     │▪    ▪    ▪│       are still on the bed; so they lie on a circle on a round one
//     │▪    ▪    ▪│
//     │▪    ▪    ▪│
//     └───────────┘
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/bed.h"  // Bed
#include "host/calibration/calibration_parts.h"

namespace host {
namespace {

constexpr double kSideMost_mm = 24;
constexpr double kSideLeast_mm = 10;
constexpr double kSidesPerBed = 8;  // about
// Clips and the purge line are there.
constexpr double kEdge_mm = 10;

core::Point at_mm(Place place) {
  return {static_cast<std::int32_t>(std::lround(place.u * core::kUnitsPerMm)),
          static_cast<std::int32_t>(std::lround(place.v * core::kUnitsPerMm))};
}

core::Box square_around(Place middle, double half_mm) {
  return {at_mm({middle.u - half_mm, middle.v - half_mm}),
          at_mm({middle.u + half_mm, middle.v + half_mm})};
}

// The farthest place on the way from the middle of the bed, in steps of a thousandth of it.
Place farthest(const core::Bed& bed, Place middle, Place towards, double half_mm) {
  constexpr int kSteps = 1'000;
  Place best = middle;
  for (int i = 1; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    const Place place{middle.u + share * towards.u, middle.v + share * towards.v};
    if (!bed.holds(square_around(place, half_mm))) break;
    best = place;
  }
  return best;
}

}  // namespace

core::Result<Calibration> first_layer_squares(const PrintSettings& settings) {
  const core::Bed bed(settings);
  const double bed_x = settings.bed_x.mm(), bed_y = settings.bed_y.mm();
  const double side =
      std::clamp(std::min(bed_x, bed_y) / kSidesPerBed, kSideLeast_mm, kSideMost_mm);
  PrintSettings own = settings;
  own.brim_width = core::Length();
  const double half = side / 2 + std::max(kEdge_mm, margin_mm(own));
  const bool first = settings.first_layer_height > core::Length();
  const double height = (first ? settings.first_layer_height : settings.layer_height).mm();
  const Place middle{bed_x / 2, bed_y / 2};
  Calibration calibration;
  for (const double v : {-1, 0, 1}) {
    for (const double u : {-1, 0, 1}) {
      const Place place = farthest(bed, middle, {u * bed_x / 2, v * bed_y / 2}, half);
      const double away = std::hypot(place.u - middle.u, place.v - middle.v);
      if ((u != 0 || v != 0) && away < 1.2 * side) {
        return core::Error{core::ErrorCode::kOutOfBounds,
                           fmt::format("the bed of {:g} x {:g} mm is too small for nine squares of "
                                       "{:.0f} mm and a border of {:.0f} mm",
                                       bed_x, bed_y, side, half - side / 2)};
      }
      calibration.solid.box({place.u - side / 2, place.u + side / 2},
                            {place.v - side / 2, place.v + side / 2}, {0, height});
    }
  }
  calibration.what = fmt::format("nine squares of {:.0f} mm, one layer of {:g} mm", side, height);
  calibration.settings = {
      {"centre", "0"},
      {"part_x", fmt::format("{:.4f}", calibration.solid.extent(0).from)},
      {"part_y", fmt::format("{:.4f}", calibration.solid.extent(1).from)},
      {"brim_width", "0"},
  };
  calibration.advice = {
      "Squares whose roads lie apart, are round, or come off: the nozzle is too high there. "
      "Squares "
      "that are see-through, rough or have ridges at the roads' sides: it is too low.",
      "Some squares are worse than others: level the bed with its screws in that corner, or "
      "measure "
      "its mesh again. All are alike: change the nozzle's height (Z offset) at the printer, by "
      "0.05 "
      "mm at a time. All look right but come off: clean the bed, then bed_first_layer_celsius + 5.",
  };
  return calibration;
}

}  // namespace host
