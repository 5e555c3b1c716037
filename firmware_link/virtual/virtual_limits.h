// How fast a virtual controller's axes may be and speed up, and what its corners cost; as its
// options say, and as M201, M203, M204, M205, M566 and SET_VELOCITY_LIMIT change it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace firmware_link {

// x, y, z, filament. 0: no limit.
using VirtualAxes = std::array<double, 4>;

// By the first of these that is not 0.
struct VirtualCorners {
  VirtualAxes jerk_mm_s{};  // x counts
  double square_corner_mm_s = 0;
  double junction_deviation_mm = 0;
};

struct VirtualLimits {
  double acceleration_mm_s2 = 3'000;           // of moves with filament
  double travel_acceleration_mm_s2 = 0;        // 0: the same
  double filament_acceleration_mm_s2 = 3'000;  // of the filament alone
  VirtualAxes speed_max_mm_s{300, 300, 5, 25};
  VirtualAxes acceleration_max_mm_s2{3'000, 3'000, 100, 10'000};
  VirtualCorners corners{{}, 0, 0.013};

  // A line that sets some of it: M201 … M205, M566. `minutes`: speeds are in mm/min.
  void set_speeds(std::string_view text, bool minutes);
  void set_accelerations_max(std::string_view text);
  void set_accelerations(std::string_view text);
  void set_corners(std::string_view text, bool minutes);
  void set_velocity_limit(std::string_view text);

  // What a move that goes `share` of a millimetre along each axis may have.
  [[nodiscard]] double speed_mm_s(const VirtualAxes& share, double wanted_mm_s) const;
  [[nodiscard]] double acceleration(const VirtualAxes& share) const;
};

}  // namespace firmware_link
