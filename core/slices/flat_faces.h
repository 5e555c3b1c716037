// Heights at which a mesh has flat faces, found in one pass, in any order, in constant memory: of
// the faces in one bin of height only that with the largest facet is kept. There are up to
// kFlatBinsMax bins, whose width doubles when the faces outgrow them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry.h"  // Triangle

namespace core {

// Smaller facets are not kept.
inline constexpr double kFlatFacetMin_mm2 = 1;

class FlatFaces {
 public:
  FlatFaces();

  // REQUIRES: the facet is level, or nearly.
  void add(const Triangle& facet);

  // Makes bins twice as wide.
  void widen();

  // In order. COSTS: O(kFlatBinsMax).
  [[nodiscard]] std::vector<std::int64_t> heights() const;

 private:
  struct Face {
    std::int64_t area = 0;  // of the facet, in square units, doubled; 0: none
    std::int64_t z = 0;
    auto operator<=>(const Face&) const = default;
  };

  [[nodiscard]] static std::size_t slot(std::int64_t bin);

  std::vector<Face> bins_;  // a ring
  std::int64_t first_ = 0;
  std::int64_t last_ = -1;
  int shift_;
};

}  // namespace core
