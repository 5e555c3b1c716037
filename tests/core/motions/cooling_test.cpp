#include "core/motions/cooling.h"

#include <doctest/doctest.h>

#include <vector>

using core::Length;
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

core::Road straight(double mm) {
  const auto x = static_cast<std::int32_t>(Length::from_mm(mm).units());
  return {core::RoadKind::kSolid, Length::from_mm(0.45), false, {{0, 0}, {x, 0}}};
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
  const auto speed = [](core::RoadKind) { return 60.0; };
  CHECK_EQ(core::layer_cooling(settings, kHigh, {straight(6)}, speed).slowdown, 1);
  settings.fan_always_on = false;
  CHECK_EQ(core::fan_share(settings, kHigh, 1), 0);
  settings.cool_short_layers = true;
  CHECK_EQ(core::layer_cooling(settings, kHigh, {straight(6)}, speed).slowdown,
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
  const auto speed = [](core::RoadKind) { return 60.0; };
  // 600 mm in 10 s are slowed down to 15 s: the fan is at its most, but no more than by a hair.
  const core::LayerCooling slowed = core::layer_cooling(settings, kHigh, {straight(600)}, speed);
  CHECK_EQ(slowed.slowdown, doctest::Approx(10.0 / 15));
  CHECK_EQ(slowed.fan_share, 1);
  // 60 mm can't be slowed down beyond 6 s.
  settings.fan_below_layer_time_s = 0;
  CHECK_EQ(core::layer_cooling(settings, kHigh, {straight(60)}, speed).fan_share, 1);
  CHECK_EQ(core::layer_cooling(settings, kHigh, {straight(600)}, speed).fan_share,
           doctest::Approx(0.35));
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
