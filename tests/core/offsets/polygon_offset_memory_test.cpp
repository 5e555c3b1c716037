// Counts this program's allocations; hence a program of its own.
#include <doctest/doctest.h>

#include <cstdlib>
#include <new>
#include <vector>

#include "core/offsets/polygon_offset.h"
#include "tests/support/random_regions.h"

namespace {

long allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

using core::Length;
using core::OffsetContours;
using core::Region;

TEST_CASE("slices like those before cost no allocation") {
  test::Random random(1);
  std::vector<Region> slices;
  for (int i = 0; i < 6; ++i) slices.push_back(test::random_region(random, 600, 30));
  const Length depths[] = {Length::from_mm(0.3), Length::from_mm(1.35), Length::from_mm(-0.4)};
  core::PolygonOffsetter offsetter;
  OffsetContours out[3];
  // Contours of different sizes go through the same memory: some rounds until all have grown.
  for (int round = 0; round < 40; ++round) {
    for (const Region& slice : slices) offsetter.offset(slice, depths, out);
  }
  const long before = allocations;
  for (const Region& slice : slices) offsetter.offset(slice, depths, out);
  CHECK_EQ(allocations - before, 0);
  CHECK_GT(before, 100);
}
