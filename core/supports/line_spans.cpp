#include "core/supports/line_spans.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace core {
namespace {

void put(double from, double to, LineSpans& spans) {
  if (to - from > kSpanMin) spans.push_back({from, to});
}

}  // namespace

LineSpans intersect_spans(LineSpansView a, LineSpansView b) {
  LineSpans both;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    put(std::max(a[i].from, b[j].from), std::min(a[i].to, b[j].to), both);
    if (a[i].to < b[j].to) {
      ++i;
    } else {
      ++j;
    }
  }
  return both;
}

LineSpans subtract_spans(LineSpansView a, LineSpansView b) {
  LineSpans rest;
  std::size_t first = 0;
  for (const RowSpan& span : a) {
    while (first < b.size() && b[first].to <= span.from) ++first;
    double from = span.from;
    for (std::size_t i = first; i < b.size() && b[i].from < span.to; ++i) {
      put(from, b[i].from, rest);
      from = std::max(from, b[i].to);
    }
    put(from, span.to, rest);
  }
  return rest;
}

LineSpans united_spans(LineSpans spans) {
  std::sort(spans.begin(), spans.end(), [](const RowSpan& a, const RowSpan& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  });
  LineSpans all;
  for (const RowSpan& span : spans) {
    if (!all.empty() && span.from <= all.back().to) {
      all.back().to = std::max(all.back().to, span.to);
    } else {
      all.push_back(span);
    }
  }
  return all;
}

LineSpans grown_spans(LineSpansView spans, double step) {
  LineSpans grown(spans.begin(), spans.end());
  for (RowSpan& span : grown) {
    span.from -= step;
    span.to += step;
  }
  return united_spans(std::move(grown));
}

}  // namespace core
