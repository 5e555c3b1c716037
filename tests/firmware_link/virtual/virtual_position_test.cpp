#include "firmware_link/virtual/virtual_position.h"

#include <doctest/doctest.h>

using namespace firmware_link;

namespace {

VirtualTravel travel() {
  VirtualControllerOptions options;
  options.bed_origin_x_mm = -10;
  return travel_of(options);
}

void move(VirtualPosition& position, const char* text) {
  position.go(position.target_of(text, travel(), true));
}

}  // namespace

TEST_CASE("the box is that of the bed, moved by its origin") {
  CHECK(travel().low_um[0] == -10'000);
  CHECK(travel().high_um[0] == 190'000);
  CHECK(travel().high_um[1] == 200'000);
}

TEST_CASE("moves are absolute or relative, filament by a rule of its own") {
  VirtualPosition position;
  move(position, "G1 X10 Y5 E1 F600");
  CHECK(position.um() == std::array<std::int64_t, 3>{10'000, 5'000, 0});
  CHECK(position.filament_10nm() == 100'000);
  CHECK(position.speed_mm_s() == 10);
  position.set_relative(true);
  position.set_feed_percent(50);
  move(position, "G1 X10 E1.5");
  CHECK(position.um()[0] == 20'000);
  CHECK(position.filament_10nm() == 150'000);
  CHECK(position.speed_mm_s() == 5);
  position.set_relative_filament(true);
  move(position, "G1 E1");
  CHECK(position.filament_10nm() == 250'000);
}

TEST_CASE("only axes that are homed stay in the box, where the firmware clamps") {
  VirtualPosition position;
  CHECK_FALSE(position.target_of("G1 X500", travel(), true).clamped);
  position.home(0, 0);
  CHECK(position.homed(0));
  const auto target = position.target_of("G1 X500 Y500", travel(), true);
  CHECK(target.clamped);
  CHECK(target.um == std::array<std::int64_t, 3>{190'000, 500'000, 0});
  CHECK(position.target_of("G1 X500", travel(), false).um[0] == 500'000);
  CHECK_FALSE(position.target_of("G1 X190", travel(), true).clamped);
}

TEST_CASE("G92 sets what it names, or all to zero") {
  VirtualPosition position;
  move(position, "G1 X10 Y5 E1");
  position.set("G92 E0");
  CHECK(position.filament_10nm() == 0);
  CHECK(position.mm(0) == 10);
  position.set("G92 Y7");
  CHECK(position.mm(1) == 7);
  position.set("G92");
  CHECK(position.um() == std::array<std::int64_t, 3>{0, 0, 0});
}
