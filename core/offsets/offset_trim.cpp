#include "core/offsets/offset_trim.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

// Ends nearer than this may be one place (offset_span.h); rounding stays below 1e-9 for lengths
// below 10^6 units and grows with them.
double tolerance_of(double length) { return 1e-7 + 1e-12 * length; }

// How far a point may lie beyond a capsule's rim and still be handed to the closed form.
constexpr double kRim = 1e-6;

constexpr double kFar = 1e300;

// tan(angle / 2) of the point (x, y), its angle counted from y to x, for x² + y² = radius².
double half_tangent(double x, double y, double radius) {
  if (y > 0) return x / (radius + y);
  return x != 0 ? (radius - y) / x : kFar;
}

}  // namespace

void OffsetTrim::start(const OffsetInput& contours) {
  covered_.assign(2 * contours.edges().size(), 0);
}

bool OffsetTrim::trim(const OffsetInput& contours, const OffsetSearch& search, double depth) {
  contours_ = &contours;
  edges_ = &contours.edges();
  corners_ = &contours.corners();
  search_ = &search;
  depth_ = depth;
  last_coverer_ = -1;
  pieces_.clear();
  first_.resize(2 * edges_->size() + 1);
  return contours.wide() ? trim_all<true>() : trim_all<false>();
}

template <bool kWide>
bool OffsetTrim::trim_all() {
  for (std::size_t c = 0; c < search_->chunks().size(); ++c) {
    const OffsetChunk& chunk = search_->chunks()[c];
    const auto near = search_->neighbours(c);
    for (std::int32_t i = chunk.first; i < chunk.last; ++i) {
      const auto element = 2 * static_cast<std::size_t>(i);
      first_[element] = pieces_.count();
      if (covered_[element] == 0) {
        trim_line<kWide>(i, near);
        if (first_[element] == pieces_.count()) covered_[element] = 1;
      }
      first_[element + 1] = pieces_.count();
      if (covered_[element + 1] == 0) {
        if (corner(i).reflex && !trim_arc<kWide>(i, near)) return false;
        if (first_[element + 1] == pieces_.count()) covered_[element + 1] = 1;
      }
    }
  }
  first_.back() = pieces_.count();
  return true;
}

template <bool kWide>
void OffsetTrim::trim_line(std::int32_t index, std::span<const std::int32_t> near) {
  const OffsetEdge& e = edge(index);
  const Frame a{e.x, e.y, e.dx * e.inverse_length, e.dy * e.inverse_length, index};
  const OffsetSite before = corner(index).reflex ? 2 * index + 1 : 2 * e.previous;
  const OffsetSite after = corner(e.next).reflex ? 2 * e.next + 1 : 2 * e.next;
  // Within a run the cuts at convex corners are known to hold.
  double from = 0, to = e.length;
  const bool start_in_run = edge(e.previous).run == e.run, end_in_run = edge(e.next).run == e.run;
  if (start_in_run && !corner(index).reflex) from = depth_ * corner(index).half_tangent;
  if (end_in_run && !corner(e.next).reflex) to -= depth_ * corner(e.next).half_tangent;
  if (near.empty()) {
    pieces_.add({from, before, after, 2 * index, -1});
    return;
  }
  span_.reset({from, before}, {to, after}, tolerance_of(e.length + depth_));
  if (last_coverer_ >= 0 && last_coverer_ != index) cut_line<kWide>(a, last_coverer_);
  if (!start_in_run && !corner(index).reflex) cut_line<kWide>(a, e.previous);
  if (!end_in_run && !corner(e.next).reflex) cut_line<kWide>(a, e.next);
  const double reach_squared = (depth_ + 1) * (depth_ + 1);
  double lo = 0, hi = -1;
  OffsetBox box{};
  for (const std::int32_t c : near) {
    if (span_.dead()) return;
    const OffsetChunk& chunk = search_->chunks()[static_cast<std::size_t>(c)];
    if (chunk.run >= 0 && chunk.run == e.run) continue;
    if (lo != span_.lo() || hi != span_.hi()) {
      lo = span_.lo();
      hi = span_.hi();
      const double x = a.x - a.uy * depth_, y = a.y + a.ux * depth_;
      box = {x + a.ux * lo, y + a.uy * lo, x + a.ux * lo, y + a.uy * lo};
      box.add(x + a.ux * hi, y + a.uy * hi);
    }
    if (box.distance_squared(chunk.box) <= reach_squared) cut_line_by_chunk<kWide>(a, chunk);
  }
  if (!span_.dead()) span_.pieces(2 * index, pieces_);
}

// Hands on the chunk's edges that may reach what is left of the line.
template <bool kWide>
void OffsetTrim::cut_line_by_chunk(const Frame& a, const OffsetChunk& chunk) {
  const double d = depth_, rim = (d + kRim) * (d + kRim);
  const OffsetEdge& e = edge(a.index);
  const OffsetEdge* f = &edge(chunk.first);
  double s = exact_dot<kWide>(e.dx, e.dy, f->x - a.x, f->y - a.y) * e.inverse_length;
  double h = exact_cross<kWide>(e.dx, e.dy, f->x - a.x, f->y - a.y) * e.inverse_length;
  for (std::int32_t i = chunk.first; i < chunk.last; ++i, ++f) {
    const double s1 = s, h1 = h;
    const double qx = f->x + f->dx - a.x, qy = f->y + f->dy - a.y;
    s = exact_dot<kWide>(e.dx, e.dy, qx, qy) * e.inverse_length;
    h = exact_cross<kWide>(e.dx, e.dy, qx, qy) * e.inverse_length;
    if ((h1 <= 0 && h <= 0) || (h1 >= 2 * d && h >= 2 * d)) continue;
    if (i == a.index || i == e.previous || i == e.next) continue;  // cut already
    const bool beyond_hi = s1 >= span_.hi() && s >= span_.hi();
    if (beyond_hi || (s1 <= span_.lo() && s <= span_.lo())) {
      // It reaches the window only if it covers the window's end.
      const double vx = (beyond_hi ? span_.hi() : span_.lo()) - s1, vy = d - h1;
      const double gx = s - s1, gy = h - h1;
      const double foot = vx * gx + vy * gy, length_squared = gx * gx + gy * gy;
      double distance_squared = vx * vx + vy * vy;
      if (foot >= length_squared) {
        distance_squared = (vx - gx) * (vx - gx) + (vy - gy) * (vy - gy);
      } else if (foot > 0) {
        const double across = vx * gy - vy * gx;
        if (across * across >= rim * length_squared) continue;
        distance_squared = 0;
      }
      if (distance_squared >= rim) continue;
    }
    cut_line<kWide>(a, i);
    if (span_.dead()) return;
  }
}

template <bool kWide>
void OffsetTrim::cut_line(const Frame& a, std::int32_t other) {
  const OffsetEdge& e = edge(a.index);
  const OffsetEdge& f = edge(other);
  const double d = depth_;
  const double px = f.x - e.x, py = f.y - e.y, qx = px + f.dx, qy = py + f.dy;
  const double rise = exact_cross<kWide>(e.dx, e.dy, px, py);
  const double h1 = rise * e.inverse_length;
  const double h2 = exact_cross<kWide>(e.dx, e.dy, qx, qy) * e.inverse_length;
  if ((h1 <= 0 && h2 <= 0) || (h1 >= 2 * d && h2 >= 2 * d)) return;
  const double turn = exact_cross<kWide>(e.dx, e.dy, f.dx, f.dy);
  const double scale = e.inverse_length * f.inverse_length;
  const double cosine = exact_dot<kWide>(e.dx, e.dy, f.dx, f.dy) * scale, sine = turn * scale;

  // Where the circle about f's start or end meets the line.
  const auto circle = [&](bool at_end, double sign) -> OffsetEnd {
    const double h = at_end ? h2 : h1;
    const double s =
        exact_dot<kWide>(e.dx, e.dy, at_end ? qx : px, at_end ? qy : py) * e.inverse_length;
    return {s + sign * std::sqrt(std::max(0.0, h * (2 * d - h))),
            corner_site(at_end ? f.end_corner : other)};
  };
  if (turn == 0) {
    span_.remove(circle(cosine < 0, -1), circle(cosine > 0, 1));
  } else {
    const double t0 = exact_cross<kWide>(px, py, f.dx, f.dy) / turn * e.length;
    const double foot0 = -rise / turn * f.length;
    const double tangent = d * (cosine > 0 ? sine / (1 + cosine) : (1 - cosine) / sine);
    const double cotangent = d * (cosine > 0 ? (1 + cosine) / sine : sine / (1 - cosine));
    const auto end = [&](double foot, double at, double sign) -> OffsetEnd {
      if (foot < 0) return circle(false, sign);
      if (foot > f.length) return circle(true, sign);
      return {at, 2 * other};
    };
    const double side = turn < 0 ? 1 : -1;
    const OffsetEnd inner = end(foot0 + tangent, t0 - tangent, side);
    const OffsetEnd outer = end(foot0 + cotangent, t0 + cotangent, -side);
    span_.remove(turn < 0 ? outer : inner, turn < 0 ? inner : outer);
  }
  if (span_.dead()) last_coverer_ = other;
}

template <bool kWide>
bool OffsetTrim::trim_arc(std::int32_t index, std::span<const std::int32_t> near) {
  const OffsetEdge& g = edge(index);
  if (near.empty()) {
    pieces_.add({-1, 2 * g.previous, 2 * index, 2 * index + 1, -1});
    return true;
  }
  const OffsetArc arc = contours_->arc(index);
  const Frame v{g.x, g.y, arc.middle_x, arc.middle_y, index};
  const double k = arc.quarter_tangent;
  span_.reset({-k, 2 * g.previous}, {k, 2 * index}, tolerance_of(depth_) / (2 * depth_));
  if (last_coverer_ >= 0 && last_coverer_ != index && last_coverer_ != g.previous &&
      !cut_arc<kWide>(v, last_coverer_)) {
    return false;
  }
  // The arc's box: its ends and how far it bulges over their chord.
  const OffsetEdge& e = edge(g.previous);
  const double bulge = 1 + depth_ * 2 * k * k / (1 + k * k);
  const double ex = v.x - e.dy * e.inverse_length * depth_;
  const double ey = v.y + e.dx * e.inverse_length * depth_;
  OffsetBox box{ex, ey, ex, ey};
  box.add(v.x - g.dy * g.inverse_length * depth_, v.y + g.dx * g.inverse_length * depth_);
  const double reach_squared = (depth_ + bulge) * (depth_ + bulge);
  const bool inside_run = g.run == e.run;
  for (const std::int32_t c : near) {
    if (span_.dead()) return true;
    const OffsetChunk& chunk = search_->chunks()[static_cast<std::size_t>(c)];
    if (inside_run && chunk.run == g.run) continue;
    if (box.distance_squared(chunk.box) > reach_squared) continue;
    if (!cut_arc_by_chunk<kWide>(v, chunk)) return false;
  }
  if (!span_.dead()) span_.pieces(2 * index + 1, pieces_);
  return true;
}

// Leaves out the chunk's edges that lie behind the arc: below both tangents' normals.
template <bool kWide>
bool OffsetTrim::cut_arc_by_chunk(const Frame& v, const OffsetChunk& chunk) {
  const OffsetEdge& g = edge(v.index);
  const OffsetEdge& e = edge(g.previous);
  const OffsetEdge* f = &edge(chunk.first);
  double x = f->x - v.x, y = f->y - v.y;
  bool ahead = exact_cross<kWide>(e.dx, e.dy, x, y) > 0 || exact_cross<kWide>(g.dx, g.dy, x, y) > 0;
  const double reach = 2 * depth_;
  for (std::int32_t i = chunk.first; i < chunk.last; ++i, ++f) {
    const bool start_ahead = ahead;
    const double x1 = x, y1 = y;
    x = f->x + f->dx - v.x;
    y = f->y + f->dy - v.y;
    ahead = exact_cross<kWide>(e.dx, e.dy, x, y) > 0 || exact_cross<kWide>(g.dx, g.dy, x, y) > 0;
    const bool here = (x == 0 && y == 0) || (x1 == 0 && y1 == 0);
    if ((!start_ahead && !ahead && !here) || i == v.index || i == g.previous) continue;
    if ((x > reach && x1 > reach) || (x < -reach && x1 < -reach) || (y > reach && y1 > reach) ||
        (y < -reach && y1 < -reach)) {
      continue;
    }
    if (!cut_arc<kWide>(v, i)) return false;
    if (span_.dead()) return true;
  }
  return true;
}

template <bool kWide>
bool OffsetTrim::cut_arc(const Frame& v, std::int32_t other) {
  const OffsetEdge& f = edge(other);
  const double d = depth_;
  const double px = f.x - v.x, py = f.y - v.y, qx = px + f.dx, qy = py + f.dy;
  if ((px == 0 && py == 0) || (qx == 0 && qy == 0))
    return contours_->mended();  // at a wedge: never nearer
  const double rise = exact_cross<kWide>(px, py, f.dx, f.dy);
  const double height = rise * f.inverse_length, above = std::abs(height);
  if (above >= 2 * d) return true;
  const double own_foot = -exact_dot<kWide>(f.dx, f.dy, px, py) * f.inverse_length;
  const double p_squared = px * px + py * py, q_squared = qx * qx + qy * qy;
  if (own_foot <= 0 ? p_squared >= 4 * d * d : own_foot >= f.length && q_squared >= 4 * d * d) {
    return true;
  }
  if (rise == 0 && own_foot > 0 && own_foot < f.length) {  // the corner lies on f
    span_.remove({-kFar, 2 * other}, {kFar, 2 * other});
    last_coverer_ = other;
    return true;
  }
  const auto parameter = [&](double x, double y) {
    return half_tangent(x * v.uy - y * v.ux, x * v.ux + y * v.uy, d);
  };
  const double half_chord = std::sqrt(above * (2 * d - above));
  const double fx = f.dx * f.inverse_length, fy = f.dy * f.inverse_length;
  // The end of the covered arc to the left (sign 1) or right (-1) as seen from v, about the foot
  // on f or about f's end.
  const auto end = [&](double along, double sign) -> OffsetEnd {
    const double foot = own_foot + along;
    if (foot >= 0 && foot <= f.length) {
      const double up = (rise > 0 ? d : -d) - height;
      return {parameter(fx * along - fy * up, fy * along + fx * up), 2 * other};
    }
    const bool at_end = foot > f.length;
    const double x = at_end ? qx : px, y = at_end ? qy : py;
    const double across =
        sign * std::sqrt(std::max(0.0, d * d / (at_end ? q_squared : p_squared) - 0.25));
    return {parameter(x / 2 - y * across, y / 2 + x * across),
            corner_site(at_end ? f.end_corner : other)};
  };
  const double left = rise > 0 ? half_chord : -half_chord;
  remove_from_arc(end(left, 1), end(-left, -1));
  if (span_.dead()) last_coverer_ = other;
  return true;
}

// Ends in clockwise order; the covered arc may go round the back.
void OffsetTrim::remove_from_arc(OffsetEnd from, OffsetEnd to) {
  if (from.at <= to.at) {
    span_.remove(from, to);
  } else {
    span_.remove({-kFar, from.site}, to);
    span_.remove(from, {kFar, to.site});
  }
}

}  // namespace core
