// What the machine is to do, in typed lengths; how a controller is told is not known here.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "core/geometry.h"    // Point
#include "core/roads/road.h"  // RoadKind
#include "core/units.h"       // LayerIndex, Length

namespace core {

// Marks the start of a layer; nothing moves.
struct LayerStart {
  LayerIndex index = 0;
  Length top;
  Length height;
};

// Marks the start of a road; nothing moves.
struct RoadStart {
  RoadKind kind = RoadKind::kSolid;
  Length width;
  int layers = 1;  // as thick as so many
};

// The road at hand goes on with another width, or as another kind; nothing moves.
struct RoadChange {
  RoadKind kind = RoadKind::kSolid;
  Length width;
};

// What follows belongs to one of several objects; nothing moves.
struct ObjectStart {
  int object = 0;
};

// What follows belongs to it no more; nothing moves.
struct ObjectEnd {
  int object = 0;
};

// Without material, at constant height.
struct Travel {
  Point to;
  double speed_mm_s = 0;
};

// Straight up or down to a height above the bed.
struct Lift {
  Length to;
  double speed_mm_s = 0;
};

// Lays material in a straight line from where the nozzle is.
struct Extrude {
  Point to;
  double filament_mm = 0;
  double speed_mm_s = 0;
  std::optional<Length> z{};  // rising to this height above the bed; none: at constant height
};

// Lays material along an arc of a circle, at constant height, from where the nozzle is.
struct ExtrudeArc {
  Point to;
  Point centre;
  bool clockwise = false;  // seen from above
  double length_mm = 0;    // of the way
  double filament_mm = 0;
  double speed_mm_s = 0;
};

// Moves the filament alone: negative draws it back, positive returns it or primes.
struct MoveFilament {
  double filament_mm = 0;
  double speed_mm_s = 0;
};

// Back over material just laid, or along it, while filament is drawn back.
struct Wipe {
  Point to;
  double filament_mm = 0;  // negative
  double speed_mm_s = 0;   // of the nozzle
};

struct SetFan {
  double share = 0;  // 0 … 1
};

struct SetNozzleTemperature {
  double celsius = 0;
  bool wait = false;
};

struct SetBedTemperature {
  double celsius = 0;
  bool wait = false;
};

// Of all moves from here on.
struct SetAcceleration {
  double mm_s2 = 0;  // a whole number
};

struct SetPressureAdvance {
  double seconds = 0;
};

// One line of the user's G-code, passed on as it is.
struct Verbatim {
  std::string line;
};

// The print waits for the user, who asked for it at this height.
struct Pause {
  Length height;
};

using Motion =
    std::variant<LayerStart, RoadStart, RoadChange, ObjectStart, ObjectEnd, Travel, Lift, Extrude,
                 ExtrudeArc, MoveFilament, Wipe, SetFan, SetNozzleTemperature, SetBedTemperature,
                 SetAcceleration, SetPressureAdvance, Verbatim, Pause>;

}  // namespace core
