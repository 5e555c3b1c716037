#include "core/offsets/offset_input.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace core {
namespace {

// Below this extent plain double products of differences are exact: 2 · 2^26 · 2^26 = 2^53.
constexpr double kNarrowExtent = 1 << 26;

double cross_of(const OffsetEdge& a, const OffsetEdge& b) {
  return exact_cross<true>(a.dx, a.dy, b.dx, b.dy);
}
double dot_of(const OffsetEdge& a, const OffsetEdge& b) {
  return exact_dot<true>(a.dx, a.dy, b.dx, b.dy);
}

// True where the contour goes straight on.
bool is_straight(Point a, Point b, Point c) {
  if (cross(a, b, c) != 0) return false;
  const std::int64_t abx = std::int64_t{b.x} - a.x, aby = std::int64_t{b.y} - a.y;
  const std::int64_t bcx = std::int64_t{c.x} - b.x, bcy = std::int64_t{c.y} - b.y;
  return abx * bcx + aby * bcy > 0;
}

}  // namespace

void OffsetInput::load(const Region& region, bool mirrored) {
  load(region, region.box(), mirrored);
}

void OffsetInput::load(const Region& region, const Box& box, bool mirrored) {
  mirror_ = mirrored ? -1 : 1;
  origin_x_ = box.min.x;
  origin_y_ = box.min.y;
  wide_ = !box.empty() && (double{1} * box.max.x - box.min.x > kNarrowExtent ||
                           double{1} * box.max.y - box.min.y > kNarrowExtent);
  edges_.clear();
  for (const Ring& ring : region.rings()) load_ring(ring);

  mended_ = false;
  corners_.resize(edges_.size());
  for (std::size_t i = 0; i < edges_.size(); ++i) set_corner(i);
}

void OffsetInput::load_ring(const Ring& ring) {
  const std::size_t first = edges_.size();
  if (ring.size() < 3) return;
  Point previous = ring.back();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point here = ring[i];
    if (!is_straight(previous, here, i + 1 < ring.size() ? ring[i + 1] : ring[0])) {
      OffsetEdge edge{};
      edge.x = static_cast<double>(here.x - origin_x_);
      edge.y = mirror_ * static_cast<double>(here.y - origin_y_);
      edges_.push_back(edge);
    }
    previous = here;
  }
  const std::size_t end = edges_.size();
  for (std::size_t i = first; i < end; ++i) {
    const std::size_t next = i + 1 < end ? i + 1 : first;
    OffsetEdge& edge = edges_[i];
    edge.dx = edges_[next].x - edge.x;
    edge.dy = edges_[next].y - edge.y;
    edge.length = std::sqrt(edge.dx * edge.dx + edge.dy * edge.dy);
    edge.inverse_length = 1 / edge.length;
    edge.end_corner = edge.next = static_cast<std::int32_t>(next);
    edge.previous = static_cast<std::int32_t>(i > first ? i - 1 : end - 1);
  }
}

void OffsetInput::set_corner(std::size_t index) {
  const OffsetEdge& g = edges_[index];
  const OffsetEdge& e = edges_[static_cast<std::size_t>(g.previous)];
  const double scale = e.inverse_length * g.inverse_length;
  const double cross = cross_of(e, g), dot = dot_of(e, g);
  const double sine = std::abs(cross) * scale, cosine = dot * scale;
  OffsetCorner& corner = corners_[index];
  // Two forms, so that neither small turns nor needles lose digits.
  corner.half_tangent = cosine > 0 ? sine / (1 + cosine) : (1 - cosine) / sine;
  corner.owner = static_cast<std::int32_t>(index);
  corner.reflex = cross < 0 || (cross == 0 && dot < 0);
}

OffsetArc OffsetInput::arc(std::int32_t corner) const {
  const OffsetEdge& g = edges_[static_cast<std::size_t>(corner)];
  const OffsetEdge& e = edges_[static_cast<std::size_t>(g.previous)];
  const double ex = e.dx * e.inverse_length, ey = e.dy * e.inverse_length;
  const double gx = g.dx * g.inverse_length, gy = g.dy * g.inverse_length;
  const double half = corners_[static_cast<std::size_t>(corner)].half_tangent;
  const bool flat = half < 1;
  const double x = flat ? -ey - gy : ex - gx, y = flat ? ex + gx : ey - gy;
  const double scale = 1 / std::sqrt(x * x + y * y);
  const double quarter = flat ? half / (1 + std::sqrt(1 + half * half))
                              : 1 / (1 / half + std::sqrt(1 + 1 / (half * half)));
  return {x * scale, y * scale, quarter};
}

void OffsetInput::mend_touching() {
  by_point_.resize(edges_.size());
  for (std::size_t i = 0; i < edges_.size(); ++i) by_point_[i] = static_cast<std::int32_t>(i);
  const auto at = [this](std::int32_t i) -> const OffsetEdge& {
    return edges_[static_cast<std::size_t>(i)];
  };
  std::sort(by_point_.begin(), by_point_.end(), [&](std::int32_t a, std::int32_t b) {
    if (at(a).x != at(b).x) return at(a).x < at(b).x;
    return at(a).y != at(b).y ? at(a).y < at(b).y : a < b;
  });
  for (std::size_t first = 0; first < by_point_.size();) {
    std::size_t last = first + 1;
    while (last < by_point_.size() && at(by_point_[last]).x == at(by_point_[first]).x &&
           at(by_point_[last]).y == at(by_point_[first]).y) {
      ++last;
    }
    if (last - first > 1) mend_point(first, last);
    first = last;
  }
  mended_ = true;
}

// Corners by_point_[first … last) lie at one point. Sorts the rays that leave it by angle; the
// inside of an arriving edge is clockwise of its ray, up to the next ray, which must be leaving.
void OffsetInput::mend_point(std::size_t first, std::size_t last) {
  // Rays: edge i leaving is 2i, edge i arriving is 2i + 1.
  around_.clear();
  for (std::size_t i = first; i < last; ++i) {
    around_.push_back(2 * by_point_[i]);
    around_.push_back(2 * edges_[static_cast<std::size_t>(by_point_[i])].previous + 1);
  }
  const auto ray = [this](std::int32_t id) {
    const OffsetEdge& edge = edges_[static_cast<std::size_t>(id / 2)];
    const double sign = id % 2 == 0 ? 1 : -1;
    return std::pair{sign * edge.dx, sign * edge.dy};
  };
  const auto upper = [](std::pair<double, double> d) {
    return d.second > 0 || (d.second == 0 && d.first > 0);
  };
  std::sort(around_.begin(), around_.end(), [&](std::int32_t a, std::int32_t b) {
    const auto p = ray(a), q = ray(b);
    if (upper(p) != upper(q)) return upper(p);
    const double turn = exact_cross<true>(p.first, p.second, q.first, q.second);
    return turn != 0 ? turn > 0 : a < b;
  });
  std::int32_t owner = -1;
  for (std::size_t i = 0; i < around_.size(); ++i) {
    if (around_[i] % 2 == 0) continue;
    const std::int32_t leaving = around_[i == 0 ? around_.size() - 1 : i - 1];
    if (leaving % 2 != 0) continue;  // not a clean region: this corner stays as it was
    const std::int32_t e = around_[i] / 2, g = leaving / 2;
    edges_[static_cast<std::size_t>(e)].next = g;
    edges_[static_cast<std::size_t>(g)].previous = e;
    set_corner(static_cast<std::size_t>(g));
    if (corners_[static_cast<std::size_t>(g)].reflex) owner = g;
  }
  if (owner < 0) return;
  for (std::size_t i = first; i < last; ++i) {
    corners_[static_cast<std::size_t>(by_point_[i])].owner = owner;
  }
}

Point OffsetInput::to_grid(double x, double y) const {
  const double across = mirror_ * y;
  return {
      static_cast<std::int32_t>(static_cast<std::int64_t>(x + (x < 0 ? -0.5 : 0.5)) + origin_x_),
      static_cast<std::int32_t>(static_cast<std::int64_t>(across + (across < 0 ? -0.5 : 0.5)) +
                                origin_y_)};
}

}  // namespace core
