#include "core/slices/height_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "core/check.h"        // RIND_CHECK
#include "core/facet_sides.h"  // FacetSides
#include "core/limits.h"       // kHeightBinsMax

namespace core {
namespace {

constexpr int kFirstShift = 9;  // a bin is 0.0512 mm wide, less than most layers are high

constexpr auto kBins = static_cast<std::int64_t>(kHeightBinsMax);

}  // namespace

HeightBounds adaptive_bounds(const Settings& settings) {
  const std::int64_t step = kHeightStep.units();
  const std::int64_t highest = settings.layer_height_max > Length()
                                   ? settings.layer_height_max.units()
                                   : settings.nozzle_diameter.units() * 3 / 4;
  const std::int64_t lowest = settings.layer_height_min.units();
  return {Length::from_units((lowest + step - 1) / step * step),
          Length::from_units(highest / step * step)};
}

HeightLimits::HeightLimits(Length cusp_height, HeightBounds bounds)
    : cusp_height_(cusp_height),
      bounds_(bounds),
      bins_(kHeightBinsMax, static_cast<std::uint16_t>(bounds.highest.units())),
      shift_(kFirstShift) {
  RIND_CHECK(cusp_height > Length() && bounds.lowest > Length());
  RIND_CHECK(bounds.lowest <= bounds.highest);
  RIND_CHECK(bounds.highest.units() <= std::numeric_limits<std::uint16_t>::max());
}

std::size_t HeightLimits::slot(std::int64_t bin) {
  return static_cast<std::size_t>(bin & (kBins - 1));
}

void HeightLimits::add(const Triangle& facet) {
  const std::int64_t low = facet.lowest_z(), high = facet.highest_z();
  if (high - low < kFlatSpan.units()) return flats_.add(facet);
  const Direction normal = FacetSides(facet).normal();
  const double upward = std::abs(normal.z);
  // Upright, or a line.
  if (upward == 0) return;
  const double length = std::sqrt(normal.length_squared());
  const double allowed = static_cast<double>(cusp_height_.units()) * length / upward;
  if (allowed >= static_cast<double>(bounds_.highest.units())) return;
  limit(low, high, Length::from_units(static_cast<std::int64_t>(allowed)));
}

void HeightLimits::limit(std::int64_t low, std::int64_t high, Length height) {
  RIND_CHECK(low < high);
  if (height >= bounds_.highest) return;
  const auto most = static_cast<std::uint16_t>(std::max(height, bounds_.lowest).units());
  const auto ends = [&] { return std::pair(low >> shift_, (high - 1) >> shift_); };
  auto [from, to] = ends();
  const bool none = last_ < first_;
  while ((none ? to - from : std::max(to, last_) - std::min(from, first_)) >= kBins) {
    widen_bins();
    std::tie(from, to) = ends();
  }
  first_ = none ? from : std::min(from, first_);
  last_ = none ? to : std::max(to, last_);
  for (std::int64_t bin = from; bin <= to;) {
    // Up to the ring's end.
    const std::size_t begin = slot(bin);
    const std::int64_t count = std::min(to - bin + 1, kBins - static_cast<std::int64_t>(begin));
    std::uint16_t* const run = bins_.data() + begin;
    for (std::int64_t i = 0; i < count; ++i) run[i] = std::min(run[i], most);
    bin += count;
  }
}

void HeightLimits::widen() {
  widen_bins();
  flats_.widen();
}

void HeightLimits::widen_bins() {
  std::vector<std::uint16_t> wider(bins_.size(),
                                   static_cast<std::uint16_t>(bounds_.highest.units()));
  for (std::int64_t bin = first_; bin <= last_; ++bin) {
    std::uint16_t& into = wider[slot(bin >> 1)];
    into = std::min(into, bins_[slot(bin)]);
  }
  bins_ = std::move(wider);
  if (first_ <= last_) {
    first_ >>= 1;
    last_ >>= 1;
  }
  ++shift_;
}

std::optional<HeightLimits> adaptive_limits(const Settings& settings) {
  if (!settings.adaptive_layer_height) return std::nullopt;
  return HeightLimits(settings.cusp_height, adaptive_bounds(settings));
}

}  // namespace core
