#include "core/supports/dense_parts.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/region_text.h"

using namespace core;
using test::rectangle;
using test::rectangle_region;

TEST_CASE("a road is told apart where it enters and leaves the dense part") {
  const Region dense = rectangle_region(5, -1, 4, 4);
  const DenseParts parts(dense);
  const Road straight{RoadKind::kSupport, Length::from_mm(0.4), false, {{0, 0}, {200'000, 0}}};
  const auto three = parts.of(straight);
  REQUIRE_EQ(three.size(), 3);
  CHECK_EQ(three[0].second, false);
  CHECK_EQ(three[1].second, true);
  CHECK_EQ(three[1].first.points, std::vector<Point>{{50'000, 0}, {90'000, 0}});
  CHECK_EQ(three[2].first.points.back(), Point{200'000, 0});
  Road loop{RoadKind::kSupport, Length::from_mm(0.4), true, rectangle(0, 0, 20, 10)};
  double all_mm = 0;
  for (const auto& [part, is_dense] : parts.of(loop)) {
    CHECK_FALSE(part.closed);
    all_mm += length_mm(part);
    if (is_dense) CHECK_EQ(length_mm(part), doctest::Approx(4));
  }
  CHECK_EQ(all_mm, doctest::Approx(60));
  loop.points = rectangle(5.5, 0, 8, 2);
  const auto whole = parts.of(loop);
  REQUIRE_EQ(whole.size(), 1);
  CHECK(whole.front().first.closed);
  CHECK(whole.front().second);
  CHECK_FALSE(DenseParts(Region()).of(straight).front().second);
}
