#include "host/part/arrangement.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/bed.h"

using core::Box;
using core::Length;
using core::Point;
using host::Footprint;

namespace {

Footprint thing(double width, double depth) {
  return {Length::from_mm(width), Length::from_mm(depth)};
}

Box box_at(Point corner, const Footprint& thing) {
  return {corner,
          {corner.x + static_cast<std::int32_t>(thing.width.units()),
           corner.y + static_cast<std::int32_t>(thing.depth.units())}};
}

// Beside each other or one behind the other.
double distance_mm(const Box& a, const Box& b) {
  const std::int64_t x = std::max(std::int64_t{a.min.x} - b.max.x, std::int64_t{b.min.x} - a.max.x);
  const std::int64_t y = std::max(std::int64_t{a.min.y} - b.max.y, std::int64_t{b.min.y} - a.max.y);
  return static_cast<double>(std::max(x, y)) / core::kUnitsPerMm;
}

core::Settings bed_of(double x_mm, double y_mm) {
  core::Settings settings;
  settings.bed_x = Length::from_mm(x_mm);
  settings.bed_y = Length::from_mm(y_mm);
  return settings;
}

void check_laws(const std::vector<Footprint>& things, const std::vector<Point>& corners,
                const core::Settings& settings, Length edge) {
  REQUIRE_EQ(corners.size(), things.size());
  const core::Bed bed(settings);
  const auto out = static_cast<std::int32_t>(edge.units());
  for (std::size_t i = 0; i < things.size(); ++i) {
    const Box box = box_at(corners[i], things[i]);
    CHECK(bed.holds(Box{{box.min.x - out, box.min.y - out}, {box.max.x + out, box.max.y + out}}));
    for (std::size_t j = 0; j < i; ++j) {
      CHECK_GE(distance_mm(box, box_at(corners[j], things[j])), host::object_gap(settings).mm());
    }
  }
}

}  // namespace

TEST_CASE("things keep their distance from one another and from the bed's edge") {
  core::Settings settings = bed_of(220, 200);
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> side(2, 40);
    settings.brim_width = Length::from_mm(seed % 2 == 0 ? 5 : 0);
    std::vector<Footprint> things(5 + seed);
    for (Footprint& one : things) one = thing(side(random), side(random));
    const auto corners = host::arranged(things, settings);
    REQUIRE_MESSAGE(corners.ok(), (corners.ok() ? "" : corners.error().message));
    // Skirt and brim.
    const Length edge =
        settings.brim_width + settings.skirt_distance + settings.road_width * settings.skirt_loops;
    check_laws(things, corners.value(), settings, edge);
  }
}

TEST_CASE("all of them together are in the middle of the bed") {
  const core::Settings settings = bed_of(200, 200);
  const std::vector<Footprint> things{thing(30, 20), thing(20, 20), thing(10, 40)};
  const auto corners = host::arranged(things, settings);
  REQUIRE(corners.ok());
  Box all;
  for (std::size_t i = 0; i < things.size(); ++i) all.add(box_at(corners.value()[i], things[i]));
  CHECK_LE(std::abs(all.min.x + all.max.x - 2'000'000), 2);
  CHECK_LE(std::abs(all.min.y + all.max.y - 2'000'000), 2);
}

TEST_CASE("a bed that just holds a grid of squares is filled") {
  core::Settings settings = bed_of(4 * 20 + 3 * 6, 3 * 20 + 2 * 6);
  settings.skirt_loops = 0;
  const std::vector<Footprint> twelve(12, thing(20, 20));
  const auto corners = host::arranged(twelve, settings);
  REQUIRE(corners.ok());
  check_laws(twelve, corners.value(), settings, Length());
  const auto refused = host::arranged(std::vector<Footprint>(13, thing(20, 20)), settings);
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().message.find("12 of the 13 objects fit") != std::string::npos);
  CHECK(refused.error().message.find("part_gap") != std::string::npos);
}

TEST_CASE("things lie on a round bed") {
  core::Settings settings = bed_of(180, 180);
  for (int i = 0; i < 60; ++i) {
    const double turn = i * 6 * 3.14159265358979 / 180;
    settings.bed_shape.push_back({static_cast<std::int32_t>(900'000 * (1 + std::cos(turn))),
                                  static_cast<std::int32_t>(900'000 * (1 + std::sin(turn)))});
  }
  const std::vector<Footprint> things(9, thing(25, 25));
  const auto corners = host::arranged(things, settings);
  REQUIRE(corners.ok());
  check_laws(things, corners.value(), settings, settings.skirt_distance);
}

TEST_CASE("where they are put by hand, they begin there") {
  core::Settings settings = bed_of(220, 220);
  settings.centre = false;
  settings.part_x = Length::from_mm(30);
  settings.part_y = Length::from_mm(50);
  const std::vector<Footprint> things(4, thing(25, 15));
  const auto corners = host::arranged(things, settings);
  REQUIRE(corners.ok());
  check_laws(things, corners.value(), settings, Length());
  Box all;
  for (const Point corner : corners.value()) all.add(corner);
  CHECK(all.min == Point{300'000, 500'000});
}
