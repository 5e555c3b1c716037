#include "core/slices/inside_out.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/booleans/boolean.h"
#include "tests/support/random_regions.h"

using core::Box;
using core::FillRule;
using core::Ring;

namespace {

// Counter-clockwise, in mm.
Ring square(double x, double y, double side) {
  const auto at = [](double mm) { return static_cast<std::int32_t>(mm * 10'000); };
  return {
      {at(x), at(y)}, {at(x + side), at(y)}, {at(x + side), at(y + side)}, {at(x), at(y + side)}};
}

Ring turned(Ring ring) {
  std::reverse(ring.begin() + 1, ring.end());
  return ring;
}

struct Outcome {
  double area_mm2 = 0;
  std::int64_t turned = 0;
  std::int32_t least_winding = 0;  // before
};

Outcome outcome(std::vector<Ring> rings, const std::optional<Box>& unsure = std::nullopt) {
  Outcome result;
  result.least_winding = core::clean_with_winding(rings, FillRule::kNonZero).least_winding;
  result.turned = core::turn_inside_out(rings, unsure).count;
  result.area_mm2 = core::clean(rings, FillRule::kNonZero).area_mm2();
  return result;
}

}  // namespace

TEST_CASE("sound contours stay, and their windings are not below 0") {
  const std::vector<Ring> plate{square(0, 0, 20), turned(square(5, 5, 4)), square(6, 6, 2),
                                square(15, 15, 20), turned(square(30, 30, 2))};
  const Outcome result = outcome(plate);
  CHECK_EQ(result.turned, 0);
  CHECK_EQ(result.least_winding, 0);
  CHECK_EQ(result.area_mm2, doctest::Approx(400 - 16 + 4 + 400 - 25 - 4));
}

TEST_CASE("a body that is inside out is united with those it meets") {
  const Outcome half = outcome({square(0, 0, 20), turned(square(15, 5, 10))});
  CHECK_EQ(half.least_winding, -1);
  CHECK_EQ(half.turned, 1);
  CHECK_EQ(half.area_mm2, doctest::Approx(450));
  // Only a corner stands out.
  CHECK_EQ(outcome({square(0, 0, 20), turned(square(11, 11, 10))}).area_mm2,
           doctest::Approx(400 + 19));
  // Alone; two that meet; in the hole of another.
  CHECK_EQ(outcome({square(0, 0, 20), turned(square(30, 0, 5))}).area_mm2, doctest::Approx(425));
  CHECK_EQ(outcome({square(0, 0, 20), turned(square(18, 0, 5)), turned(square(20, 0, 5))}).area_mm2,
           doctest::Approx(400 + 25));
  const Outcome island =
      outcome({square(0, 0, 20), turned(square(5, 5, 10)), turned(square(8, 8, 2))});
  CHECK_EQ(island.turned, 1);
  CHECK_EQ(island.area_mm2, doctest::Approx(304));
}

TEST_CASE("its holes are turned with it, those of others are not") {
  // A frame inside out over the end of a plate, whose own hole the frame's plastic covers.
  const Outcome frame = outcome(
      {square(0, 0, 20), turned(square(16, 16, 3)), turned(square(15, 0, 30)), square(25, 5, 10)});
  CHECK_EQ(frame.turned, 2);
  CHECK_EQ(frame.area_mm2, doctest::Approx(400 + 900 - 100 - 100));
  // A hole in the plate beside what overlaps.
  CHECK_EQ(outcome({square(0, 0, 20), turned(square(2, 2, 3)), turned(square(15, 5, 10))}).area_mm2,
           doctest::Approx(450 - 9));
}

TEST_CASE("slivers are nothing; holes that cross are told, and stay") {
  // 0.2 µm beyond the contour.
  CHECK_EQ(outcome({square(0, 0, 20), turned(square(15, 5, 5.00002))}).turned, 0);
  const Outcome crossing =
      outcome({square(0, 0, 20), turned(square(5, 5, 5)), turned(square(8, 8, 5))});
  CHECK_EQ(crossing.turned, 1);
  CHECK_EQ(crossing.area_mm2, doctest::Approx(400 - 50 + 8));
  // Twice, shifted by 1 µm, once inside out.
  CHECK_EQ(outcome({square(0, 0, 20), turned(square(0.001, 0.001, 20))}).area_mm2,
           doctest::Approx(400.04));
}

TEST_CASE("where facets are turned over, what lies within a body is a hole") {
  const std::vector<Ring> plate{square(0, 0, 20), square(5, 5, 4), square(6, 6, 2)};
  CHECK_EQ(outcome(plate).area_mm2, doctest::Approx(400));
  CHECK_EQ(outcome(plate, Box()).area_mm2, doctest::Approx(400 - 16 + 4));
  const Box near{{40'000, 40'000}, {50'000, 50'000}}, far{{190'000, 0}, {200'000, 10'000}};
  CHECK_EQ(outcome(plate, near).area_mm2, doctest::Approx(400 - 16 + 4));
  CHECK_EQ(outcome(plate, far).area_mm2, doctest::Approx(400));
  // Bodies that only overlap stay bodies.
  CHECK_EQ(outcome({square(0, 0, 20), square(15, 5, 10)}, Box()).area_mm2, doctest::Approx(450));
}

TEST_CASE("what is there twice, once inside out, stands out where nothing else is") {
  const std::vector<Ring> plate{square(0, 0, 20), turned(square(5, 5, 4))};
  CHECK(core::stands_out(square(0, 0, 20), {}));
  CHECK(core::stands_out(square(30, 0, 5), plate));
  CHECK(core::stands_out(square(18, 0, 5), plate));
  CHECK_FALSE(core::stands_out(square(12, 12, 5), plate));
}

TEST_CASE("random squares, each turned as it likes, are their union where none is in another") {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<Ring> sound, mixed;
    // In a row that overlaps, so that all stand out and none lies within another.
    double x = 0;
    for (int i = random.integer(2, 8); i > 0; --i) {
      const double side = random.between(6, 9);
      sound.push_back(square(x, random.between(-1, 1), side));
      mixed.push_back(random.integer(0, 1) == 0 ? sound.back() : turned(sound.back()));
      x += side * random.between(0.75, 1.2);
    }
    // One at least runs as it should.
    mixed[0] = sound[0];
    const bool some_turned = mixed != sound;
    CHECK_EQ(core::turn_inside_out(mixed, std::nullopt).count > 0, some_turned);
    CHECK_EQ(core::clean(mixed, FillRule::kNonZero), core::clean(sound, FillRule::kNonZero));
  }
}
