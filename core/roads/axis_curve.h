// One edge of the medial axis, as a curve with the radius of the largest disc along it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/offsets/voronoi_diagram.h"  // VoronoiDiagram
#include "core/trigonometry.h"             // hypotenuse

namespace core {

struct Disc {
  double x = 0;
  double y = 0;
  double radius = 0;
};

// A curve over a parameter that runs along it:
//   two edges      a straight line, the radius linear
//   edge, corner   a parabola, radius (u² + h²) / 2h for a corner h away from the edge's line
//   two corners    a straight line, radius √(u² + h²) for corners 2h apart
class AxisCurve {
 public:
  AxisCurve(const VoronoiDiagram& diagram, std::uint32_t edge) {
    const VoronoiSite& a = diagram.site_of(edge);
    const VoronoiSite& b = diagram.site_of(diagram.edges[edge].twin);
    const VoronoiVertex& from = diagram.vertices[diagram.edges[edge].from];
    const VoronoiVertex& to = diagram.vertices[diagram.to(edge)];
    if (!a.is_corner() && !b.is_corner()) {
      set_linear(from, to);
      return;
    }
    const VoronoiSite& corner = a.is_corner() ? a : b;
    const VoronoiSite& other = a.is_corner() ? b : a;
    const double cx = corner.a.x, cy = corner.a.y;
    if (other.is_corner()) {
      const double dx = other.a.x - cx, dy = other.a.y - cy, length = hypotenuse(dx, dy);
      kind_ = Kind::kHyperbolic;
      height_ = length / 2;
      origin_ = {cx + dx / 2, cy + dy / 2, 0};
      along_ = {-dy / length, dx / length, 0};
    } else {
      const double dx = static_cast<double>(other.b.x) - other.a.x;
      const double dy = static_cast<double>(other.b.y) - other.a.y;
      const double length = hypotenuse(dx, dy);
      const double px = cx - other.a.x, py = cy - other.a.y;
      const double along = (px * dx + py * dy) / length, across = (dx * py - dy * px) / length;
      height_ = std::abs(across);
      if (height_ < 1) {  // too flat for a parabola, and too narrow for a road
        set_linear(from, to);
        return;
      }
      kind_ = Kind::kParabolic;
      origin_ = {other.a.x + along * dx / length, other.a.y + along * dy / length, 0};
      along_ = {dx / length, dy / length, 0};
      const double side = across < 0 ? -1 : 1;
      normal_ = {-along_.y * side, along_.x * side, 0};
    }
    first_ = parameter_of(from);
    last_ = parameter_of(to);
  }

  [[nodiscard]] Disc at(double u) const {
    if (kind_ == Kind::kLinear) {
      return {origin_.x + u * along_.x, origin_.y + u * along_.y,
              origin_.radius + u * along_.radius};
    }
    const double radius = kind_ == Kind::kParabolic ? (u * u + height_ * height_) / (2 * height_)
                                                    : hypotenuse(u, height_);
    const double lift = kind_ == Kind::kParabolic ? radius : 0;
    return {origin_.x + u * along_.x + lift * normal_.x,
            origin_.y + u * along_.y + lift * normal_.y, radius};
  }

  // Where to put points: both ends, the lowest spot, where the radius passes a limit, and between
  // these as often as the curve needs.
  void find_stops(double radius_min, double radius_max, std::vector<double>& result) const {
    result.assign({first_, last_});
    const double low = std::min(first_, last_), high = std::max(first_, last_);
    const auto add = [&](double u) {
      if (low < u && u < high) result.push_back(u);
    };
    for (const double radius : {radius_min, radius_max}) {
      if (kind_ == Kind::kLinear) {
        if (along_.radius != 0) add((radius - origin_.radius) / along_.radius);
        continue;
      }
      const double squared = kind_ == Kind::kParabolic ? 2 * height_ * radius - height_ * height_
                                                       : radius * radius - height_ * height_;
      if (squared <= 0) continue;
      add(std::sqrt(squared));
      add(-std::sqrt(squared));
    }
    if (kind_ != Kind::kLinear) {
      add(0);
      // A chord over s of a curve that bends by at most 1 / h is off by s² / 8h.
      const double pieces = (high - low) / std::sqrt(8 * height_ * kTolerance);
      const int count = static_cast<int>(std::clamp(std::ceil(pieces), 1.0, double{kPiecesMax}));
      for (int i = 1; i < count; ++i) add(low + (high - low) * i / count);
    }
    std::sort(result.begin(), result.end());
    if (first_ > last_) std::reverse(result.begin(), result.end());
  }

 private:
  // Chords stay this near to the curve. Units.
  static constexpr double kTolerance = 10;
  // Pieces that one curve is split into at most.
  static constexpr int kPiecesMax = 64;

  enum class Kind { kLinear, kParabolic, kHyperbolic };

  void set_linear(const VoronoiVertex& from, const VoronoiVertex& to) {
    kind_ = Kind::kLinear;
    origin_ = {from.x, from.y, from.height};
    along_ = {to.x - from.x, to.y - from.y, to.height - from.height};
    first_ = 0;
    last_ = 1;
  }
  [[nodiscard]] double parameter_of(const VoronoiVertex& vertex) const {
    return (vertex.x - origin_.x) * along_.x + (vertex.y - origin_.y) * along_.y;
  }

  Kind kind_ = Kind::kLinear;
  Disc origin_, along_, normal_;
  double height_ = 0;
  double first_ = 0;
  double last_ = 1;
};

}  // namespace core
