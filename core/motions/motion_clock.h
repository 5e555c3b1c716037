// How long the machine takes for a stream of motions, in constant memory.
//
// The model is that of the controllers themselves: every straight move is a trapezoid of constant
// acceleration a, joined to the next at the junction-deviation speed
//
//     v² = a · δ · sin(θ/2) / (1 − sin(θ/2))       θ: angle between the moves, δ: the deviation
//
// and planned with a look-ahead of kLookAheadMoves moves, the last of which is taken to end at
// rest. (S. K. Jeon, "Improving Grbl: Cornering Algorithm", 2011; Marlin 2.1 has the same formula
// in its planner, δ = 0.013 mm, 16 blocks.)
//
// An arc of radius r is one move along its length, no faster than v² = a · r (what Marlin's planner
// makes of an arc's short segments), that leaves in another direction than it starts in.
//
//     speed │      ╭───────╮           ╭──
//           │     ╱         ╲__________╱        the corner's speed bounds both neighbours
//           └────┴───────────┴────────┴───→ way
//
// Not counted: heating up, and what start and end G-code do beside.
#pragma once

#include "core/motions/motion.h"  // Motion
#include "core/ring_buffer.h"     // RingBuffer

namespace core {

// Moves that are planned together, as in Marlin's BLOCK_BUFFER_SIZE.
inline constexpr int kLookAheadMoves = 16;

struct MotionModel {
  double acceleration_mm_s2;           // until it is told another. REQUIRES: > 0
  double filament_acceleration_mm_s2;  // of moves of the filament alone. REQUIRES: > 0
  double junction_deviation_mm;        // REQUIRES: ≥ 0
};

class MotionClock {
 public:
  explicit MotionClock(const MotionModel& model);

  // COSTS: O(kLookAheadMoves).
  void add(const Motion& motion);

  // For all that was added, coming to rest at its end. COSTS: O(kLookAheadMoves).
  [[nodiscard]] double seconds() const;

 private:
  struct Direction {
    double x = 0, y = 0, z = 0;
  };
  struct Move {
    double length_mm = 0;
    double speed_mm_s = 0;  // wanted
    double acceleration_mm_s2 = 0;
    double entry_speed_max_mm_s = 0;  // what the corner before it allows
    double braking_speed_mm_s = -1;   // the fastest entry from which the last move ends at rest
    double entry_speed_mm_s = 0;      // planned
    Direction direction;              // at its start
    Direction direction_end;
  };

  void add_line(double x_mm, double y_mm, double z_mm, double speed_mm_s);
  void add_arc(const ExtrudeArc& arc);
  void add_filament(double filament_mm, double speed_mm_s);
  void push(const Move& move);
  void plan();
  [[nodiscard]] double corner_speed(const Move& before, const Move& after) const;

  MotionModel model_;
  RingBuffer<Move> moves_{kLookAheadMoves};
  double seconds_done_ = 0;
  double x_mm_ = 0, y_mm_ = 0, z_mm_ = 0;
};

}  // namespace core
