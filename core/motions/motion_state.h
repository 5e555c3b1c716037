// Where a print stands, as far as its motions depend on it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/geometry.h"    // Point
#include "core/roads/road.h"  // kRoadKindCount
#include "core/units.h"       // Length

namespace core {

// What was asked for since the start of the print.
struct MotionTotals {
  std::array<double, kRoadKindCount> filament_mm{};  // by RoadKind; retractions don't count
  double travel_mm = 0;
  std::int64_t roads = 0;
  std::int64_t arcs = 0;
  std::int64_t travels = 0;
  std::int64_t retractions = 0;
  std::int64_t layers = 0;  // with roads

  MotionTotals& operator+=(const MotionTotals& more) {
    for (std::size_t i = 0; i < kRoadKindCount; ++i) filament_mm[i] += more.filament_mm[i];
    travel_mm += more.travel_mm;
    roads += more.roads;
    arcs += more.arcs;
    travels += more.travels;
    retractions += more.retractions;
    layers += more.layers;
    return *this;
  }
};

// Where a print stands between two layers: all that the next layer's motions depend on besides its
// roads.
struct MotionState {
  bool preheated = false;
  bool started = false;
  bool retracted = false;
  bool position_known = false;
  Point position;                  // where the nozzle is, once known
  std::optional<Length> nozzle_z;  // likewise
  double fan = 0;
  double nozzle_celsius = 0;
  double bed_celsius = 0;
  double acceleration_mm_s2 = 0;  // as last told; 0: never told
  std::optional<bool> arcs;       // whether round roads become arcs; nothing: not decided
  std::int64_t actions = 0;       // carried out, of those at heights (height_actions.h)
  Length highest;                 // top of the highest layer that has roads
};

}  // namespace core
