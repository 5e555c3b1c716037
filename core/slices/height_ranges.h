// Ranges of a part's height whose layers have a height that the user chose.
//
//     10-12.5 0.1        ▔▔▔▔▔▔▔▔
//                        ▔▔▔▔▔▔▔▔ 12.6    a range is covered by whole layers: the last one may
//                        ────────         reach above its end, by less than its height
//                        ──────── 10      the first starts exactly where the range does
//
// Heights count from the part's lowest point, also where it lies on a raft. The first layer keeps
// its own height: a range that begins within it begins at its top.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/result.h"    // Result
#include "core/settings.h"  // Settings
#include "core/units.h"     // LayerIndex, Length

namespace core {

struct HeightRange {
  Length from;           // >= 0
  Length to;             // > from
  Length height;         // of its layers
  std::size_t line = 0;  // of the setting, from 1

  // Layers that cover it, and where the last one ends.
  [[nodiscard]] LayerIndex layers() const {
    return ((to - from).units() + height.units() - 1) / height.units();
  }
  [[nodiscard]] Length end() const { return from + height * layers(); }
};

// What layers elsewhere have at least: layer_height, or the least of adaptive ones.
[[nodiscard]] Length least_between_ranges(const Settings& settings);

// Of the first layer.
[[nodiscard]] Length first_layer_height(const Settings& settings);

// Reads one line of Settings::height_range. The error does not name the setting.
[[nodiscard]] Result<HeightRange> read_height_range(std::string_view text);

// All ranges from the bed up, above the first layer. An error names the lines and the cause: what
// can't be read, ranges that overlap, one within the first layer, or space between two that is too
// low for a layer: between them, and below the first one, is either nothing or at least half of
// least_between_ranges(), so that layers fit there exactly (height_plan.h).
[[nodiscard]] Result<std::vector<HeightRange>> height_ranges(const Settings& settings);

}  // namespace core
