// The hard regions of tests/corpus, with what is known about each (tests/corpus/README.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"  // FillRule
#include "core/geometry.h"          // Ring
#include "core/units.h"             // Length

namespace test {

struct CorpusOffset {
  core::Length depth;
  double area_mm2 = 0;  // 0: empty
};

struct CorpusRegion {
  std::string name;
  core::FillRule fill = core::FillRule::kPositive;
  std::vector<core::Ring> rings;  // as they stand in the file
  bool clean = false;             // the rings are a clean region
  std::optional<double> area_mm2;
  std::optional<std::size_t> islands;
  std::optional<std::size_t> holes;
  std::vector<CorpusOffset> offsets;
};

// All files, in the order of their names. A file that can't be read fails the test.
[[nodiscard]] std::vector<CorpusRegion> region_corpus();

// The region's shape on a coarse grid, as bytes that boolean_case() and check_offset_case() read.
[[nodiscard]] std::vector<std::uint8_t> fuzz_seed(const CorpusRegion& region);

}  // namespace test
