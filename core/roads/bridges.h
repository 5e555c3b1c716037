// Bridges: straight roads over air, or over the loose inside, from one held side to another.
//
//     slice n      ┌──────────────────────────┐
//                  │      ╔════════════╗      │    ═  in the air: farther than half a road from
//     slice n−1    ├──────╢            ╟──────┤       the slice below, and a road wide at least
//                  │▒▒▒▒▒▒║            ║▒▒▒▒▒▒│       (opened); grown onto what holds it
//
// What is narrower is left to the perimeters, which reach out over the edge below (overhangs.h).
//
// The direction is that of least length held on one side only, and of the shortest spans
// (bridge_direction.h). Where less than half of an area can be held on two sides, it is no bridge.
//
// A road in the air is round: no nozzle presses it flat. Its cross-section is bridge_flow times
// that of a road of road_width, its width the diameter, and neighbours touch. Over loose, roads are
// flat and at the usual distance.
//
// Keywords: bridging angle, bridge infill, internal bridge, bridge over sparse infill.
#pragma once

#include <vector>

#include "core/regions/region.h"          // Region
#include "core/roads/bridge_direction.h"  // DirectionTrials
#include "core/roads/road.h"              // Road
#include "core/settings.h"                // Settings
#include "core/units.h"                   // LayerIndex, Length

namespace core {

// Directions that are tried for an area.
inline constexpr DirectionTrials kBridgeTrials{6, 8};

// The air begins this far beyond the slice below, in widths of a road.
inline constexpr double kBridgeReachWidths = 0.5;

// Rows reach this far onto what holds them, in widths of a road; on a rib as thin as one, less.
inline constexpr double kBridgeAnchorWidths = 1.5;

struct Bridges {
  std::vector<Road> roads;
  Region rest;  // of the wall: to be filled in another way
};

// What is around a layer's wall.
struct BridgeSite {
  const Region& slice;
  const Region& room;         // where centre lines of fill may run
  const Region& below;        // the slice below
  const Region& below_loose;  // of it, the inside
  LayerIndex layer = 0;
  Length height;
  const Region* branches = nullptr;  // of it, what holds over its inside; null: nothing
};

// A piece of the wall over air, and the rows that bridge it.
struct AirBridge {
  BridgeArea area;
  BridgeRows rows;

  // Whether it is bridged: more of its rows' length in the air is held at both ends than not.
  [[nodiscard]] bool holds() const { return rows.laid_spans_mm > rows.cut_spans_mm; }
};

// All pieces that are wide enough for a road, also those that no bridge holds.
// COSTS: as bridges().
[[nodiscard]] std::vector<AirBridge> air_bridges(const BridgeSite& site, const Region& wall,
                                                 const Settings& settings);

// The bridges in the wall that is to be filled.
// COSTS: a walk along both slices where they nearly agree; else an offset of the one below, some
// booleans, and for each area O(points + rows) for each direction that is tried.
[[nodiscard]] Bridges bridges(const BridgeSite& site, Region wall, const Settings& settings);

// Diameter of a road in the air.
[[nodiscard]] Length bridge_width(const Settings& settings, Length height);

}  // namespace core
