// How high layers may be so that the surface shows no steps: from the facets' slopes, in one pass,
// in any order, in constant memory.
//
//     cusp c: how far the surface      ╲┌─────     h: the layer's height
//     stands off the layer's edge       ╲c         n: the facet's unit normal
//                                      ┌─╲         c = h · |n_z|
//                                      │ h╲
//
// A layer may be as high as h · |n_z| <= cusp_height allows for every facet between its bottom and
// its top. Upright facets allow any height. Flat ones leave no step, and limit
// nothing; layers should end at them (flat_faces.h).
//
// The height is divided into up to kHeightBinsMax bins, which keep the lowest height that a facet
// within them allows. Their width doubles when the surface outgrows them: then a facet counts for
// more height than it has, and layers are lower than they could be, never higher.
//
// SOURCE: Wasserfall, Hendrich, Zhang, "Adaptive Slicing for the FDM Process Revisited" (CASE
// 2017), which PrusaSlicer uses, too.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"           // Triangle
#include "core/settings.h"           // Settings
#include "core/slices/flat_faces.h"  // FlatFaces
#include "core/units.h"              // Length

namespace core {

// Heights of adaptive layers are whole multiples of this.
inline constexpr Length kHeightStep = Length::from_units(100);

// Facets that span less than this count as flat: files are rounded.
inline constexpr Length kFlatSpan = Length::from_units(10);

// What adaptive layers have at least and at most, in whole steps.
struct HeightBounds {
  Length lowest;
  Length highest;  // may be below the lowest one if the settings contradict one another
};
[[nodiscard]] HeightBounds adaptive_bounds(const Settings& settings);

class HeightLimits {
 public:
  // REQUIRES: 0 < lowest <= highest < 2^16 units, cusp_height > 0.
  HeightLimits(Length cusp_height, HeightBounds bounds);

  // COSTS: O(bins that it spans), none for a facet that allows the highest layers.
  void add(const Triangle& facet);

  // Layers between two heights are at most so high. REQUIRES: low < high.
  void limit(std::int64_t low, std::int64_t high, Length height);

  // Makes bins twice as wide, those of flat faces, too.
  void widen();

  [[nodiscard]] HeightBounds bounds() const { return bounds_; }
  [[nodiscard]] const FlatFaces& flats() const { return flats_; }

  // The bins that limit layers: from first() to last(); none if last() < first(). Bin k reaches
  // from k · bin_width() up, counted from height 0.
  [[nodiscard]] std::int64_t first() const { return first_; }
  [[nodiscard]] std::int64_t last() const { return last_; }
  [[nodiscard]] std::int64_t bin_width() const { return std::int64_t{1} << shift_; }
  // REQUIRES: first() <= bin <= last()
  [[nodiscard]] Length at_bin(std::int64_t bin) const {
    return Length::from_units(bins_[slot(bin)]);
  }

 private:
  void widen_bins();
  [[nodiscard]] static std::size_t slot(std::int64_t bin);

  Length cusp_height_;
  HeightBounds bounds_;
  std::vector<std::uint16_t> bins_;  // a ring: the highest layer's height outside first_ … last_
  std::int64_t first_ = 0;
  std::int64_t last_ = -1;
  int shift_;
  FlatFaces flats_;
};

// For adaptive layers; nothing if the settings ask for none. REQUIRES: settings validated.
[[nodiscard]] std::optional<HeightLimits> adaptive_limits(const Settings& settings);

}  // namespace core
