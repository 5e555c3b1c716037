// Spans of one line: stretches of it, disjoint and in ascending order.
#pragma once

#include <span>
#include <vector>

#include "core/roads/row_cuts.h"  // RowSpan

namespace core {

using LineSpans = std::vector<RowSpan>;
using LineSpansView = std::span<const RowSpan>;

// Spans no longer than this, in units, are none.
inline constexpr double kSpanMin = 1;

// COSTS: O(spans) each.
[[nodiscard]] LineSpans intersect_spans(LineSpansView a, LineSpansView b);
[[nodiscard]] LineSpans subtract_spans(LineSpansView a, LineSpansView b);
// Also of spans in any order that overlap.
[[nodiscard]] LineSpans united_spans(LineSpans spans);
// Each longer by `step` at both ends.
[[nodiscard]] LineSpans grown_spans(LineSpansView spans, double step);

}  // namespace core
