// How far a controller lets its axes go, as it tells it: in answer to M211 (Marlin's software end
// stops), or behind M115 where it is built so.
//
//     "echo:Soft endstops: On  Min: X0.00 Y0.00 Z0.00  Max: X200.00 Y200.00 Z180.00"
//     "  Min:  X0.00 Y0.00 Z0.00   Max:  X220.00 Y220.00 Z250.00"
//     "area:{full:{min:{x:0.0000,y:0.0000,z:0.0000},max:{x:200.0000,y:200.0000,z:200.0000}},…"
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace firmware_link {

// In mm, for x, y, z.
struct TravelLimits {
  std::array<double, 3> min_mm{};
  std::array<double, 3> max_mm{};

  bool operator==(const TravelLimits&) const = default;
};

// What a line tells of all three axes; nothing: it tells of something else, or makes no sense.
[[nodiscard]] std::optional<TravelLimits> travel_limits_in(std::string_view line);

}  // namespace firmware_link
