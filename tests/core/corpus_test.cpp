// The hard regions of tests/corpus: what is known about each, and the laws of booleans and offsets.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/limits.h"
#include "core/offsets/polygon_offset.h"
#include "core/regions/contact_check.h"
#include "core/regions/region.h"
#include "tests/support/boolean_case.h"
#include "tests/support/offset_checks.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_corpus.h"

using core::Length;
using core::Region;
using test::CorpusRegion;

namespace {

// What chords, rounding and the nudge of the depth may take from an area, by length of contour.
constexpr double kAreaSlackMm = 0.003;

Region region_of(const CorpusRegion& entry) { return core::clean(entry.rings, entry.fill); }

Region offset_of(const Region& region, Length depth) {
  return core::flatten(core::PolygonOffsetter().offset(region, depth), test::kArcTolerance);
}

std::size_t hole_count(const Region& region) {
  std::size_t count = 0;
  for (const core::Island& island : core::islands(region)) count += island.holes.size();
  return count;
}

// Rounding moves points by a unit, so that areas differ by up to so much.
double slack_mm2(const Region& a, const Region& b) {
  return (a.perimeter_mm() + b.perimeter_mm()) / core::kUnitsPerMm;
}

}  // namespace

TEST_CASE("hard regions: area, islands, holes, and whether they are clean as they stand") {
  for (const CorpusRegion& entry : test::region_corpus()) {
    CAPTURE(entry.name);
    const Region region = region_of(entry);
    CHECK(test::is_clean(region));
    const bool clean = test::is_clean(Region::from_clean_rings(entry.rings));
    CHECK_EQ(clean, entry.clean);
    if (core::surely_clean(entry.rings)) CHECK(clean);
    if (entry.area_mm2) CHECK(region.area_mm2() == doctest::Approx(*entry.area_mm2).epsilon(1e-9));
    if (entry.islands) CHECK_EQ(core::islands(region).size(), *entry.islands);
    if (entry.holes) CHECK_EQ(hole_count(region), *entry.holes);
    // Cleaning what is clean changes nothing.
    CHECK_EQ(core::clean(region.rings(), core::FillRule::kPositive), region);
  }
}

TEST_CASE("hard regions: the offsets that are known, and that an inset lies as deep as it should") {
  for (const CorpusRegion& entry : test::region_corpus()) {
    CAPTURE(entry.name);
    const Region region = region_of(entry);
    for (const test::CorpusOffset& wanted : entry.offsets) {
      CAPTURE(wanted.depth.mm());
      const Region offset = offset_of(region, wanted.depth);
      CHECK(test::is_clean(offset));
      CHECK_EQ(offset.empty(), wanted.area_mm2 == 0);
      const double slack = kAreaSlackMm * (region.perimeter_mm() + offset.perimeter_mm());
      CHECK(std::abs(offset.area_mm2() - wanted.area_mm2) <= slack);
      test::Random random(1);
      CHECK_EQ(test::misjudged_points(region, wanted.depth, offset, random, 200), 0);
    }
  }
}

TEST_CASE("hard regions: an outset holds the region, the region its inset, at every depth less") {
  for (const CorpusRegion& entry : test::region_corpus()) {
    CAPTURE(entry.name);
    // Outsets must stay within the coordinates that are allowed.
    if (entry.name == "far_away") continue;
    const Region region = region_of(entry);
    Region last = offset_of(region, Length::from_mm(-0.5));
    for (const double depth_mm : {-0.1, 0.0, 0.05, 0.3, 0.5, 1.0, 2.5}) {
      CAPTURE(depth_mm);
      Region next = offset_of(region, Length::from_mm(depth_mm));
      CHECK_LE(test::widest_difference(core::unite(next, last), last), 2);
      last = std::move(next);
    }
  }
}

TEST_CASE("hard regions: the laws of booleans hold for every two of them") {
  const std::vector<CorpusRegion> corpus = test::region_corpus();
  for (const CorpusRegion& first : corpus) {
    const Region a = region_of(first);
    for (const CorpusRegion& second : corpus) {
      CAPTURE(first.name);
      CAPTURE(second.name);
      const Region b = region_of(second);
      const Region all = core::unite(a, b), common = core::intersect(a, b);
      const Region rest = core::subtract(a, b), either = core::exclusive_or(a, b);
      for (const Region* result : {&all, &common, &rest, &either}) CHECK(test::is_clean(*result));
      const double slack = slack_mm2(a, b);
      CHECK(std::abs(all.area_mm2() + common.area_mm2() - a.area_mm2() - b.area_mm2()) <= slack);
      CHECK(std::abs(rest.area_mm2() + common.area_mm2() - a.area_mm2()) <= slack);
      CHECK(std::abs(either.area_mm2() + common.area_mm2() - all.area_mm2()) <= slack);
      CHECK_EQ(core::unite(b, a), all);
      CHECK_EQ(core::intersect(b, a), common);
    }
  }
}

TEST_CASE("hard regions are seeds of the fuzzers, which find nothing wrong with them") {
  const std::filesystem::path folder =
      std::filesystem::path(RIND_BINARY_DIR) / "tests" / "corpus_seeds";
  std::filesystem::create_directories(folder);
  std::string list;
  for (const CorpusRegion& entry : test::region_corpus()) {
    CAPTURE(entry.name);
    const std::vector<std::uint8_t> bytes = test::fuzz_seed(entry);
    CHECK_EQ(test::check_operations(test::boolean_case(bytes)), "");
    CHECK_EQ(test::check_offset_case(bytes), "");
    std::ofstream(folder / entry.name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    list += (list.empty() ? "" : ",") + (folder / entry.name).string();
  }
  std::ofstream(folder / "list") << list;
}
