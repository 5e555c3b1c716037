// Offsets and booleans on small cases full of coincidences, beside Boost.Polygon and by winding
// numbers. A few hundred of each; RIND_KERNEL_CASES=1000000 RIND_KERNEL_SEED=1 says how many, and
// from which seed on.
#include <doctest/doctest.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/offsets/polygon_offset.h"
#include "tests/support/boolean_case.h"
#include "tests/support/grid_regions.h"
#include "tests/support/offset_checks.h"

using core::Length;
using core::Region;
using test::Random;

namespace {

std::uint64_t number_from(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

const std::uint64_t kFirst = number_from("RIND_KERNEL_SEED", 1);
const std::uint64_t kEnd = kFirst + number_from("RIND_KERNEL_CASES", 400);

std::vector<std::uint8_t> random_bytes(Random& random) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(random.integer(4, 90)));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.integer(0, 255));
  return bytes;
}

}  // namespace

TEST_CASE("offsets are those of the whole diagram") {
  core::PolygonOffsetter offsetter;
  test::OffsetComparison comparison;
  for (std::uint64_t seed = kFirst; seed < kEnd; ++seed) {
    Random random(seed);
    const int scales[] = {1000, 997, 10'000, 40};
    const int scale = scales[random.integer(0, 3)];
    const Region region = test::random_grid_region(random, scale);
    const Length depth = test::random_grid_depth(random, scale);
    const std::string wrong =
        test::check_against_diagram(offsetter, region, std::span(&depth, 1), comparison);
    if (wrong.empty()) continue;
    CAPTURE(seed);
    CAPTURE(depth.units());
    FAIL_CHECK(wrong);
  }
  CHECK_EQ(offsetter.fallbacks(), 0);
  MESSAGE(comparison.compared << " offsets from seed " << kFirst << ": farthest "
                              << comparison.farthest << " units, " << comparison.critical
                              << " at critical depths, " << offsetter.retries() << " retries");
}

TEST_CASE("offsets of any rings are right by measured distances") {
  for (std::uint64_t seed = kFirst; seed < kEnd; ++seed) {
    Random random(seed);
    const std::string wrong = test::check_offset_case(random_bytes(random));
    if (wrong.empty()) continue;
    CAPTURE(seed);
    FAIL_CHECK(wrong);
  }
}

TEST_CASE("every operation is right on rings that coincide, touch, cross and fold") {
  for (std::uint64_t seed = kFirst; seed < kEnd; ++seed) {
    Random random(seed);
    const std::string wrong = test::check_operations(test::boolean_case(random_bytes(random)));
    if (wrong.empty()) continue;
    CAPTURE(seed);
    FAIL_CHECK(wrong);
  }
}

TEST_CASE("Boost.Polygon says the same, or is wrong") {
  test::BooleanComparison comparison;
  for (std::uint64_t seed = kFirst; seed < kEnd; ++seed) {
    Random random(seed);
    const std::string wrong =
        test::check_against_reference(test::boolean_case(random_bytes(random)), comparison);
    if (wrong.empty()) continue;
    CAPTURE(seed);
    FAIL_CHECK(wrong);
  }
  MESSAGE(comparison.compared << " results from seed " << kFirst << ": widest difference "
                              << comparison.widest << " units, " << comparison.wider << " above 2");
}
