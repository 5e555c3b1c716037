#include "core/motions/width_stretches.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/regions/polyline.h"

using core::Length;
using core::Point;
using core::Road;
using core::RoadKind;

namespace {

constexpr Length kHeight = Length::from_units(2'000);

Point at_mm(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x * 10'000)),
          static_cast<std::int32_t>(std::lround(y * 10'000))};
}

double laid_mm3(const std::vector<core::WidthStretch>& stretches) {
  double sum = 0;
  for (const core::WidthStretch& stretch : stretches) {
    sum += stretch.area_mm2 * core::length_mm(stretch.points, stretch.closed);
  }
  return sum;
}

// Summed over slices of the road, by the rectangle with round sides.
double volume_by_slices_mm3(const Road& road) {
  constexpr int kSlices = 2'000;
  const double h = kHeight.mm();
  double sum = 0;
  const std::size_t count = road.points.size();
  for (std::size_t i = 0; i < (road.closed ? count : count - 1); ++i) {
    const std::size_t j = (i + 1) % count;
    const double mm = core::distance_mm(road.points[i], road.points[j]);
    for (int k = 0; k < kSlices; ++k) {
      const double t = (k + 0.5) / kSlices;
      const double w = width_at(road, i).mm() * (1 - t) + width_at(road, j).mm() * t;
      sum += mm / kSlices * (h * (w - h) + std::numbers::pi * h * h / 4);
    }
  }
  return sum;
}

Road random_road(std::mt19937& random) {
  std::uniform_real_distribution<double> place(0, 20), width(0.25, 0.9);
  Road road{RoadKind::kGapFill, Length::from_mm(0.5), random() % 2 == 0, {}};
  const std::size_t points = 3 + random() % 20;
  for (std::size_t i = 0; i < points; ++i) {
    road.points.push_back(at_mm(place(random), place(random)));
    road.widths.push_back(Length::from_mm(width(random)));
  }
  return road;
}

}  // namespace

TEST_CASE("a road of one width is one stretch") {
  const Road road{RoadKind::kPerimeter,
                  Length::from_mm(0.45),
                  true,
                  {at_mm(0, 0), at_mm(10, 0), at_mm(10, 10)}};
  const auto stretches = core::width_stretches(road, kHeight);
  REQUIRE_EQ(stretches.size(), 1);
  CHECK(stretches[0].closed);
  CHECK_EQ(stretches[0].points, road.points);
  CHECK_EQ(stretches[0].area_mm2, core::bead_area_mm2(road.width, kHeight));
}

TEST_CASE("stretches follow the road, lay what it holds, and each has one width") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 50; ++i) {
    const Road road = random_road(random);
    const auto stretches = core::width_stretches(road, kHeight);
    REQUIRE_FALSE(stretches.empty());
    CHECK_EQ(stretches.front().points.front(), road.points.front());
    CHECK_EQ(stretches.back().points.back(),
             road.closed ? road.points.front() : road.points.back());
    double length = 0;
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      if (k > 0) CHECK_EQ(stretches[k].points.front(), stretches[k - 1].points.back());
      length += core::length_mm(stretches[k].points, false);
    }
    CHECK_EQ(length, doctest::Approx(core::length_mm(road)).epsilon(1e-4));
    CHECK_EQ(laid_mm3(stretches), doctest::Approx(volume_by_slices_mm3(road)).epsilon(1e-3));
  }
}

TEST_CASE("a width that hardly changes is no reason for another stretch") {
  Road road{RoadKind::kGapFill, Length::from_mm(0.45), false, {}};
  for (int i = 0; i <= 100; ++i) {
    road.points.push_back(at_mm(0.1 * i, 0));
    road.widths.push_back(Length::from_mm(0.45 + (i % 2 == 0 ? 0.005 : -0.005)));
  }
  CHECK_EQ(core::width_stretches(road, kHeight).size(), 1);
}

TEST_CASE("a segment whose width changes much is laid in steps, none of them a crumb") {
  const Road road{RoadKind::kGapFill,
                  Length::from_mm(0.5),
                  false,
                  {at_mm(0, 0), at_mm(10, 0)},
                  {Length::from_mm(0.3), Length::from_mm(0.9)}};
  const auto stretches = core::width_stretches(road, kHeight);
  CHECK_GT(stretches.size(), 20);
  for (std::size_t i = 1; i < stretches.size(); ++i) {
    CHECK_GT(stretches[i].width, stretches[i - 1].width);
    CHECK_GE(core::length_mm(stretches[i].points, false), 0.19);
  }
}

TEST_CASE("a width that wavers fast is laid in stretches that are long enough") {
  Road road{RoadKind::kGapFill, Length::from_mm(0.45), false, {}};
  for (int i = 0; i <= 105; ++i) {
    road.points.push_back(at_mm(0.1 * i, 0));
    road.widths.push_back(Length::from_mm(i % 2 == 0 ? 0.6 : 0.3));
  }
  const auto stretches = core::width_stretches(road, kHeight);
  CHECK_GT(stretches.size(), 15);
  for (const auto& stretch : stretches) {
    CHECK_GE(core::length_mm(stretch.points, false), core::kWidthPieceMin.mm() - 1e-3);
  }
  CHECK_EQ(laid_mm3(stretches), doctest::Approx(volume_by_slices_mm3(road)).epsilon(1e-3));
}
