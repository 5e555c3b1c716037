// Lengths and speeds in the whole numbers of the link's commands (firmware_link/wire/command.h).
// All that leaves this program is converted here, so that it is rounded in one way.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "firmware_link/wire/command.h"  // kFeedMmMinMax

namespace host {

// core's unit is 0.1 µm (core/units.h).
inline constexpr std::int64_t kUnitsPerUm = 10;
// Filament is told in 10 nm.
inline constexpr double kFilamentUnitsPerMm = 1e5;

// To the nearest µm, halves away from zero.
[[nodiscard]] constexpr std::int64_t um_of(std::int64_t units) {
  const std::int64_t half = units < 0 ? -kUnitsPerUm / 2 : kUnitsPerUm / 2;
  return (units + half) / kUnitsPerUm;
}

[[nodiscard]] inline std::int64_t filament_10nm(double mm) {
  return std::llround(mm * kFilamentUnitsPerMm);
}

[[nodiscard]] inline std::int64_t feed_mm_min(double mm_s) {
  return std::clamp<std::int64_t>(std::llround(mm_s * 60), 1, firmware_link::kFeedMmMinMax);
}

[[nodiscard]] inline std::int32_t celsius_tenths(double celsius) {
  return static_cast<std::int32_t>(std::clamp(std::lround(celsius * 10), 0L, 9'999L));
}

// `share`: 0 … 1, of full power.
[[nodiscard]] inline std::uint8_t fan_power(double share) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(share * 255), 0L, 255L));
}

[[nodiscard]] inline std::int32_t acceleration_mm_s2(double mm_s2) {
  return static_cast<std::int32_t>(std::clamp(std::lround(mm_s2), 1L, 1'000'000L));
}

[[nodiscard]] inline std::int32_t pressure_advance_tens_us(double seconds) {
  return static_cast<std::int32_t>(std::clamp(std::lround(seconds * 1e5), 0L, 100'000'000L));
}

}  // namespace host
