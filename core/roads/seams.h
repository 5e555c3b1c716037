// Where closed perimeters start and end: the seam, a visible mark that shall lie in one line up the
// part, hidden in a corner, and never over air. Chosen layer by layer, in their order.
//
//     aligned    the place with the best   merit (seam_loops.h) − cost of leaving the seam below
//
//                      cost │       ╭─────────     little within reach of the seam below, so that
//                           │       │              it follows a corner; a jump costs kJumpCost at
//                           │___╱───╯              once, so that places of nearly equal merit do
//                           └───────┴──────▸ mm    not alternate. Without a corner the nearest
//                                                  place of the contour, on an edge or a point
//     rear       the farthest back; of a straight rear edge its middle
//     random     any, by a hash of layer and loop
//     nearest    corners only are marked: the order of the roads chooses (road_order.h)
//
// A loop belongs to the seam below that is nearest to its contour, within kSeamReach, of the same
// side (around an island, around a hole). A seam that no loop passes any more is kept for
// kSeamLayersKept layers. Inner perimeters start at the place nearest to their outer one's seam.
//
// Held places come first, whatever the merit; a loop without any starts anywhere.
//
// SOURCE: the idea of aligned seams with visibility and corner terms is PrusaSlicer 2.5's, which
// looks at all layers at once; this looks a few layers ahead and remembers one.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry.h"           // Point
#include "core/roads/layer_roads.h"  // LayerRoads
#include "core/roads/seam_loops.h"   // LayerSeams
#include "core/settings.h"           // SeamPosition
#include "core/units.h"              // LayerIndex

namespace core {

// How far a loop may be from the seam below that it goes on from.
inline constexpr Length kSeamReach = Length::from_units(30'000);

// One seam of the layers below.
struct RememberedSeam {
  Point at;
  bool hole = false;
  int layers_ago = 0;  // that had no loop there
  bool operator==(const RememberedSeam&) const = default;
};

// At most kSeamsMax: those of the last layer first, of its longest loops where they are more.
using SeamMemory = std::vector<RememberedSeam>;

class SeamPlacer {
 public:
  explicit SeamPlacer(SeamPosition position) : position_(position) {}

  // A place for each of the layer's loops; none for SeamPosition::kNearest. Call it layer by layer.
  // COSTS: O(loops · kSeamsMax + points of the loops near a remembered seam).
  [[nodiscard]] std::vector<RingPlace> place(LayerIndex index, const LayerRoads& roads,
                                             const LayerSeams& seams);

  // Of the layers so far: all that the next layers' places depend on.
  [[nodiscard]] const SeamMemory& memory() const { return memory_; }
  void resume_from(SeamMemory memory) { memory_ = std::move(memory); }

 private:
  void remember(const LayerSeams& seams, const std::vector<RingPlace>& places,
                const std::vector<bool>& gone_on);

  SeamPosition position_;
  SeamMemory memory_;
};

// Makes closed perimeters start at these places, and inner ones near them: Road::starts is set.
// For SeamPosition::kNearest, which has no places, outer ones may start at their held corners.
void set_starts(const LayerSeams& seams, const std::vector<RingPlace>& places, LayerRoads& roads);

}  // namespace core
