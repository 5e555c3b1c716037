// Where a virtual controller has been commanded to, and by which rules it reads the next move.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "firmware_link/virtual/virtual_controller.h"  // VirtualControllerOptions

namespace firmware_link {

// The box that its axes can reach: µm, each axis.
struct VirtualTravel {
  std::array<std::int64_t, 3> low_um{};
  std::array<std::int64_t, 3> high_um{};
};
[[nodiscard]] VirtualTravel travel_of(const VirtualControllerOptions& options);

class VirtualPosition {
 public:
  struct Target {
    std::array<std::int64_t, 3> um{};
    std::int64_t filament_10nm = 0;  // that the move pushes
    bool clamped = false;            // by the software end stops
  };

  // Where a move leads; takes its feed, too. `clamps`: axes that are homed stay in the box.
  [[nodiscard]] Target target_of(std::string_view text, const VirtualTravel& travel, bool clamps);
  void go(const Target& target);

  // G92: the position is what the text says; all zero where it says nothing.
  void set(std::string_view text);
  // One axis: it is at `um`, and knows it.
  void home(std::size_t axis, std::int64_t um);
  void set_homed(bool homed) { homed_.fill(homed); }

  // G90, G91, M82, M83.
  void set_relative(bool relative) { relative_ = relative; }
  void set_relative_filament(bool relative) { relative_filament_ = relative; }
  void set_feed_percent(std::int64_t percent) { feed_percent_ = percent; }

  [[nodiscard]] const std::array<std::int64_t, 3>& um() const { return um_; }
  [[nodiscard]] double mm(std::size_t axis) const { return static_cast<double>(um_[axis]) * 1e-3; }
  [[nodiscard]] std::int64_t filament_10nm() const { return filament_10nm_; }
  [[nodiscard]] bool homed(std::size_t axis) const { return homed_[axis]; }
  [[nodiscard]] bool relative() const { return relative_; }
  [[nodiscard]] std::int64_t feed_percent() const { return feed_percent_; }
  // As commanded, with M220.
  [[nodiscard]] double speed_mm_s() const {
    return static_cast<double>(feed_mm_min_ * feed_percent_) / 6000.0;
  }

 private:
  std::array<std::int64_t, 3> um_{};
  std::array<bool, 3> homed_{};
  std::int64_t filament_10nm_ = 0;
  std::int64_t feed_mm_min_ = 1500;
  std::int64_t feed_percent_ = 100;
  bool relative_ = false;
  bool relative_filament_ = false;
};

}  // namespace firmware_link
