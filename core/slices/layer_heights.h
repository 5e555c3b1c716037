// How high the layers of a part are: the first one may have a height of its own.
#pragma once

#include <cstdint>

#include "core/settings.h"  // Settings
#include "core/units.h"     // LayerIndex, Length

namespace core {

struct LayerHeights {
  Length first;  // > 0
  Length rest;   // > 0, of all others

  [[nodiscard]] Length height(LayerIndex layer) const { return layer == 0 ? first : rest; }

  [[nodiscard]] Length bottom(LayerIndex layer) const {
    return layer == 0 ? Length() : first + rest * (layer - 1);
  }

  // Twice the height of the plane that cuts the layer, in units: halves are whole numbers so.
  [[nodiscard]] std::int64_t doubled_plane(LayerIndex layer) const {
    return (bottom(layer) * 2 + height(layer)).units();
  }

  // Layers of a part that reaches from 0 up to `top`: those whose plane is not above it.
  [[nodiscard]] LayerIndex count(Length top) const;
};

[[nodiscard]] LayerHeights layer_heights(const Settings& settings);

}  // namespace core
