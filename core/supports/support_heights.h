// Between which heights supports hold what hangs, and where only what people enforce is held.
//
//     support_auto, but for      0-20 off        nothing between these heights is held by itself
//     support_height_range      35-40 on         what hangs between these is
//
// Heights count from the part's lowest point, as those of height_range (slices/height_ranges.h). A
// layer hangs at its bottom.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/result.h"    // Result
#include "core/settings.h"  // Settings
#include "core/units.h"     // Length

namespace core {

struct SupportRange {
  Length from;  // >= 0
  Length to;    // > from; not of the range
  bool on = false;
  std::size_t line = 0;  // of the setting, from 1
};

// Reads one line of Settings::support_height_range. The error does not name the setting.
[[nodiscard]] Result<SupportRange> read_support_range(std::string_view text);

// All ranges from the bed up. An error names the lines and the cause: what can't be read, ranges
// that overlap.
[[nodiscard]] Result<std::vector<SupportRange>> support_ranges(const Settings& settings);

class SupportHeights {
 public:
  // REQUIRES: support_ranges() are fine.
  explicit SupportHeights(const Settings& settings);

  // Whether a layer with that bottom is held by itself. COSTS: O(log ranges).
  [[nodiscard]] bool hold_at(Length bottom) const;
  // Whether any layer may be.
  [[nodiscard]] bool hold_anywhere() const;

 private:
  bool elsewhere_;
  std::vector<SupportRange> ranges_;
};

}  // namespace core
