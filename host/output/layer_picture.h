// Draws one layer as SVG. On the left: the inside, and the wall, coloured by the paper's regions
// (why a spot is wall). On the right: the roads that fill them, each with its true width.
//
//     ┌ title ─────────────────────────┐
//     │  wall and inside  │  roads     │      one scale for both, shown by the bar
//     │  ├── 5 mm ──┤     legend        │
//     └────────────────────────────────┘
#pragma once

#include <string>
#include <vector>

#include "core/roads/road.h"             // Road
#include "core/sections/layer_window.h"  // LayerWindow
#include "core/slices/slice.h"           // Slice

namespace host {

struct LayerPicture {
  std::string title;                               // the part's name
  const core::LayerWindow* window = nullptr;       // its layer() is drawn
  const std::vector<core::Road>* roads = nullptr;  // in printing order
  std::string subtitle;                            // which layer it is, and of what
};

// "layer 3, 0.4 to 0.6 mm above the bed; …"
[[nodiscard]] std::string layer_words(const core::Slice& slice, const std::string& what);

// COSTS: wall_regions(), and text of about 60 bytes a point. REQUIRES: window and roads are set.
[[nodiscard]] std::string draw_layer(const LayerPicture& picture);

}  // namespace host
