#include "tests/support/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/check.h"
#include "core/units.h"

namespace test {

using core::Triangle;

std::vector<Triangle> triangles_of(const parts::Part& part) {
  const auto units = [](double mm) { return std::llround(mm * core::kUnitsPerMm); };
  std::vector<Triangle> triangles;
  std::int64_t lowest = std::numeric_limits<std::int64_t>::max();
  part([&](const parts::Facet& facet) {
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.corners[i] = {static_cast<std::int32_t>(units(facet[i].x)),
                             static_cast<std::int32_t>(units(facet[i].y)), units(facet[i].z)};
    }
    lowest = std::min(lowest, triangle.lowest_z());
    triangles.push_back(triangle);
  });
  for (Triangle& triangle : triangles) {
    for (core::Vertex& corner : triangle.corners) corner.z -= lowest;
  }
  return triangles;
}

parts::Part part_named(const std::string& name) {
  const std::vector<parts::NamedPart>& all = parts::all_parts();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const parts::NamedPart& part) { return part.name == name; });
  RIND_CHECK(found != all.end());
  return found->part;
}

SweepResult sweep(std::vector<Triangle> triangles, core::PlaneSweep::Options options) {
  std::stable_sort(triangles.begin(), triangles.end(), [](const Triangle& a, const Triangle& b) {
    return a.lowest_z() < b.lowest_z();
  });
  std::int64_t height = 0;
  for (const Triangle& triangle : triangles) height = std::max(height, triangle.highest_z());
  options.layers = options.heights.count(core::Length::from_units(height));
  std::size_t next = 0;
  core::PlaneSweep sweeper(options, [&]() -> core::Result<std::optional<Triangle>> {
    if (next == triangles.size()) return std::optional<Triangle>();
    return std::optional<Triangle>(triangles[next++]);
  });
  SweepResult result;
  while (true) {
    core::Result<std::optional<core::Slice>> slice = sweeper.next();
    RIND_CHECK(slice.ok());
    if (!slice.value()) break;
    result.slices.push_back(*std::move(slice).value());
  }
  result.peak_triangles_held = sweeper.peak_triangles_held();
  return result;
}

core::PlaneSweep::Options exact_options() {
  const core::Length height = core::Length::from_units(2'000);
  return {{height, height}, {}, core::Length::from_units(1), core::Length::from_units(20'000), {}};
}

void shuffle(std::vector<Triangle>& triangles, Random& random) {
  for (std::size_t i = triangles.size(); i > 1; --i) {
    std::swap(triangles[i - 1],
              triangles[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
  }
}

}  // namespace test
