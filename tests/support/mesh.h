// Meshes and their slices, for tests.
#pragma once

#include <string>
#include <vector>

#include "core/geometry.h"                 // Triangle
#include "core/slices/plane_sweep.h"       // PlaneSweep
#include "core/slices/slice.h"             // Slice
#include "tests/support/random_regions.h"  // Random
#include "tools/parts/part_maker.h"        // Part

namespace test {

// Snapped to the grid; z from the part's lowest point.
std::vector<core::Triangle> triangles_of(const parts::Part& part);

// One of make_part's. REQUIRES: there is one of that name.
parts::Part part_named(const std::string& name);

// All slices of triangles that stand on z = 0, given to the sweep in order of lowest z. `layers` is
// set from the highest corner.
struct SweepResult {
  std::vector<core::Slice> slices;
  std::int64_t peak_triangles_held = 0;
};
SweepResult sweep(std::vector<core::Triangle> triangles, core::PlaneSweep::Options options);

// Layers of 0.2 mm; gaps up to 2 mm; no simplification but of straight lines.
core::PlaneSweep::Options exact_options();

void shuffle(std::vector<core::Triangle>& triangles, Random& random);

}  // namespace test
