#include "core/roads/contour_sites.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/trigonometry.h"  // arc_tangent

namespace core {

ContourSites::ContourSites(const std::vector<Ring>& rings) {
  const auto add = [&](Point a, Point b, const ContourSite& site) {
    names_.push_back({a, b, static_cast<std::uint32_t>(sites_.size())});
    sites_.push_back(site);
  };
  for (const Ring& ring : rings) {
    starts_.push_back(static_cast<std::uint32_t>(sites_.size()));
    Vector before;
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const Point a = ring[(i + ring.size() - 1) % ring.size()], b = ring[i % ring.size()];
      const Vector along = to_vector(b) - to_vector(a);
      const double length = std::sqrt(dot(along, along));
      const Vector normal = left_of(along * (1 / length));
      if (i > 0) {
        const Point z = ring[(i + ring.size() - 2) % ring.size()];
        if (cross(z, a, b) < 0) add(a, a, {to_vector(a), before, normal, 0});
        add(a, b, {to_vector(a), normal, normal, length});
      }
      before = normal;
    }
  }
  starts_.push_back(static_cast<std::uint32_t>(sites_.size()));
  std::sort(names_.begin(), names_.end(), [](const Name& x, const Name& y) {
    return std::tie(x.a, x.b, x.site) < std::tie(y.a, y.b, y.site);
  });
}

std::uint32_t ContourSites::find(Point a, Point b) const {
  const auto at = std::lower_bound(
      names_.begin(), names_.end(), Name{a, b, 0},
      [](const Name& x, const Name& y) { return std::tie(x.a, x.b) < std::tie(y.a, y.b); });
  if (at == names_.end() || at->a != a || at->b != b) return kNone;
  const auto next = at + 1;
  return next != names_.end() && next->a == a && next->b == b ? kNone : at->site;
}

double ContourSites::parameter(std::uint32_t site, Vector point) const {
  const ContourSite& on = sites_[site];
  const Vector away = point - on.at;
  if (!on.is_corner()) return cross(away, on.first);
  // Normals turn clockwise about a reflex corner, by half a turn at most.
  const double angle = -arc_tangent(cross(on.first, away), dot(on.first, away));
  return angle < -1 ? angle + 2 * M_PI : angle;
}

Vector ContourSites::direction(std::uint32_t site, Vector point) const {
  const ContourSite& on = sites_[site];
  if (!on.is_corner()) return on.first;
  const Vector away = point - on.at;
  const double length = std::sqrt(dot(away, away));
  return length > 0 ? away * (1 / length) : on.first;
}

Vector ContourSites::foot(std::uint32_t site, Vector point) const {
  const ContourSite& on = sites_[site];
  if (on.is_corner()) return on.at;
  const double along = std::clamp(parameter(site, point), 0.0, on.length);
  return {on.at.x + along * on.first.y, on.at.y - along * on.first.x};
}

}  // namespace core
