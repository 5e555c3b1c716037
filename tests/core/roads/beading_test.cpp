#include "core/roads/beading.h"

#include <doctest/doctest.h>

#include <vector>

#include "tests/support/random_regions.h"

using core::Bead;
using core::Beading;
using core::Length;
using core::Settings;
using test::Random;

namespace {

Beading beading_of(int perimeters) {
  Settings settings;
  settings.perimeters = perimeters;
  return Beading(settings, Length::from_mm(0.2));
}

// All beads from one side to the middle.
std::vector<Bead> beads_at(const Beading& beading, int count, double radius) {
  std::vector<Bead> beads;
  for (int level = 1; level <= count / 2; ++level) {
    beads.push_back(beading.bead(level, {count, 0, radius}));
  }
  if (beading.has_centre(count)) beads.push_back({radius, beading.centre_room(count, radius)});
  return beads;
}

}  // namespace

TEST_CASE("beads lie side by side and fill the room, none much narrower or wider than others") {
  Random random(1301);
  for (int perimeters = 1; perimeters <= 8; ++perimeters) {
    const Beading beading = beading_of(perimeters);
    const double s = beading.spacing();
    for (int i = 0; i < 1'000; ++i) {
      const double room = random.between(beading.room_min(), beading.room_wide() - 1e-3);
      const double radius = beading.radius_of(room);
      CAPTURE(perimeters);
      CAPTURE(room / s);
      const int count = beading.count_at(room);
      CHECK_LT(count, beading.wide());
      double edge = beading.rim() / 2;  // where the bead before ends
      double filled = 0;
      for (const Bead& bead : beads_at(beading, count, radius)) {
        CHECK_EQ(bead.depth - bead.room / 2, doctest::Approx(edge));
        edge = bead.depth + bead.room / 2;
        filled += bead.depth == radius ? bead.room : 2 * bead.room;
        CHECK_GE(bead.room, (count == 1 ? beading.room_min() : s / 2) - 1e-6);
        CHECK_LE(bead.room, 1.5 * s + 1e-6);
      }
      CHECK_EQ(filled, doctest::Approx(room));
    }
  }
}

TEST_CASE("a count's limits are where it begins") {
  const Beading beading = beading_of(2);
  CHECK_EQ(beading.count_at(beading.room_min() - 1), 0);
  for (int count = 1; count <= beading.wide(); ++count) {
    CHECK_EQ(beading.count_at(beading.room_from(count) + 1e-3), count);
    CHECK_EQ(beading.count_at(beading.room_from(count) - 1e-3), count - 1);
  }
}

TEST_CASE("a transition goes from one beading to the other") {
  const Beading beading = beading_of(2);
  const double radius = beading.radius_of(2.5 * beading.spacing());
  const double two = beading.bead(1, {2, 0, radius}).depth,
               three = beading.bead(1, {3, 0, radius}).depth;
  CHECK_GT(two, three);
  CHECK_EQ(beading.bead(1, {2, 3, radius, 1}).depth, doctest::Approx(three));
  CHECK_EQ(beading.bead(1, {2, 3, radius, 0.5}).depth, doctest::Approx((two + three) / 2));
}
