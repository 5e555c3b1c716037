// The inside's patterns in the words of PrusaSlicer and OrcaSlicer.
#pragma once

#include <array>
#include <string_view>

#include "core/settings.h"  // LoosePattern

namespace host {

struct PatternWord {
  std::string_view theirs;
  std::string_view ours;
  core::LoosePattern pattern;
};

inline constexpr std::array kPatternWords = {
    PatternWord{"rectilinear", "lines", core::LoosePattern::kLines},
    PatternWord{"alignedrectilinear", "lines", core::LoosePattern::kLines},
    PatternWord{"line", "lines", core::LoosePattern::kLines},
    PatternWord{"zig-zag", "lines", core::LoosePattern::kLines},
    PatternWord{"grid", "grid", core::LoosePattern::kGrid},
    PatternWord{"triangles", "triangles", core::LoosePattern::kTriangles},
    PatternWord{"cubic", "cubic", core::LoosePattern::kCubic},
    PatternWord{"honeycomb", "honeycomb", core::LoosePattern::kHoneycomb},
    PatternWord{"gyroid", "gyroid", core::LoosePattern::kGyroid},
    PatternWord{"concentric", "concentric", core::LoosePattern::kConcentric},
    PatternWord{"lightning", "lightning", core::LoosePattern::kLightning},
};

}  // namespace host
