#include "host/pipeline/checkpoint.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/walls/loose_blocks.h"
#include "tests/support/random_regions.h"

using core::Length;
using core::Settings;
using test::Random;

namespace {

// Slices one upon another.
std::vector<core::Slice> stack_of(const std::vector<std::int64_t>& heights_units) {
  std::vector<core::Slice> slices;
  Length bottom;
  for (const std::int64_t units : heights_units) {
    core::Slice slice;
    slice.index = static_cast<core::LayerIndex>(slices.size());
    slice.bottom = bottom;
    slice.height = Length::from_units(units);
    bottom = slice.top();
    slices.push_back(slice);
  }
  return slices;
}

host::Checkpoint before(const core::Slice& slice) {
  host::Checkpoint start;
  start.layer = slice.index;
  start.bottom = slice.bottom;
  return start;
}

}  // namespace

TEST_CASE("every slice that decides a wall or a block from the start on is kept") {
  constexpr std::uint64_t kSeed = 20261128;
  CAPTURE(kSeed);
  Random random(kSeed);
  for (int trial = 0; trial < 500; ++trial) {
    CAPTURE(trial);
    Settings settings;
    settings.wall_thickness = Length::from_units(random.integer(1, 8) * 2'000);
    settings.layer_height = Length::from_units(1'000);
    const bool uneven = random.integer(0, 1) == 1;
    settings.loose_every_layers = uneven ? 1 : random.integer(1, 3);
    std::vector<std::int64_t> heights;
    for (int i = 0; i < 60; ++i) heights.push_back(uneven ? random.integer(5, 40) * 100 : 1'000);
    const std::vector<core::Slice> slices = stack_of(heights);
    const core::Slice& first = slices[static_cast<std::size_t>(random.integer(30, 59))];
    // The lowest layer that is split: under the block that the first one may end, and one more,
    // whose loose is asked for.
    const int block = core::loose_block_layers(settings);
    const core::Slice& lowest = slices[static_cast<std::size_t>(first.index - block)];
    for (const core::Slice& slice : slices) {
      CAPTURE(slice.index);
      const bool counts = slice.index + core::wall_layers(settings) >= lowest.index ||
                          slice.top() + settings.wall_thickness > lowest.bottom;
      if (counts) CHECK_FALSE(host::is_far_below(slice, before(first), settings));
    }
  }
}

TEST_CASE("slices far below are dropped, so that resuming does not take as long as printing") {
  Settings settings;
  const std::vector<core::Slice> slices = stack_of(std::vector<std::int64_t>(60, 2'000));
  const host::Checkpoint start = before(slices[50]);
  const int wall = core::wall_layers(settings);
  for (const core::Slice& slice : slices) {
    CAPTURE(slice.index);
    CHECK_EQ(host::is_far_below(slice, start, settings), slice.index + wall + 2 < 50);
  }
}
