// Lengths, as the grid counts them.
//
// One unit is 100 nm. In the plane a coordinate is an int32 within ±2^29 units (±53 m, limits.h);
// a height is an int64, so height has no bound.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>

namespace core {

// Counts layers from 0, without gaps, from the bed up.
using LayerIndex = std::int64_t;

inline constexpr double kUnitsPerMm = 10'000.0;

class Length {
 public:
  constexpr Length() = default;

  // Exact.
  static constexpr Length from_units(std::int64_t units) { return Length(units); }
  // Rounded to the nearest unit, halves away from zero.
  static Length from_mm(double mm) { return Length(std::llround(mm * kUnitsPerMm)); }

  [[nodiscard]] constexpr std::int64_t units() const { return units_; }
  [[nodiscard]] constexpr double mm() const { return static_cast<double>(units_) / kUnitsPerMm; }

  constexpr auto operator<=>(const Length&) const = default;

  constexpr Length operator-() const { return Length(-units_); }
  constexpr Length operator+(Length other) const { return Length(units_ + other.units_); }
  constexpr Length operator-(Length other) const { return Length(units_ - other.units_); }
  constexpr Length operator*(std::int64_t factor) const { return Length(units_ * factor); }
  constexpr Length& operator+=(Length other) { return *this = *this + other; }
  constexpr Length& operator-=(Length other) { return *this = *this - other; }

 private:
  explicit constexpr Length(std::int64_t units) : units_(units) {}
  std::int64_t units_ = 0;
};

}  // namespace core
