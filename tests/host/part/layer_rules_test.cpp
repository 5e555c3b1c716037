#include "host/part/layer_rules.h"

#include <doctest/doctest.h>

#include "core/limits.h"

using core::Length;

namespace {

core::Slice slice_of(double height_mm) {
  core::Slice slice;
  slice.index = 41;
  slice.height = Length::from_mm(height_mm);
  return slice;
}

}  // namespace

TEST_CASE("layers as high as the window and the nozzle take are fine, others are named") {
  core::Settings settings;
  settings.wall_thickness = Length::from_mm(0.64);
  CHECK(host::check_layer_height("part.cli", slice_of(0.01), settings).ok());
  CHECK(host::check_layer_height("part.cli", slice_of(0.4), settings).ok());
  for (const double height : {0.0, 0.0099, 0.4001, 0.45, 10.0}) {
    CAPTURE(height);
    const core::Status refused = host::check_layer_height("part.cli", slice_of(height), settings);
    REQUIRE_FALSE(refused.ok());
    CHECK_EQ(refused.error().code, core::ErrorCode::kBadPart);
    CHECK_NE(refused.error().message.find("part.cli, layer 42: it is "), std::string::npos);
  }
}

TEST_CASE("a bead that leaves the bed by a unit is told, one that touches its edge is not") {
  core::Settings settings;
  settings.bed_x = settings.bed_y = Length::from_mm(100);
  core::Road road{core::RoadKind::kSolid, Length::from_mm(0.4), false, {{2'000, 2'000}}};
  const auto check = [&](core::Point end) {
    road.points.resize(1);
    road.points.push_back(end);
    return host::check_on_bed("part.stl", slice_of(0.2), {road}, settings);
  };
  CHECK(check({998'000, 998'000}).ok());
  for (const core::Point end : {core::Point{998'001, 50'000}, core::Point{50'000, 998'001},
                                core::Point{1'999, 50'000}, core::Point{50'000, 1'999}}) {
    const core::Status refused = check(end);
    REQUIRE_FALSE(refused.ok());
    CHECK_EQ(refused.error().code, core::ErrorCode::kOutOfBounds);
    CHECK_NE(refused.error().message.find("leaves the bed of 100 x 100 mm"), std::string::npos);
  }
}

TEST_CASE(
    "a bead that leaves the outline of a bed is told, between its box's corner and its edge") {
  core::Settings settings;
  settings.bed_x = settings.bed_y = Length::from_mm(100);
  settings.bed_shape = {{500'000, 0}, {1'000'000, 500'000}, {500'000, 1'000'000}, {0, 500'000}};
  core::Road road{core::RoadKind::kSolid, Length::from_mm(0.4), false, {{500'000, 500'000}}};
  const auto check = [&](core::Point end) {
    road.points.resize(1);
    road.points.push_back(end);
    return host::check_on_bed("part.stl", slice_of(0.2), {road}, settings);
  };
  // 0.2 mm from the sloping edge x + y = 150 mm.
  CHECK(check({748'585, 748'585}).ok());
  CHECK(check({500'000, 997'171}).ok());
  for (const core::Point end : {core::Point{748'588, 748'588}, core::Point{900'000, 900'000},
                                core::Point{500'000, 997'175}, core::Point{100'000, 100'000}}) {
    CAPTURE(end.x);
    const core::Status refused = check(end);
    REQUIRE_FALSE(refused.ok());
    CHECK_NE(refused.error().message.find("no rectangle (bed_shape)"), std::string::npos);
  }
}
