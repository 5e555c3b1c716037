// The beading of a place: how many beads lie side by side there, how deep and how wide each is.
//
// Let s be the distance of neighbouring perimeters, δ = road_width − s what a bead's round sides
// need beyond it, and R the largest disc's radius. Beads share the room r = 2R − δ:
//
//     count n    where (n − ½) s ≤ r < (n + ½) s; one bead down to road_width_min, none below
//     n odd      n/2 pairs of the user's width, one bead along the axis takes the rest
//     n even     n/2 − 1 such pairs, the innermost pair shares the rest
//     wide       r ≥ (2p + 1) s: all p pairs of the user's width, the interior between them
//
//     │  ╭───╮  ╭─────╮  ╭───╮  │      So no bead is narrower than s/2 or wider than 3/2 s but for
//     │  │ s │  │r−2s │  │ s │  │      one that is alone, and the room is filled exactly.
//     │  ╰───╯  ╰─────╯  ╰───╯  │
//
// SOURCE: Kuipers, Doubrovski, Wu, Wang, "A Framework for Adaptive Width Control of Dense
// Contour-Parallel Toolpaths in Fused Deposition Modeling", Computer-Aided Design 128, 2020:
// the inward distributed scheme with its change kept in the innermost beads.
//
// Keywords: variable width, Arachne, thin walls.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/settings.h"  // Settings
#include "core/units.h"     // Length

namespace core {

// What the grid and its roundings may take from a wall that is as wide as the narrowest road.
inline constexpr Length kRoomSlack = Length::from_units(10);

// Shares of the spacing s.
//
// A count that holds for less than this along the axis gives way to a neighbour's. Where the width
// only grows that way, the wider neighbour's beads go on: this is the transition angle, 30°.
inline constexpr double kCountLengthMin = 1.9;
// A short bulge is filled by the beads around it, up to so much more than they hold elsewhere.
inline constexpr double kBulgeRoomMax = 0.6;
// A short neck is filled by the beads around it, if it is narrower by no more than this.
inline constexpr double kNeckRoomMax = 0.3;
// A narrow end shorter than this is left to the beads around it.
inline constexpr double kEndLengthMin = 1;
// Beads move over this length to where they lie after a change of the count.
inline constexpr double kTransitionLength = 1;

// What decides the beading at one point of the axis. Units.
struct BeadState {
  std::int32_t count = 0;
  std::int32_t toward = 0;  // the count that the beads are on the way to
  double radius = 0;        // where the beads' shares are taken: on the axis, its own
  double share = 0;         // how far they are: 0 … 1
};

// A bead's centre line below the contour, and its share of the room. Units.
struct Bead {
  double depth = 0;
  double room = 0;
};

class Beading {
 public:
  // REQUIRES: settings.perimeters >= 1.
  Beading(const Settings& settings, Length height);

  // The count that stands for a wide place; those below it are numbers of beads.
  [[nodiscard]] int wide() const { return 2 * pairs_ + 2; }
  [[nodiscard]] double spacing() const { return spacing_; }
  [[nodiscard]] double rim() const { return rim_; }
  [[nodiscard]] double room(double radius) const { return 2 * radius - rim_; }
  [[nodiscard]] double radius_of(double room) const { return (room + rim_) / 2; }
  // The least room at which places are wide.
  [[nodiscard]] double room_wide() const { return (2 * pairs_ + 1) * spacing_; }
  // The narrowest bead's.
  [[nodiscard]] double room_min() const { return room_min_; }
  [[nodiscard]] Length width(double bead_room) const {
    return Length::from_units(std::llround(bead_room + rim_));
  }

  // ENSURES: 0 … wide().
  [[nodiscard]] int count_at(double room) const;
  // The least room for which a count is meant. REQUIRES: count >= 1.
  [[nodiscard]] double room_from(int count) const;

  // Pairs of lines along the contours. A wide place has one more: the interior's edge.
  [[nodiscard]] int levels(int count) const;
  [[nodiscard]] Bead bead(int level, const BeadState& state) const;
  // No pair's bead lies nearer to the contour.
  [[nodiscard]] double depth_min() const { return rim_ / 2 + spacing_ * 3 / 8; }
  // Whether there is a bead along the axis.
  [[nodiscard]] bool has_centre(int count) const { return count < wide() && count % 2 == 1; }
  // The room between the pairs of an odd count, at least room_min().
  [[nodiscard]] double centre_room(int count, double radius) const;

 private:
  [[nodiscard]] Bead bead_of(int level, int count, double radius) const;

  int pairs_;
  double spacing_;
  double rim_;
  double room_min_;
};

}  // namespace core
