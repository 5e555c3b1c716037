// What one edge cuts from an offset element, at any depth: what is common to all depths is
// computed once.
//
// Each other edge f cuts one interval out of an element, because its capsule (all points nearer
// than d) is convex. The ends of the interval are known in closed form. For the line at height d
// over edge a:
//
//   the line of f: let O be where the lines of a and f meet, t0 and τ0 the coordinates of O along a
//   and f, and θ the angle from a to f. The offset lines meet at t0 − d·tan(θ/2) on a and
//   τ0 + d·tan(θ/2) on f. The line on f's other side is met at t0 + d·cot(θ/2), τ0 + d·cot(θ/2).
//
//   an end of f: where that foot τ lies beyond f's end q, the circle about q counts. It is met at
//   s ± sqrt(h·(2d − h)), with s along a and h above a the coordinates of q. If h <= 0, q is behind
//   the line and never reaches it.
//
// For the arc about v, with c the height of v over f's line: the feet are ± sqrt(c·(2d − c)) from
// the foot of v. Where they lie beyond f's end q, the circles about v and q meet.
//
// t0, τ0, s, h and c are computed from exact integer crosses and dots, and rounded once: whether
// corners are convex, edges parallel or points on a line is decided right. Both elements that meet
// at an end compute it from the same numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/offsets/offset_input.h"  // OffsetEdge, OffsetArc, exact_cross, exact_dot
#include "core/offsets/offset_span.h"   // OffsetSpan, OffsetEnd, OffsetSite

namespace core {

// Farther along than any arc reaches.
inline constexpr double kFarAlong = 1e300;

// The sites of an edge: itself, and the corners at its ends.
struct EdgeSites {
  OffsetSite edge, start, end;
};

// An end of an edge, seen from another: along that one, and above it.
struct EndBeside {
  double along, above;
};

template <bool kWide>
EndBeside beside(const OffsetEdge& e, double x, double y) {
  return {exact_dot<kWide>(e.dx, e.dy, x - e.x, y - e.y) * e.inverse_length,
          exact_cross<kWide>(e.dx, e.dy, x - e.x, y - e.y) * e.inverse_length};
}

// Cuts in the order in which they were found. Grows to what it needed most and stays.
template <typename Cut>
class OffsetCuts {
 public:
  void clear() { count_ = 0; }
  // To be set, and then kept or not.
  [[nodiscard]] Cut& next() {
    if (count_ == cuts_.size()) cuts_.resize(2 * count_ + 16);
    return cuts_[count_];
  }
  void keep() { ++count_; }
  [[nodiscard]] std::span<const Cut> all() const { return std::span(cuts_).first(count_); }

 private:
  std::vector<Cut> cuts_;
  std::size_t count_ = 0;
};

// What the edge f cuts from the line over the edge e.
class LineCut {
 public:
  // `start`, `end`: f's ends beside e.
  template <bool kWide>
  void set(const OffsetEdge& e, const OffsetEdge& f, EndBeside start, EndBeside end,
           EdgeSites sites) {
    start_ = start;
    end_ = end;
    sites_ = sites;
    const double turn = exact_cross<kWide>(e.dx, e.dy, f.dx, f.dy);
    const double scale = e.inverse_length * f.inverse_length;
    const double cosine = exact_dot<kWide>(e.dx, e.dy, f.dx, f.dy) * scale, sine = turn * scale;
    length_ = f.length;
    turn_ = turn;
    same_way_ = cosine > 0;
    if (turn == 0) return;
    const double px = f.x - e.x, py = f.y - e.y;
    meeting_ = exact_cross<kWide>(px, py, f.dx, f.dy) / turn * e.length;
    meeting_on_f_ = -exact_cross<kWide>(e.dx, e.dy, px, py) / turn * f.length;
    tangent_ = cosine > 0 ? sine / (1 + cosine) : (1 - cosine) / sine;
    cotangent_ = cosine > 0 ? (1 + cosine) / sine : sine / (1 - cosine);
  }

  [[nodiscard]] std::int32_t edge() const { return sites_.edge / 2; }

  void apply(double depth, OffsetSpan& span) const {
    if (start_.above >= 2 * depth && end_.above >= 2 * depth) return;
    if (start_.above <= 0 && end_.above <= 0) return;
    if (turn_ == 0) {
      span.remove(circle(depth, !same_way_, -1), circle(depth, same_way_, 1));
      return;
    }
    const double tangent = depth * tangent_, cotangent = depth * cotangent_;
    const double side = turn_ < 0 ? 1 : -1;
    const OffsetEnd inner = meeting(depth, meeting_on_f_ + tangent, meeting_ - tangent, side);
    const OffsetEnd outer = meeting(depth, meeting_on_f_ + cotangent, meeting_ + cotangent, -side);
    span.remove(turn_ < 0 ? outer : inner, turn_ < 0 ? inner : outer);
  }

 private:
  // Where the circle about f's start or end meets the line.
  [[nodiscard]] OffsetEnd circle(double depth, bool at_end, double sign) const {
    const EndBeside& q = at_end ? end_ : start_;
    return {q.along + sign * std::sqrt(std::max(0.0, q.above * (2 * depth - q.above))),
            at_end ? sites_.end : sites_.start};
  }
  [[nodiscard]] OffsetEnd meeting(double depth, double foot, double at, double sign) const {
    if (foot < 0) return circle(depth, false, sign);
    if (foot > length_) return circle(depth, true, sign);
    return {at, sites_.edge};
  }

  EndBeside start_{}, end_{};
  EdgeSites sites_{};
  double length_ = 0;
  double turn_ = 0;  // to the left: above 0
  double meeting_ = 0, meeting_on_f_ = 0;
  double tangent_ = 0, cotangent_ = 0;  // of half the angle
  bool same_way_ = false;
};

// What the edge f cuts from the arc about a corner v.
class ArcCut {
 public:
  // False if it cuts nothing down to `deepest`. REQUIRES: v is no end of f.
  template <bool kWide>
  bool set(double vx, double vy, const OffsetEdge& f, double deepest) {
    px_ = f.x - vx;
    py_ = f.y - vy;
    const double rise = exact_cross<kWide>(px_, py_, f.dx, f.dy);
    height_ = rise * f.inverse_length;
    if (std::abs(height_) >= 2 * deepest) return false;
    qx_ = px_ + f.dx;
    qy_ = py_ + f.dy;
    foot_ = -exact_dot<kWide>(f.dx, f.dy, px_, py_) * f.inverse_length;
    length_ = f.length;
    p_squared_ = px_ * px_ + py_ * py_;
    q_squared_ = qx_ * qx_ + qy_ * qy_;
    if (beyond(2 * deepest)) return false;
    left_ = rise > 0;
    on_f_ = rise == 0 && foot_ > 0 && foot_ < f.length;
    fx_ = f.dx * f.inverse_length;
    fy_ = f.dy * f.inverse_length;
    return true;
  }
  void set_sites(EdgeSites sites) { sites_ = sites; }

  [[nodiscard]] std::int32_t edge() const { return sites_.edge / 2; }

  void apply(double depth, const OffsetArc& arc, OffsetSpan& span) const {
    const double reach = 2 * depth, above = std::abs(height_);
    if (above >= reach) return;
    if (beyond(reach)) return;
    if (on_f_) {
      span.remove({-kFarAlong, sites_.edge}, {kFarAlong, sites_.edge});
      return;
    }
    const double half_chord = std::sqrt(above * (reach - above));
    const double left = left_ ? half_chord : -half_chord;
    // In clockwise order; the covered arc may go round the back.
    const OffsetEnd from = end(depth, arc, left, 1), to = end(depth, arc, -left, -1);
    if (from.at <= to.at) {
      span.remove(from, to);
    } else {
      span.remove({-kFarAlong, from.site}, to);
      span.remove(from, {kFarAlong, to.site});
    }
  }

 private:
  // The end of f that is nearest to v is so far away.
  [[nodiscard]] bool beyond(double reach) const {
    return foot_ <= 0 ? p_squared_ >= reach * reach
                      : foot_ >= length_ && q_squared_ >= reach * reach;
  }
  // tan(angle / 2) of the point (x, y), its angle counted from the arc's middle.
  static double parameter(double depth, const OffsetArc& arc, double x, double y) {
    const double right = x * arc.middle_y - y * arc.middle_x;
    const double up = x * arc.middle_x + y * arc.middle_y;
    if (up > 0) return right / (depth + up);
    return right != 0 ? (depth - up) / right : kFarAlong;
  }
  // The end of the covered arc to the left (sign 1) or right (-1) as seen from v, about the foot
  // on f or about f's end.
  [[nodiscard]] OffsetEnd end(double depth, const OffsetArc& arc, double along, double sign) const {
    const double foot = foot_ + along;
    if (foot >= 0 && foot <= length_) {
      const double up = (left_ ? depth : -depth) - height_;
      return {parameter(depth, arc, fx_ * along - fy_ * up, fy_ * along + fx_ * up), sites_.edge};
    }
    const bool at_end = foot > length_;
    const double x = at_end ? qx_ : px_, y = at_end ? qy_ : py_;
    const double squared = at_end ? q_squared_ : p_squared_;
    const double across = sign * std::sqrt(std::max(0.0, depth * depth / squared - 0.25));
    return {parameter(depth, arc, x / 2 - y * across, y / 2 + x * across),
            at_end ? sites_.end : sites_.start};
  }

  EdgeSites sites_{};
  double px_ = 0, py_ = 0, qx_ = 0, qy_ = 0;  // f's ends, seen from v
  double p_squared_ = 0, q_squared_ = 0;
  double height_ = 0, foot_ = 0, length_ = 0;  // of v over f; v's foot on f; f's
  double fx_ = 0, fy_ = 0;                     // along f
  bool left_ = false;                          // f turns counter-clockwise about v
  bool on_f_ = false;                          // v lies on f
};

}  // namespace core
