// The last word on what of a layer is loose, by the build style.
//
//     thin-wall   what the window says, made printable (regularise.h)
//     regular     nothing
//     fast        all within the three perimeters where the whole layer is hidden, otherwise
//                 nothing. Hidden: covered by every slice up to T layers above and below, but for
//                 slivers narrower than kHiddenSliverMax. (The straightforward method of
//                 QuickSlice 6.2 that DETC2000/DAC-14285 compares with, figure 1.)
#pragma once

#include "core/regions/region.h"     // Region
#include "core/settings.h"           // Settings
#include "core/units.h"              // Length
#include "core/walls/split_layer.h"  // SplitLayer

namespace core {

inline constexpr Length kHiddenSliverMax = Length::from_units(1'000);  // 0.1 mm
inline constexpr int kFastPerimeters = 3;

// The settings as the style wants them: the fast style has three perimeters. To be applied once,
// before any stage sees them.
[[nodiscard]] Settings with_style(Settings settings);

class WallStyle {
 public:
  // REQUIRES: with_style() was applied.
  explicit WallStyle(const Settings& settings) : settings_(settings) {}

  // ENSURES: solid ∪ loose = slice, and, but for the fast style, loose only becomes less.
  // COSTS: thin-wall: as regularise_loose().
  [[nodiscard]] SplitLayer apply(SplitLayer layer) const;

  // What apply() takes from the inside is what regularisation costs; the other styles do more.
  [[nodiscard]] bool only_regularises() const { return settings_.style == BuildStyle::kThinWall; }

 private:
  [[nodiscard]] SplitLayer regularised(SplitLayer layer) const;
  [[nodiscard]] SplitLayer fast(SplitLayer layer) const;

  Settings settings_;
};

}  // namespace core
