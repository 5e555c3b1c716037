// Honeycomb: hexagons in every layer, upright walls of cells.
//
//     ▁▁╱▔▔╲▁▁╱▔▔╲▁▁    Each wave is an open line; its flat parts lie beside those of its two
//     ▔▔╲▁▁╱▔▔╲▁▁╱▔▔    neighbours, a road's distance apart, so that no line crosses another.
#pragma once

#include "core/roads/fill_pattern.h"  // FillPattern

namespace core {

class HoneycombPattern final : public FillPattern {
 public:
  // COSTS: O(points).
  [[nodiscard]] PatternLines lines(const PatternPlace& place) const override;
};

}  // namespace core
