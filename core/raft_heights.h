// A raft under the part, seen from below: which layers are whose, and how high the part lies.
//
//     ════════════  the part's first layer: index raft_layers in the print, 0 in its own count
//                   raft_contact_distance
//     ▒▒▒▒▒▒▒▒▒▒▒▒  raft_layers − 1: dense               ╮
//     ▒ ▒ ▒ ▒ ▒ ▒   1 …: as high as layer_height          │ raft_height
//     ▒▒ ▒▒ ▒▒ ▒▒   0: first_layer_height                ╯
//
// The part's geometry knows nothing of the raft: its layers count from 0 and lie on 0, and none of
// them is a first layer (settings_above_raft). What is given out is lifted onto the raft.
#pragma once

#include "core/settings.h"  // Settings
#include "core/units.h"     // LayerIndex, Length

namespace core {

// Of the raft's layer, from 0. REQUIRES: 0 <= layer < raft_layers.
[[nodiscard]] Length raft_layer_height(const Settings& settings, LayerIndex layer);
[[nodiscard]] Length raft_layer_bottom(const Settings& settings, LayerIndex layer);

// How far above the bed the part begins; 0 without a raft.
[[nodiscard]] Length raft_lift(const Settings& settings);

// With a raft: the settings for the part's own geometry, whose first layer is like the others (no
// height, width or flow of its own, no elephant-foot compensation), without brim and skirt, which
// lie around the raft, and with an axis_z of what the raft leaves. Without one: the same.
[[nodiscard]] Settings settings_above_raft(Settings settings);

// Whether this layer of the print, the raft's counted, is the part's first one, over the gap.
[[nodiscard]] bool is_above_raft(const Settings& settings, LayerIndex layer);

}  // namespace core
