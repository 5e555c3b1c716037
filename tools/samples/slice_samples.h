// Slices for benches and tests of kernels: synthetic, or cut from parts as in the program.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/regions/region.h"     // Region
#include "core/result.h"             // Result, Status
#include "tools/parts/part_maker.h"  // Part

namespace samples {

// Slices at two neighbouring planes.
struct SlicePair {
  core::Region lower;
  core::Region upper;
};

struct Sample {
  std::string name;
  std::vector<SlicePair> pairs;

  // Edges of the lower slices.
  [[nodiscard]] std::size_t edge_count() const;
};

// Contours of 200 to 20,000 edges, one pair each: annuli whose walls slope or whose waves go round,
// a blob, a lobed tube, a circle, 441 islands, a star without a smooth stretch, one with a dent.
[[nodiscard]] std::vector<Sample> made_up();

// Every slice of the part in this file, from the bed up, with default settings and this layer
// height. Returns an error of the file.
[[nodiscard]] core::Status for_slices(const std::string& path, double layer_height_mm,
                                      const std::function<void(const core::Region&)>& visit);

// `count` pairs spread evenly over the part's height, or fewer if it has fewer; empty slices are
// left out. COSTS: reads the part twice.
[[nodiscard]] core::Result<Sample> of_file(const std::string& path, double layer_height_mm,
                                           int count);

// The same for one of the project's own parts, through a temporary file.
[[nodiscard]] core::Result<Sample> of_part(const parts::NamedPart& part, double layer_height_mm,
                                           int count);

}  // namespace samples
