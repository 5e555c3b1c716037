// Ways for the nozzle that stay within an island instead of crossing its perimeters.
//
//     ╭─────────────────────────╮     A straight way that comes near a contour, or crosses it,
//     │  a ·╲    ╭────────╮     │     follows there a line at some depth below the contour, the
//     │      ╲───╯  hole  ╰───╮ │     shorter way round. Then corners are cut where nothing is in
//     │                  b · ◀╯ │     the way.
//     ╰─────────────────────────╯
//
// Where an island is wide, the line lies one road below the contour and no corner is cut nearer
// than 2/5 of a road, so that the outer perimeter is not crossed on the way. In places too narrow
// for that, the line lies half a road or a quarter deep, and the way does not leave the island.
//
// Other methods: a graph of all corners that see one another (shortest, but O(n²)).
// Keywords: avoid crossing perimeters, combing, bug algorithm, string pulling.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/geometry.h"                // Point
#include "core/regions/point_location.h"  // PointLocation
#include "core/regions/region.h"          // Region
#include "core/regions/segment_grid.h"    // SegmentGrid
#include "core/roads/island_split.h"      // IslandSplit
#include "core/roads/line_clip.h"         // LineClipper
#include "core/units.h"                   // Length

namespace core {

class TravelSpace {
 public:
  // How often a way looks whether a corner can be cut; later ones stay.
  static constexpr int kLooksMax = 256;

  // `max_detour`: a way longer than the straight one by more is not taken; 0: any is.
  // COSTS: one offset at four depths, and O(points).
  TravelSpace(const Region& slice, Length road_width, Length max_detour);

  // From the first point to the last one, both included. Straight where nothing is in the way, and
  // where there is no way: between islands, from outside, or if it is too long.
  // COSTS: what the straight way passes of the grids; where it is crossed, O(points) of the
  // contours that are followed, and at most kLooksMax looks into a grid, at each depth.
  [[nodiscard]] std::vector<Point> way(Point from, Point to) const;

 private:
  // Ways at one depth.
  class Level {
   public:
    // Lines to follow, and contours that no way may touch.
    Level(Region lines, const Region& bounds, Length depth);

    // Empty: there is none.
    [[nodiscard]] std::vector<Point> way(Point from, Point to) const;

   private:
    [[nodiscard]] bool entered(Point at, std::vector<BoundaryPoint>& events) const;
    [[nodiscard]] bool follow(const std::vector<BoundaryPoint>& events,
                              std::vector<Point>& way) const;
    void follow(const BoundaryPoint& from, const BoundaryPoint& to, std::vector<Point>& way) const;
    [[nodiscard]] std::vector<Point> shortened(const std::vector<Point>& way) const;

    Region lines_;
    LineClipper along_;
    PointLocation within_;
    SegmentGrid bounds_;
    Length depth_;
  };

  IslandSplit islands_;
  Length max_detour_;
  std::vector<std::unique_ptr<const Level>> levels_;  // the deepest first
};

}  // namespace core
