#include "core/motions/cooling.h"

#include <doctest/doctest.h>

#include <vector>

using core::Settings;

namespace {

constexpr core::LayerIndex kHigh = 50;

// PrusaSlicer's usual ones.
Settings usual() {
  Settings settings;
  settings.fan_always_on = true;
  settings.fan_share = 1;
  settings.fan_share_min = 0.35;
  settings.layer_time_min_s = 15;
  settings.fan_below_layer_time_s = 100;
  settings.fan_from_layer = 2;
  return settings;
}

core::LaidWay straight(double mm, core::Slowing slowing = core::Slowing::kFirst) {
  return {mm, 60, slowing};
}

}  // namespace

TEST_CASE("the fan follows the layer's time") {
  const Settings settings = usual();
  CHECK_EQ(core::fan_share(settings, kHigh, 5), 1);
  CHECK_EQ(core::fan_share(settings, kHigh, 14.9), 1);
  CHECK_EQ(core::fan_share(settings, kHigh, 15), 1);
  // Half of the way between 15 and 100 s: half of the way between 100 and 35 %.
  CHECK_EQ(core::fan_share(settings, kHigh, 57.5), doctest::Approx(0.67));
  CHECK_EQ(core::fan_share(settings, kHigh, 99.9), doctest::Approx(0.35));
  CHECK_EQ(core::fan_share(settings, kHigh, 100), doctest::Approx(0.35));
  CHECK_EQ(core::fan_share(settings, kHigh, 5'000), doctest::Approx(0.35));
}

TEST_CASE("a fan that is not always on is off where layers take long") {
  Settings settings = usual();
  settings.fan_always_on = false;
  CHECK_EQ(core::fan_share(settings, kHigh, 5), 1);
  CHECK_EQ(core::fan_share(settings, kHigh, 57.5), doctest::Approx(0.67));
  CHECK_EQ(core::fan_share(settings, kHigh, 100), 0);
}

TEST_CASE("without cooling the fan has one speed, and nothing is slowed down") {
  Settings settings = usual();
  settings.cool_short_layers = false;
  CHECK_EQ(core::fan_share(settings, kHigh, 1), doctest::Approx(0.35));
  CHECK_EQ(core::fan_share(settings, kHigh, 1'000), doctest::Approx(0.35));
  CHECK_EQ(core::layer_cooling(settings, kHigh, 0, {straight(6)}).slowdown, 1);
  settings.fan_always_on = false;
  CHECK_EQ(core::fan_share(settings, kHigh, 1), 0);
  settings.cool_short_layers = true;
  CHECK_EQ(core::layer_cooling(settings, kHigh, 0, {straight(6)}).slowdown,
           doctest::Approx(0.1 / 15));
}

TEST_CASE("the first layers are without, the next ones get more and more") {
  Settings settings = usual();
  settings.fan_from_layer = 4;
  for (int i = 0; i < 3; ++i) CHECK_EQ(core::fan_share(settings, i, 1), 0);
  CHECK_EQ(core::fan_share(settings, 3, 1), 1);
  settings.fan_full_layer = 7;
  CHECK_EQ(core::fan_share(settings, 2, 1), 0);
  CHECK_EQ(core::fan_share(settings, 3, 1), doctest::Approx(0.25));
  CHECK_EQ(core::fan_share(settings, 4, 1), doctest::Approx(0.5));
  CHECK_EQ(core::fan_share(settings, 6, 1), 1);
  // A fan that comes on gradually leaves the first layer out at least.
  settings.fan_from_layer = 1;
  CHECK_EQ(core::fan_share(settings, 0, 1), 0);
}

TEST_CASE("the time is the one after slowing down") {
  Settings settings = usual();
  settings.slowed_speed_min_mm_s = 10;
  // 600 mm in 10 s are slowed down to 15 s: the fan is at its most, but no more than by a hair.
  const core::LayerCooling slowed = core::layer_cooling(settings, kHigh, 0, {straight(600)});
  CHECK_EQ(slowed.slowdown, doctest::Approx(10.0 / 15));
  CHECK_EQ(slowed.fan_share, 1);
  // 60 mm can't be slowed down beyond 6 s.
  settings.fan_below_layer_time_s = 0;
  CHECK_EQ(core::layer_cooling(settings, kHigh, 0, {straight(60)}).fan_share, 1);
  CHECK_EQ(core::layer_cooling(settings, kHigh, 0, {straight(600)}).fan_share,
           doctest::Approx(0.35));
}

TEST_CASE("outer perimeters are slowed down last, bridges never") {
  Settings settings = usual();
  settings.slowed_speed_min_mm_s = 10;
  using core::Slowing;
  const auto cooled = [&](double first_mm, double last_mm, double never_mm) {
    return core::layer_cooling(settings, kHigh, 0,
                               {straight(first_mm), straight(last_mm, Slowing::kLast),
                                straight(never_mm, Slowing::kNever)});
  };
  // 2 + 3 + 1 s: what may be slowed down first takes 11 s.
  const core::LayerCooling some = cooled(120, 180, 60);
  CHECK_EQ(some.slowdown, doctest::Approx(2.0 / 11));
  CHECK_EQ(some.last_slowdown, 1);
  // 1 + 3 + 1 s: it takes 6 s at most, so outer perimeters take 8 s.
  const core::LayerCooling all = cooled(60, 180, 60);
  CHECK_EQ(core::slowed_speed_mm_s(60, all.slowdown, 10), 10);
  CHECK_EQ(all.last_slowdown, doctest::Approx(3.0 / 8));
  CHECK_EQ(core::slowdown_of(all, Slowing::kNever), 1);
  CHECK_EQ(all.fan_share, 1);
  // A long layer stays as it is.
  CHECK_EQ(cooled(600, 600, 600).slowdown, 1);
  CHECK_EQ(cooled(600, 600, 600).last_slowdown, 1);
}

TEST_CASE("with our own settings the fan has its speed from its first layer on") {
  for (const double share : {0.0, 0.5, 1.0}) {
    Settings settings;
    settings.fan_share = share;
    for (const double seconds : {0.1, 5.0, 30.0, 60.0, 1e4}) {
      CHECK_EQ(core::fan_share(settings, 0, seconds), 0);
      CHECK_EQ(core::fan_share(settings, 1, seconds), share);
    }
  }
}
