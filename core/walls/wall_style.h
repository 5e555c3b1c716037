// Decides by the build style what of a layer stays loose: the last step before roads. Above the
// floor of a spiral vase (spiral_vase.h) all but one road is.
//
//     thin-wall   what the window says, made printable (regularise.h)
//     regular     nothing
//     fast        where the whole layer is hidden: all within three perimeters. Elsewhere: nothing.
//                 Hidden: every slice up to T layers above and below covers it, except for slivers
//                 narrower than kHiddenSliverMax. This is the simple method of QuickSlice 6.2, with
//                 which DETC2000/DAC-14285 compares (figure 1).
#pragma once

#include "core/regions/region.h"     // Region
#include "core/settings.h"           // Settings
#include "core/units.h"              // Length
#include "core/walls/split_layer.h"  // SplitLayer

namespace core {

inline constexpr Length kHiddenSliverMax = Length::from_units(1'000);  // 0.1 mm
inline constexpr int kFastPerimeters = 3;

// The settings with what the style fixes: the fast style has three perimeters. Apply it once,
// before any stage sees the settings.
[[nodiscard]] Settings with_style(Settings settings);

// Whether the window decides what is wall, and neither the style nor a spiral vase does.
[[nodiscard]] inline bool window_decides(const Settings& settings) {
  return settings.style == BuildStyle::kThinWall && !settings.spiral_vase;
}

class WallStyle {
 public:
  // REQUIRES: with_style() was applied.
  explicit WallStyle(const Settings& settings) : settings_(settings) {}

  // ENSURES: solid ∪ loose = slice. Loose only shrinks, except in the fast style.
  // COSTS: thin-wall: as regularise_loose().
  [[nodiscard]] SplitLayer apply(SplitLayer layer) const;

  // Whether regularisation alone accounts for what apply() takes from the inside.
  [[nodiscard]] bool only_regularises() const { return window_decides(settings_); }

 private:
  [[nodiscard]] SplitLayer regularised(SplitLayer layer) const;
  [[nodiscard]] SplitLayer fast(SplitLayer layer) const;
  [[nodiscard]] static SplitLayer dense(SplitLayer layer);
  [[nodiscard]] SplitLayer hollow(SplitLayer layer) const;

  Settings settings_;
};

}  // namespace core
