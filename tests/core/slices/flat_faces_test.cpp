#include "core/slices/flat_faces.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

#include "core/limits.h"

using core::FlatFaces;
using core::Triangle;
using core::Vertex;

namespace {

// A right angle, `mm` long on both sides.
Triangle level(std::int64_t z, double mm) {
  const auto side = static_cast<std::int32_t>(mm * 1e4);
  return {{Vertex{0, 0, z}, {side, 0, z}, {0, side, z}}};
}

FlatFaces found_in(const std::vector<Triangle>& facets) {
  FlatFaces faces;
  for (const Triangle& facet : facets) faces.add(facet);
  return faces;
}

}  // namespace

TEST_CASE("of the faces in a bin the largest is kept, in any order of facets") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (const std::int64_t high : {std::int64_t{100'000}, std::int64_t{50'000'000}}) {
    std::vector<Triangle> facets;
    for (int i = 0; i < 3'000; ++i) {
      const std::int64_t z = static_cast<std::int64_t>(random() % 4'294'967'296) % high - high / 2;
      facets.push_back(level(z, 1 + 0.001 * static_cast<double>(random() % 5'000)));
    }
    std::int64_t lowest = high, highest = -high;
    for (const Triangle& facet : facets) {
      const bool counts = facet.corners[1].x >= 14'143;
      if (counts) lowest = std::min(lowest, facet.lowest_z());
      if (counts) highest = std::max(highest, facet.lowest_z());
    }
    int shift = 9;
    while ((highest >> shift) - (lowest >> shift) >= std::int64_t{core::kFlatBinsMax}) ++shift;
    CHECK_EQ(shift > 9, high > 2'000'000);
    std::map<std::int64_t, std::pair<std::int32_t, std::int64_t>> best;
    for (const Triangle& facet : facets) {
      // 1 mm² is half of √2 mm times √2 mm.
      if (facet.corners[1].x < 14'143) continue;
      auto& kept = best[facet.lowest_z() >> shift];
      if (kept.first == 0) kept.second = facet.lowest_z();
      kept = std::max(kept, {facet.corners[1].x, facet.lowest_z()});
    }
    std::vector<std::int64_t> expected;
    for (const auto& [bin, face] : best) expected.push_back(face.second);
    CHECK(found_in(facets).heights() == expected);
    std::shuffle(facets.begin(), facets.end(), random);
    CHECK(found_in(facets).heights() == expected);
  }
}

TEST_CASE("small facets don't count, wider bins keep the larger of two faces") {
  CHECK(FlatFaces().heights().empty());
  CHECK(found_in({level(700, 1.4)}).heights().empty());
  FlatFaces faces = found_in({level(600, 3), level(1'000, 2), level(1'030, 4)});
  CHECK(faces.heights() == std::vector<std::int64_t>{600, 1'030});
  faces.widen();
  CHECK(faces.heights() == std::vector<std::int64_t>{600, 1'030});
  faces.widen();
  CHECK(faces.heights() == std::vector<std::int64_t>{1'030});
}
