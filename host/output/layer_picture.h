// Draws one layer as SVG, for people: on the left the wall, by the paper's regions that say why it
// is wall, and the inside; on the right the roads that fill them, each with its true width.
//
//     ┌ title ─────────────────────────┐
//     │  wall and inside  │  roads     │      one scale for both, told by the bar
//     │  ├── 5 mm ──┤     legend        │
//     └────────────────────────────────┘
#pragma once

#include <string>
#include <vector>

#include "core/roads/road.h"             // Road
#include "core/sections/layer_window.h"  // LayerWindow

namespace host {

struct LayerPicture {
  std::string title;                               // the part's name
  const core::LayerWindow* window = nullptr;       // its layer() is drawn
  const std::vector<core::Road>* roads = nullptr;  // in printing order
};

// COSTS: wall_regions(), and text of some 60 bytes a point. REQUIRES: window and roads are there.
[[nodiscard]] std::string draw_layer(const LayerPicture& picture);

}  // namespace host
