#include "core/roads/road.h"

#include <doctest/doctest.h>

#include <numbers>

#include "core/offsets/slice_offsets.h"

using namespace core;

TEST_CASE("a bead is a rectangle with round sides, an ellipse where it is narrower than high") {
  const Length h = Length::from_mm(0.2);
  CHECK(bead_area_mm2(Length::from_mm(0.45), h) ==
        doctest::Approx(0.2 * 0.25 + std::numbers::pi * 0.1 * 0.1));
  CHECK(bead_area_mm2(h, h) == doctest::Approx(std::numbers::pi * 0.1 * 0.1));
  CHECK(bead_area_mm2(Length::from_mm(0.1), h) == doctest::Approx(std::numbers::pi * 0.05 * 0.1));
}

TEST_CASE("beads at perimeter_spacing fill a layer without a void, or just touch") {
  Settings settings;
  const Length h = settings.layer_height, w = settings.road_width;
  settings.road_overlap = 1;
  CHECK(perimeter_spacing(settings, h).mm() * h.mm() ==
        doctest::Approx(bead_area_mm2(w, h)).epsilon(1e-3));
  CHECK_LT(perimeter_spacing(settings, h), w);
  settings.road_overlap = 0;
  CHECK_EQ(perimeter_spacing(settings, h), w);
}

TEST_CASE("a closed road starts at any place of its contour, its length and widths kept") {
  const auto mm = [](double x) { return Length::from_mm(x); };
  Road road{RoadKind::kPerimeter,
            mm(0.5),
            true,
            {{0, 0}, {100'000, 0}, {100'000, 100'000}},
            {mm(0.4), mm(0.6), mm(0.5)}};
  Road at_place = road;
  at_place.starts = {1};
  start_at(at_place, RingPlace{{25'000, 0}, 0});
  CHECK_EQ(at_place.points,
           (std::vector<Point>{{25'000, 0}, {100'000, 0}, {100'000, 100'000}, {0, 0}}));
  CHECK_EQ(at_place.widths, (std::vector<Length>{mm(0.45), mm(0.6), mm(0.5), mm(0.4)}));
  CHECK(at_place.starts.empty());
  CHECK(length_mm(at_place) == doctest::Approx(length_mm(road)));
  Road at_point = road;
  start_at(at_point, RingPlace{{100'000, 0}, 1});
  CHECK_EQ(at_point.points, (std::vector<Point>{{100'000, 0}, {100'000, 100'000}, {0, 0}}));
}

TEST_CASE("a closed road cut open ends by the gap before its start") {
  const Road road{RoadKind::kPerimeter,
                  Length::from_mm(0.5),
                  true,
                  {{0, 0}, {100'000, 0}, {100'000, 100'000}, {0, 100'000}},
                  {}};
  // Within the last side, and beyond several short ones.
  for (const double gap_mm : {0.06, 1.0, 9.99}) {
    const Road open = opened(road, Length::from_mm(gap_mm));
    CHECK_FALSE(open.closed);
    CHECK_EQ(open.points.front(), road.points.front());
    CHECK(length_mm(open) == doctest::Approx(40 - gap_mm));
  }
  Road fine = road;
  fine.points.insert(fine.points.end(), {{0, 400}, {0, 200}});
  fine.widths.assign(6, Length::from_mm(0.4));
  const Road open = opened(fine, Length::from_mm(0.06));
  CHECK_EQ(open.points.back(), (Point{0, 600}));
  CHECK_EQ(open.widths.size(), open.points.size());
  fine.holds = {Hold::kWhole, Hold::kHalf, Hold::kWhole, Hold::kWhole, Hold::kLittle, Hold::kWhole};
  CHECK_EQ(opened(fine, Length::from_mm(0.06)).holds.size(), open.points.size());
  start_at(fine, RingPlace{{100'000, 50'000}, 1});
  CHECK_EQ(fine.holds, (std::vector<Hold>{Hold::kHalf, Hold::kWhole, Hold::kWhole, Hold::kLittle,
                                          Hold::kWhole, Hold::kWhole, Hold::kHalf}));
  // A quarter of a small one at most; an open one as it is.
  CHECK(length_mm(opened(road, Length::from_mm(20))) == doctest::Approx(30));
  CHECK_EQ(opened(open, Length::from_mm(1)).points, open.points);
}

TEST_CASE("a bead's width and its cross-section belong together") {
  const Length h = Length::from_mm(0.2);
  for (const double width : {0.05, 0.1, 0.19, 0.2, 0.21, 0.45, 1.2}) {
    CAPTURE(width);
    const double area = bead_area_mm2(Length::from_mm(width), h);
    CHECK_EQ(core::bead_width(area, h).mm(), doctest::Approx(width).epsilon(1e-3));
  }
}
