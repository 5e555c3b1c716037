// The radius of the largest disc that touches a site from inside, as a curve along the site.
//
// In the cell of a site, the disc that touches the site at one point grows until it touches
// another site. So the lowest of these curves is the clearance there, and the disc's centre lies
// on the medial axis.
//
//      the site is an edge               the site is a reflex corner
//      ╲   other edge                          ╱ other edge
//       ╲  ___                                ╱
//        ╲/   ╲  r = α + β u            n(φ)╱    1/r = (1 − n·m) / h      m: the edge's normal,
//        ▕  ·  ▏ linear                  · ╱                             h: its distance
//     ────╲___╱──────▶ u                 o        1/r = 2 n·w / |w|²      w: to the other corner
//      other corner: a parabola
//
// Both kinds have a form of which any two meet at most twice, and where they meet is known in
// closed form.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/trigonometry.h"  // cosine, sine, arc_tangent, arc_cosine, hypotenuse
#include "core/vector.h"        // Vector, cross, dot

namespace core {

// r(u) = a u² + b u + c, from an edge along its length. Units.
struct EdgeCurve {
  static constexpr double kSame = 1e-4;

  struct Place {
    explicit Place(double u) : t(u) {}
    double t;
  };

  double a = 0;
  double b = 0;
  double c = 0;
  double low = std::numeric_limits<double>::lowest();
  double high = std::numeric_limits<double>::max();
  std::uint32_t site = 0;  // that is touched

  [[nodiscard]] double value(double u) const { return (a * u + b) * u + c; }
  [[nodiscard]] double value(const Place& place) const { return value(place.t); }

  [[nodiscard]] double crossing(const EdgeCurve& other, double from, double to) const {
    const double qa = a - other.a, qb = b - other.b, qc = c - other.c;
    const double halfway = (from + to) / 2;
    const auto within = [&](double u) { return from <= u && u <= to; };
    if (qa == 0) return qb != 0 && within(-qc / qb) ? -qc / qb : halfway;
    const double discriminant = qb * qb - 4 * qa * qc;
    if (discriminant < 0) return halfway;
    const double sum = -0.5 * (qb + std::copysign(std::sqrt(discriminant), qb));
    if (within(sum / qa)) return sum / qa;
    return sum != 0 && within(qc / sum) ? qc / sum : halfway;
  }

  [[nodiscard]] double closest(const EdgeCurve& other, const Place& from, const Place& to) const {
    const double qa = other.a - a, qb = other.b - b;
    if (qa > 0) return std::fmin(std::fmax(-qb / (2 * qa), from.t), to.t);
    return other.value(from) - value(from) <= other.value(to) - value(to) ? from.t : to.t;
  }
};

// −1/r(φ) = −(k + x cos φ + y sin φ), from a reflex corner over the angle of the direction.
struct CornerCurve {
  static constexpr double kSame = 1e-12;

  struct Place {
    explicit Place(double angle) : t(angle), x(cosine(angle)), y(sine(angle)) {}
    double t;
    double x;
    double y;
  };

  double k = 0;
  double x = 0;
  double y = 0;
  double low = std::numeric_limits<double>::lowest();
  double high = std::numeric_limits<double>::max();
  std::uint32_t site = 0;

  [[nodiscard]] double value(double angle) const { return value(Place(angle)); }
  [[nodiscard]] double value(const Place& place) const { return -(k + x * place.x + y * place.y); }

  [[nodiscard]] double crossing(const CornerCurve& other, double from, double to) const {
    const auto [first, second] = angles_where(x - other.x, y - other.y, other.k - k);
    if (from <= first && first <= to) return first;
    return from <= second && second <= to ? second : (from + to) / 2;
  }

  [[nodiscard]] double closest(const CornerCurve& other, const Place& from, const Place& to) const {
    // other − this is least where its cosine and sine part point that way.
    const double angle = arc_tangent(other.y - y, other.x - x);
    if (from.t <= angle && angle <= to.t) return angle;
    return other.value(from) - value(from) <= other.value(to) - value(to) ? from.t : to.t;
  }

  // Whether x cos φ + y sin φ gets above `most` between two directions: at one of them, or where
  // the slope changes from up to down.
  [[nodiscard]] bool exceeds(double most, Vector from, Vector to) const {
    const Vector peak{x, y};
    if (dot(peak, from) > most || dot(peak, to) > most) return true;
    return cross(from, peak) > 0 && cross(to, peak) < 0 && hypotenuse(x, y) > most;
  }

  // Both angles, within ±π of 0 as nearly as can be, at which px cos φ + py sin φ = p; NaN if none.
  static std::pair<double, double> angles_where(double px, double py, double p) {
    const double middle = arc_tangent(py, px), half = arc_cosine(p / hypotenuse(px, py));
    return {wrapped(middle - half), wrapped(middle + half)};
  }

 private:
  static double wrapped(double angle) {
    if (angle > M_PI) return angle - 2 * M_PI;
    return angle < -M_PI ? angle + 2 * M_PI : angle;
  }
};

}  // namespace core
