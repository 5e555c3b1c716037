// Plug point: how an area is filled with roads. A pattern is a file (line_fill.h).
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road, RoadKind
#include "core/units.h"           // LayerIndex, Length

namespace core {

// What is to be filled, and with what.
struct FillArea {
  const Region& region;  // to be filled
  const Region& within;  // where centre lines may go when they are drawn on by `anchor`
  LayerIndex layer = 0;
  RoadKind kind = RoadKind::kSolid;
  Length width;     // of the roads
  Length distance;  // of neighbouring centre lines
  Length inset;     // how deep inside the region centre lines begin
  Length anchor;    // how far they go on from there, beyond the region too but inside `within`
};

class FillPattern {
 public:
  virtual ~FillPattern() = default;

  // ENSURES: every road has two points or more and stays inside the region, or inside `within`
  // where it is anchored.
  [[nodiscard]] virtual std::vector<Road> fill(const FillArea& area) const = 0;
};

}  // namespace core
