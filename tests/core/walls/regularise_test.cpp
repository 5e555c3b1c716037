#include "core/walls/regularise.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>

#include "core/booleans/boolean.h"
#include "core/regions/region.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Length;
using core::Region;
using core::RegulariseOptions;

namespace {

const RegulariseOptions kOptions{
    .width_min = Length::from_mm(0.9), .area_min_mm2 = 1, .arc_tolerance = Length::from_mm(0.0025)};

TEST_CASE("a wide place stays loose, corners and all") {
  const Region square = test::region_from_text("0:0 5:0 5:5 0:5");
  CHECK_EQ(core::regularise_loose(square, kOptions), square);
}

TEST_CASE("a tongue narrower than the least width becomes solid, the place it hangs on does not") {
  const Region loose = test::region_from_text("0:0 5:0 5:2 9:2 9:2.5 5:2.5 5:5 0:5");
  const Region expected = test::region_from_text("0:0 5:0 5:5 0:5");
  const Region left = core::regularise_loose(loose, kOptions);
  // At its root the tongue may keep as much as a disc of that width reaches in.
  CHECK_GE(left.area_mm2(), expected.area_mm2() - 0.01);
  CHECK_LE(left.area_mm2(), expected.area_mm2() + 0.15);
}

TEST_CASE("crumbs become solid") {
  const Region loose = test::region_from_text("0:0 5:0 5:5 0:5, 7:0 7.95:0 7.95:0.95 7:0.95");
  CHECK_LE(test::widest_difference(core::regularise_loose(loose, kOptions),
                                   test::region_from_text("0:0 5:0 5:5 0:5")),
           2);
  CHECK(core::regularise_loose(test::region_from_text("0:0 5:0 5:0.8 0:0.8"), kOptions).empty());
  CHECK(core::regularise_loose(Region(), kOptions).empty());
}

TEST_CASE("each island is looked at by itself") {
  const char* const tongue = "0:0 5:0 5:2 9:2 9:2.5 5:2.5 5:5 0:5";
  const char* const others = "20:0 25:0 25:5 20:5, 30:0 30.95:0 30.95:0.95 30:0.95";
  const Region alone = core::regularise_loose(test::region_from_text(tongue), kOptions);
  const Region square = test::region_from_text("20:0 25:0 25:5 20:5");
  const Region all =
      core::regularise_loose(test::region_from_text(std::string(tongue) + ", " + others), kOptions);
  CHECK_EQ(all, core::unite(alone, square));
}

TEST_CASE("zeros leave everything as it is") {
  const Region loose = test::region_from_text("0:0 5:0 5:0.1 0:0.1");
  const RegulariseOptions nothing{.width_min = Length(), .arc_tolerance = Length::from_mm(0.0025)};
  CHECK_EQ(core::regularise_loose(loose, nothing), loose);
}

TEST_CASE("nothing that was solid becomes loose, and more is asked for, less is left") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region loose = test::random_region(random, 60, 15);
    double before = loose.area_mm2();
    for (const double width_mm : {0.3, 0.9, 2.0}) {
      CAPTURE(width_mm);
      RegulariseOptions options = kOptions;
      options.width_min = Length::from_mm(width_mm);
      const Region left = core::regularise_loose(loose, options);
      CHECK(test::is_clean(left));
      CHECK_LE(test::widest_difference(core::subtract(left, loose), Region()), 2);
      // Corner bits that are kept at one width may be tongues at another: a little may come back.
      CHECK_LE(left.area_mm2(), before * 1.05 + 0.5);
      before = left.area_mm2();
    }
  }
}

}  // namespace
