// How long the machine takes for a stream of moves, in constant memory.
//
// The model is that of the controllers themselves: every straight move is a trapezoid of constant
// acceleration a, joined to the next at a speed that the corner allows, and planned with a
// look-ahead of kLookAheadMoves moves, the last of which is taken to end at rest. No axis is
// faster, or speeds up more, than it may. What a corner allows (motion_model.h):
//
//     junction deviation δ   v² = a · δ · sin(θ/2) / (1 − sin(θ/2))     θ: angle between the moves
//     square corner c        the same, δ = c² (√2 − 1) / a
//     jerk                   no axis changes its speed by more; a move starts from rest with it
//
// (S. K. Jeon, "Improving Grbl: Cornering Algorithm", 2011; Marlin 2.1 has the first and the last,
// 16 blocks; Klipper the second.)
//
// An arc of radius r is one move along its length, no faster than v² = a · r (what Marlin's planner
// makes of an arc's short segments), that leaves in another direction than it starts in.
//
//     speed │      ╭───────╮           ╭──
//           │     ╱         ╲__________╱        the corner's speed bounds both neighbours
//           └────┴───────────┴────────┴───→ way
//
// Not counted: heating up, homing, and what macros do.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/motions/motion_model.h"  // MotionModel
#include "core/ring_buffer.h"           // RingBuffer

namespace core {

// Moves that are planned together, as in Marlin's BLOCK_BUFFER_SIZE.
inline constexpr int kLookAheadMoves = 16;

class MotionClock {
 public:
  struct Arc {
    double centre_x_mm = 0, centre_y_mm = 0;
    bool clockwise = false;  // seen from above
    double length_mm = 0;    // of the way
  };
  struct Move {
    double x_mm = 0, y_mm = 0, z_mm = 0;  // where it ends
    double filament_mm = 0;
    double speed_mm_s = 0;     // along the way; of the filament, if that moves alone. REQUIRES: > 0
    std::optional<Arc> arc{};  // at constant height
  };

  explicit MotionClock(const MotionModel& model);

  // COSTS: O(kLookAheadMoves).
  void add(const Move& move);

  // The nozzle is said to be here (G92, G28): nothing moves.
  void set_place(double x_mm, double y_mm, double z_mm);

  // It comes to rest, and stands so long. REQUIRES: ≥ 0.
  void rest(double seconds);

  // Of the moves that are added from here on.
  void set_model(const MotionModel& model);
  [[nodiscard]] const MotionModel& model() const { return model_; }

  // For all that was added, coming to rest at its end. COSTS: O(kLookAheadMoves).
  [[nodiscard]] double seconds() const;

  // A stretch of moves that another clock has counted need not be counted again: once this clock
  // goes on as that one did at `from`, within the stretch, both count the same for the rest of it.
  // COSTS: O(kLookAheadMoves). `any_height`: nothing in it moves up or down.
  [[nodiscard]] bool goes_on_as(const MotionClock& from, bool any_height) const;
  // REQUIRES: goes_on_as(from, any_height); `to` is the other clock behind the stretch.
  void skip(const MotionClock& from, const MotionClock& to, bool any_height);

 private:
  struct Block {
    double length_mm = 0;
    double speed_mm_s = 0;  // wanted
    double acceleration_mm_s2 = 0;
    double start_speed_mm_s = 0;      // from rest, and to it
    double entry_speed_max_mm_s = 0;  // what the corner before it allows
    double braking_speed_mm_s = -1;   // the fastest entry from which the last move ends at rest
    double entry_speed_mm_s = 0;      // planned
    // At its start and its end: by how much each axis moves for a millimetre of way.
    AxisLimits direction{};
    AxisLimits direction_end{};

    bool operator==(const Block&) const = default;
  };

  [[nodiscard]] bool arc_directions(const Arc& arc, const Move& move, Block& block) const;
  void limit(const Move& move, bool round, Block& block) const;
  void push(Block& block);
  void plan();
  [[nodiscard]] double corner_speed(const Block& before, const Block& after) const;
  [[nodiscard]] double jerk_speed(const AxisLimits& before, const AxisLimits& after) const;
  [[nodiscard]] double exit_of(std::size_t block) const;
  [[nodiscard]] std::int64_t ticks_planned() const;

  MotionModel model_;
  AxisLimits per_speed_{}, per_acceleration_{}, per_jerk_{};  // inverse limits; 0: none
  RingBuffer<Block> moves_{kLookAheadMoves};
  std::int64_t ticks_done_ = 0;  // of moves that are no longer planned, see kTicksPerSecond
  double x_mm_ = 0, y_mm_ = 0, z_mm_ = 0;
};

}  // namespace core
