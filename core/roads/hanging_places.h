// Places of a layer that hang in the air, to be told to the user: what may need a support, or
// another way to lay the part.
//
//     island       an island of the slice over no part of the slice below
//     span         held on two sides that are farther apart than bridge_max
//     overhang     held on one side at most, and steeper than asked: farther beyond the
//                  slice below than  h · tan(angle),  h: the distance of the two planes
//
// A span up to bridge_max is a bridge, which is fine: it is not told. Nor is what supports hold.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry.h"           // Point
#include "core/settings.h"           // Settings
#include "core/walls/split_layer.h"  // SplitLayer

namespace core {

enum class HangingKind { kIsland, kSpan, kOverhang };
inline constexpr std::size_t kHangingKinds = 3;

struct HangingPlace {
  HangingKind kind = HangingKind::kIsland;
  Point at;         // in it, or in the middle of its box
  double size = 0;  // an island's or an overhang's area in mm², a span's length in mm
};

// At most this many places of each kind are kept of a layer, the largest.
inline constexpr std::size_t kHangingPlacesMax = 4;

struct HangingPlaces {
  std::array<std::int64_t, kHangingKinds> counts{};
  std::vector<HangingPlace> largest;  // by kind, then by size
};

// What of the layer hangs in the air. Nothing on the bed.
// COSTS: a walk along the slice and the one below where they nearly agree; else some offsets and
// booleans, and for each place O(points + rows) for some directions.
[[nodiscard]] HangingPlaces hanging_places(const SplitLayer& layer, const Settings& settings);

}  // namespace core
