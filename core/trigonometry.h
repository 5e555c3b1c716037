// Sine, cosine, their inverses and lengths, the same to the last bit on every machine.
//
// The C library's differ from one system to the next in the last bit, and so would roads. These use
// +, −, ×, ÷ and the square root alone, which IEEE 754 rounds in one way.
//
// Errors were measured against long double over the ranges given (trigonometry_test).
// SOURCE: Taylor series on a short range about 0; the rest of the circle by symmetry.
#pragma once

namespace core {

// REQUIRES: |angle| <= 1000 radians. ENSURES: within 1 unit of the last place of 1.
[[nodiscard]] double sine(double angle);
[[nodiscard]] double cosine(double angle);

// The angle of the direction (x, y), −π … π, as std::atan2: 0 for (0, 0); π where y is 0 and x is
// below 0. REQUIRES: both finite. ENSURES: a relative error of at most 2 units of the last place.
[[nodiscard]] double arc_tangent(double y, double x);

// 0 … π; what rounding has put beyond −1 or 1 counts as these. ENSURES: as arc_tangent.
[[nodiscard]] double arc_cosine(double x);

// The length of (x, y) and of (x, y, z). REQUIRES: |x|, |y|, |z| <= 1e150, and a length of 0 or of
// at least 1e-150: nothing is scaled.
[[nodiscard]] double hypotenuse(double x, double y);
[[nodiscard]] double hypotenuse(double x, double y, double z);

}  // namespace core
