// Spans of a line against cells.
#include "core/supports/line_spans.h"

#include <doctest/doctest.h>

#include <vector>

#include "tests/support/random_regions.h"

using namespace core;

namespace {

constexpr int kCells = 60;
constexpr double kCell = 10;  // longer than kSpanMin

LineSpans random_spans(test::Random& random) {
  LineSpans spans;
  for (int i = random.integer(0, 6); i > 0; --i) {
    const int from = random.integer(5, kCells - 10);
    spans.push_back({from * kCell, (from + random.integer(1, 8)) * kCell});
  }
  return united_spans(std::move(spans));
}

bool has(LineSpansView spans, int cell) {
  const double at = (cell + 0.5) * kCell;
  for (const RowSpan& span : spans) {
    if (span.from < at && at < span.to) return true;
  }
  return false;
}

bool in_order(LineSpansView spans) {
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (spans[i].from >= spans[i].to) return false;
    if (i > 0 && spans[i - 1].to > spans[i].from) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("spans are cut and grown as cells are") {
  for (std::uint64_t seed = 1; seed <= 2'000; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const LineSpans a = random_spans(random), b = random_spans(random);
    const LineSpans both = intersect_spans(a, b), rest = subtract_spans(a, b);
    const LineSpans grown = grown_spans(a, 2 * kCell);
    CHECK((in_order(a) && in_order(both) && in_order(rest) && in_order(grown)));
    for (int cell = 0; cell < kCells; ++cell) {
      bool near = false;
      for (int other = cell - 2; other <= cell + 2; ++other) near = near || has(a, other);
      REQUIRE_EQ(has(both, cell), (has(a, cell) && has(b, cell)));
      REQUIRE_EQ(has(rest, cell), (has(a, cell) && !has(b, cell)));
      REQUIRE_EQ(has(grown, cell), near);
    }
  }
}
