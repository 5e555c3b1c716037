// How deep the wall (shell) reaches into a slice, by how far away the slice is.
//
//     cylinder   w, at every distance up to T layers       ▛▀▀▀▜
//                                                          ▙▄▄▄▟
//     ball       sqrt(w² − z²), z from the mid-plane of    ▗▛▀▜▖
//                the layer in question to the near face    ▝▙▄▟▘
//                of the other one; w for the layer itself
//
// With layers of one height h, the near face of the layer i away is at z = (i − ½) h. The ball's
// wall is the exact inner offset, by a ball of radius w, of the stack of slabs that is built.
#pragma once

#include <cstdint>
#include <vector>

#include "core/settings.h"      // Settings
#include "core/slices/slice.h"  // Slice
#include "core/units.h"         // Length

namespace core {

// Twice the height of a layer's mid-plane. Doubled, here and below, because a mid-plane can lie
// between two units.
[[nodiscard]] Length doubled_middle(const Slice& slice);
// Twice the distance from the mid-plane of `from` to the near face of `to`; 0 for the same layer.
[[nodiscard]] Length doubled_distance(const Slice& from, const Slice& to);

// sqrt(w² − z²), rounded to the nearest unit. REQUIRES: 0 <= 2z <= 2w.
[[nodiscard]] Length ball_depth(Length wall_thickness, Length doubled_distance);

// For distances of 0, 1, 2 … layers of this height, the deepest first; one entry for a cylinder, a
// depth of 0 for the fast style (wall_style.h).
[[nodiscard]] std::vector<Length> wall_depths(const Settings& settings, Length layer_height);

}  // namespace core
