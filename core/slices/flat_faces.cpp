#include "core/slices/flat_faces.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/limits.h"  // kFlatBinsMax
#include "core/units.h"   // kUnitsPerMm

namespace core {
namespace {

constexpr int kFirstShift = 9;  // a bin is 0.0512 mm wide, less than most layers are high

constexpr auto kBins = static_cast<std::int64_t>(kFlatBinsMax);

constexpr auto kDoubledAreaMin =
    static_cast<std::int64_t>(2 * kFlatFacetMin_mm2 * kUnitsPerMm * kUnitsPerMm);

Point flat(const Vertex& v) { return {v.x, v.y}; }

}  // namespace

FlatFaces::FlatFaces() : bins_(kFlatBinsMax), shift_(kFirstShift) {}

std::size_t FlatFaces::slot(std::int64_t bin) {
  return static_cast<std::size_t>(bin & (kBins - 1));
}

void FlatFaces::add(const Triangle& facet) {
  const auto& [a, b, c] = facet.corners;
  const Face face{std::abs(cross(flat(a), flat(b), flat(c))), facet.lowest_z()};
  if (face.area < kDoubledAreaMin) return;
  const bool none = last_ < first_;
  while (!none && std::max(face.z >> shift_, last_) - std::min(face.z >> shift_, first_) >= kBins) {
    widen();
  }
  const std::int64_t bin = face.z >> shift_;
  first_ = none ? bin : std::min(bin, first_);
  last_ = none ? bin : std::max(bin, last_);
  Face& kept = bins_[slot(bin)];
  kept = std::max(kept, face);
}

void FlatFaces::widen() {
  std::vector<Face> wider(bins_.size());
  for (std::int64_t bin = first_; bin <= last_; ++bin) {
    Face& into = wider[slot(bin >> 1)];
    into = std::max(into, bins_[slot(bin)]);
  }
  bins_ = std::move(wider);
  if (first_ <= last_) {
    first_ >>= 1;
    last_ >>= 1;
  }
  ++shift_;
}

std::vector<std::int64_t> FlatFaces::heights() const {
  std::vector<std::int64_t> heights;
  for (std::int64_t bin = first_; bin <= last_; ++bin) {
    if (const Face& face = bins_[slot(bin)]; face.area > 0) heights.push_back(face.z);
  }
  return heights;
}

}  // namespace core
