// Areas of a slice in which some settings have other values: a slicer's modifiers, objects with
// settings of their own.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/regions/region.h"  // Region
#include "core/settings.h"        // LoosePattern

namespace core {

// What is changed of how a road is laid, not of where it lies: speeds in mm/s, flows as shares of
// what the road would get elsewhere.
enum class LaidValue : std::size_t {
  kPerimeterSpeed,
  kOuterPerimeterSpeed,
  kSmallPerimeterSpeed,  // 0: no difference
  kOverhangSpeed1,       // by Hold; 0: no difference
  kOverhangSpeed2,
  kOverhangSpeed3,
  kOverhangSpeed4,
  kBridgeSpeed,
  kInternalBridgeSpeed,
  kSolidSpeed,
  kTopSpeed,
  kIroningSpeed,
  kLooseSpeed,
  kRestSpeed,
  kFlow,  // of every road, beside the flow of its kind
  kPerimeterFlow,
  kOuterPerimeterFlow,
  kOverhangFlow,
  kBridgeFlow,
  kInternalBridgeFlow,
  kSolidFlow,
  kTopFlow,
  kBottomFlow,
  kLooseFlow,
  kGapFlow,
};

inline constexpr std::size_t kLaidValueCount = static_cast<std::size_t>(LaidValue::kGapFlow) + 1;

using LaidValues = std::array<std::optional<double>, kLaidValueCount>;

// What is asked for within some volume instead of the settings' own.
struct AreaChange {
  std::optional<double> density;        // Settings::loose_density
  std::optional<LoosePattern> pattern;  // Settings::loose_pattern, but for lightning
  std::optional<int> perimeters{};      // Settings::perimeters, both at least 1
  LaidValues laid{};                    // by LaidValue

  [[nodiscard]] std::optional<double>& value(LaidValue which) {
    return laid[static_cast<std::size_t>(which)];
  }
  [[nodiscard]] const std::optional<double>& value(LaidValue which) const {
    return laid[static_cast<std::size_t>(which)];
  }

  // Whether it changes what lies where of the inside; how roads are laid.
  [[nodiscard]] bool fills_otherwise() const { return density || pattern; }
  [[nodiscard]] bool lays_otherwise() const;

  bool operator==(const AreaChange&) const = default;
};

// `later`, and what it leaves as it is from `earlier`.
[[nodiscard]] AreaChange merged(const AreaChange& earlier, const AreaChange& later);

// Where areas overlap, each setting is that of the last one that changes it.
struct ChangedArea {
  AreaChange change;
  Region region;
  bool operator==(const ChangedArea&) const = default;
};
using ChangedAreas = std::vector<ChangedArea>;

// The same as areas that don't overlap, each with all that holds there; those with the same change
// as one. COSTS: some booleans for each two areas that overlap.
[[nodiscard]] ChangedAreas parted(const ChangedAreas& areas);

}  // namespace core
