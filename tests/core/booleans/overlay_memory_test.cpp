// Counts this program's allocations; hence a program of its own.
#include <doctest/doctest.h>

#include <cstdlib>
#include <functional>
#include <new>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/offset_contours.h"
#include "core/offsets/polygon_offset.h"
#include "tests/support/random_regions.h"

namespace {

long allocations = 0;

}  // namespace

[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

using core::Length;
using core::Region;

namespace {

// One for each ring of a result, and one for all of them.
long needed(const Region& result) {
  return result.empty() ? 0 : static_cast<long>(result.rings().size()) + 1;
}

// After some rounds, what the operation allocates beside its result.
void check_result_only(const std::vector<Region>& slices,
                       const std::function<Region(const Region&, const Region&)>& operation) {
  for (int round = 0; round < 3; ++round) {
    for (std::size_t i = 0; i < slices.size(); ++i) {
      const Region& next = slices[(i + 1) % slices.size()];
      const long before = allocations;
      const Region result = operation(slices[i], next);
      const long used = allocations - before;
      if (round == 2) CHECK_EQ(used, needed(result));
    }
  }
}

}  // namespace

TEST_CASE("booleans of slices like those before allocate their results and nothing else") {
  test::Random random(1);
  std::vector<Region> slices;
  for (int i = 0; i < 6; ++i) slices.push_back(test::random_region(random, 600, 30));
  check_result_only(slices, core::intersect);
  check_result_only(slices, core::unite);
  check_result_only(slices, core::subtract);
  check_result_only(slices, core::exclusive_or);
  check_result_only(slices, [](const Region& a, const Region&) { return a; });
  CHECK_GT(allocations, 100);
}

TEST_CASE("flattening offsets allocates the regions and nothing else") {
  test::Random random(2);
  core::PolygonOffsetter offsetter;
  std::vector<core::OffsetContours> out(1);
  std::vector<Region> slices;
  for (int i = 0; i < 6; ++i) slices.push_back(test::random_region(random, 600, 30));
  const Length depth = Length::from_mm(0.5);
  for (int round = 0; round < 40; ++round) {
    for (const Region& slice : slices) {
      offsetter.offset(slice, std::span(&depth, 1), out);
      const long before = allocations;
      const Region flat = core::flatten(out[0], Length::from_mm(0.0025));
      const long used = allocations - before;
      if (round == 39) CHECK_EQ(used, needed(flat));
    }
  }
}
