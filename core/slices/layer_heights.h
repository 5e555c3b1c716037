// How high the layers of a part are: runs of layers of one height, from the bed up.
//
//     ▔▔▔▔▔▔▔  band 2: from layer 4 on, the last one has no end
//     ▔▔▔▔▔▔▔
//     ───────  band 1: layers 1 to 3        every question is answered from the band that it
//     ───────                               falls into, exactly, in whole units
//     ───────
//     ═══════  band 0: layer 0
//
// height_plan.h decides them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/units.h"  // LayerIndex, Length

namespace core {

// Layers of one height.
struct HeightBand {
  LayerIndex first = 0;  // of them
  Length bottom;         // of that layer
  Length height;         // of each; > 0
  auto operator<=>(const HeightBand&) const = default;
};

class LayerHeights {
 public:
  // All layers have one height but for the first. REQUIRES: both > 0.
  LayerHeights(Length first, Length rest);

  // REQUIRES: 1 to kHeightBandsMax bands; the first begins with layer 0 on the bed, each of the
  // others one layer or more later, on top of the layers of the one before.
  explicit LayerHeights(std::vector<HeightBand> bands);

  // COSTS: O(log bands), as all that follow.
  [[nodiscard]] Length height(LayerIndex layer) const { return band_of(layer).height; }

  [[nodiscard]] Length bottom(LayerIndex layer) const {
    const HeightBand& band = band_of(layer);
    return band.bottom + band.height * (layer - band.first);
  }

  // Twice the height of the plane that cuts the layer, in units: halves are whole numbers so.
  [[nodiscard]] std::int64_t doubled_plane(LayerIndex layer) const {
    return (bottom(layer) * 2 + height(layer)).units();
  }

  // Layers of a part that reaches from 0 up to `top`: those whose plane is not above it.
  [[nodiscard]] LayerIndex count(Length top) const;

  [[nodiscard]] const std::vector<HeightBand>& bands() const { return *bands_; }

 private:
  [[nodiscard]] const HeightBand& band_of(LayerIndex layer) const;

  std::shared_ptr<const std::vector<HeightBand>> bands_;  // shared by copies
};

}  // namespace core
