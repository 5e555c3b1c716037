#include "core/motions/height_slowdown.h"

#include <doctest/doctest.h>

#include <vector>

#include "core/motions/motion_builder.h"

using core::Length;

TEST_CASE("a share sinks evenly between two heights") {
  core::Settings settings;
  CHECK_EQ(core::height_share(settings, Length::from_mm(500), 0.2), 1);
  settings.height_slowdown_from = Length::from_mm(50);
  settings.height_slowdown_to = Length::from_mm(150);
  CHECK_EQ(core::height_share(settings, Length::from_mm(10), 0.2), 1);
  CHECK_EQ(core::height_share(settings, Length::from_mm(50), 0.2), 1);
  CHECK(core::height_share(settings, Length::from_mm(75), 0.2) == doctest::Approx(0.8));
  CHECK(core::height_share(settings, Length::from_mm(125), 0.2) == doctest::Approx(0.4));
  CHECK(core::height_share(settings, Length::from_mm(150), 0.2) == doctest::Approx(0.2));
  CHECK(core::height_share(settings, Length::from_mm(900), 0.2) == doctest::Approx(0.2));
}

TEST_CASE("roads and travel of a high layer are slower, and told a lower acceleration") {
  core::Settings settings;
  settings.layer_time_min_s = 0;
  settings.default_acceleration_mm_s2 = 1'000;
  settings.height_slowdown_from = Length::from_mm(10);
  settings.height_slowdown_to = Length::from_mm(20);
  settings.height_slowdown_speed = 0.5;
  settings.height_slowdown_acceleration = 0.2;
  const double full_mm_s = settings.solid_speed_mm_s, travel_mm_s = settings.travel_speed_mm_s;
  for (const double top_mm : {5.0, 15.0, 20.0, 30.0}) {
    CAPTURE(top_mm);
    core::MotionBuilder builder(settings);
    core::Slice slice;
    slice.index = 25;
    slice.height = Length::from_mm(0.2);
    slice.bottom = Length::from_mm(top_mm) - slice.height;
    const core::Road road{
        core::RoadKind::kSolid, Length::from_mm(0.45), false, {{10'000, 0}, {90'000, 0}}};
    const double down = top_mm < 10 ? 0 : top_mm < 20 ? (top_mm - 10) / 10 : 1;
    double laid = 0, travelled = 0;
    std::vector<double> told;
    builder.layer(slice, {road}, [&](const core::Motion& motion) {
      if (const auto* extrude = std::get_if<core::Extrude>(&motion)) laid = extrude->speed_mm_s;
      if (const auto* travel = std::get_if<core::Travel>(&motion)) travelled = travel->speed_mm_s;
      if (const auto* set = std::get_if<core::SetAcceleration>(&motion)) told.push_back(set->mm_s2);
    });
    CHECK(laid == doctest::Approx(full_mm_s * (1 - 0.5 * down)));
    CHECK(travelled == doctest::Approx(travel_mm_s * (1 - 0.5 * down)));
    REQUIRE_EQ(told.size(), 1);
    CHECK(told[0] == doctest::Approx(1'000 * (1 - 0.8 * down)));
  }
}
