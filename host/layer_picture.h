// Draws one layer as SVG, for people: the wall and the inside on the left, the roads that fill them
// on the right, each with its true width.
//
//     ┌ title ─────────────────────────┐
//     │  wall and inside  │  roads     │      one scale for both, told by the bar
//     │  ├── 5 mm ──┤     legend        │
//     └────────────────────────────────┘
#pragma once

#include <string>
#include <vector>

#include "core/road.h"   // Road
#include "core/slice.h"  // SplitLayer

namespace host {

struct LayerPicture {
  std::string title;  // the part's name
  const core::SplitLayer* layer = nullptr;
  const std::vector<core::Road>* roads = nullptr;  // in printing order
};

// COSTS: text of some 60 bytes a point. REQUIRES: layer and roads are there.
[[nodiscard]] std::string draw_layer(const LayerPicture& picture);

}  // namespace host
