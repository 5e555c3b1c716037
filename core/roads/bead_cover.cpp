#include "core/roads/bead_cover.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/booleans/boolean.h"  // clean
#include "core/rounded.h"           // rounded
#include "core/trigonometry.h"      // arc_tangent, cosine, sine
#include "core/vector.h"            // Vector, dot, cross, left_of

namespace core {

namespace {

// Turns sharper than this (about 18°) are rounded on the outer side.
constexpr double kTurnCosine = 0.95;

// One corner of the round side for each such part of a turn.
constexpr double kRoundPart = std::numbers::pi / 4;

Point moved(Point p, Vector d, double by) {
  return {rounded(p.x + d.x * by), rounded(p.y + d.y * by)};
}

// Where one piece of road ends and the next one starts.
struct Corner {
  Vector in;
  Vector out;

  [[nodiscard]] bool sharp() const { return dot(in, out) < kTurnCosine; }
  [[nodiscard]] bool to_the_left() const { return cross(in, out) > 0; }
  // To the left mitre point of a bead of half width 1.
  [[nodiscard]] Vector mitre() const {
    const double share = 1 / (1 + dot(in, out));
    return {-(in.y + out.y) * share, (in.x + out.x) * share};
  }
  // How much shorter the pieces' inner sides are, for a half width of 1: tan of half the turn. From
  // 90° on the sides cross, which takes as much.
  [[nodiscard]] double inner_cut() const {
    return dot(in, out) <= 0 ? 1 : std::abs(cross(in, out)) / (1 + dot(in, out));
  }
};

class BeadOutline {
 public:
  BeadOutline(const Road& road, double half, std::vector<Ring>& outlines)
      : half_(half), outlines_(outlines) {
    for (const Point p : road.points) {
      if (points_.empty() || points_.back() != p) points_.push_back(p);
    }
    if (road.closed && points_.size() > 1 && points_.back() == points_.front()) points_.pop_back();
    closed_ = road.closed && points_.size() > 2;
    pieces_ = closed_ ? points_.size() : std::max<std::size_t>(points_.size(), 1) - 1;
    for (std::size_t i = 0; i < pieces_; ++i) {
      const Point a = points_[i], b = to(i);
      const double dx = static_cast<double>(b.x) - a.x, dy = static_cast<double>(b.y) - a.y;
      lengths_.push_back(std::sqrt(dx * dx + dy * dy));
      along_.push_back({dx / lengths_.back(), dy / lengths_.back()});
    }
  }

  void add() {
    for (std::size_t i = 0; i < pieces_; ++i) {
      if (inverted(i)) {
        add_alone(i);
        continue;
      }
      if (right_.empty()) start(i);
      if (i + 1 < pieces_ && !inverted(i + 1)) {
        go_round({along_[i], along_[i + 1]}, to(i));
      } else {
        end(i);
      }
    }
  }

 private:
  [[nodiscard]] Point to(std::size_t piece) const {
    return points_[piece + 1 < points_.size() ? piece + 1 : 0];
  }
  [[nodiscard]] std::size_t before(std::size_t piece) const {
    return piece > 0 ? piece - 1 : pieces_ - 1;
  }
  [[nodiscard]] std::size_t after(std::size_t piece) const {
    return piece + 1 < pieces_ ? piece + 1 : 0;
  }

  // Whether the turns at its ends take more of one side than the piece is long.
  [[nodiscard]] bool inverted(std::size_t piece) const {
    double left = 0, right = 0;
    const auto take = [&](const Corner& corner) {
      (corner.to_the_left() ? left : right) += half_ * corner.inner_cut();
    };
    if (closed_ || piece > 0) take({along_[before(piece)], along_[piece]});
    if (closed_ || piece + 1 < pieces_) take({along_[piece], along_[after(piece)]});
    return std::max(left, right) > lengths_[piece];
  }

  void start(std::size_t piece) {
    const bool joins = closed_ && piece == 0 && !inverted(before(piece));
    const Corner corner{along_[before(piece)], along_[piece]};
    const Vector side = joins && !corner.sharp() ? corner.mitre() : left_of(along_[piece]);
    add_both(points_[piece], side);
  }

  // The last piece of a closed road meets the start of the first one.
  void end(std::size_t piece) {
    const bool joins = closed_ && piece + 1 == pieces_ && !inverted(0);
    const Corner corner{along_[piece], along_[after(piece)]};
    const bool mitred = joins && !corner.sharp();
    add_both(to(piece), mitred ? corner.mitre() : left_of(along_[piece]));
    if (joins && corner.sharp()) add_octagon(to(piece));
    right_.insert(right_.end(), left_.rbegin(), left_.rend());
    outlines_.push_back(std::move(right_));
    right_.clear();
    left_.clear();
  }

  void add_both(Point at, Vector left) {
    left_.push_back(moved(at, left, half_));
    right_.push_back(moved(at, left, -half_));
  }

  void go_round(const Corner& corner, Point at) {
    if (!corner.sharp()) return add_both(at, corner.mitre());
    Ring& inner = corner.to_the_left() ? left_ : right_;
    Ring& outer = corner.to_the_left() ? right_ : left_;
    const double side = corner.to_the_left() ? 1 : -1;
    if (dot(corner.in, corner.out) > 0) {
      inner.push_back(moved(at, corner.mitre(), side * half_));
    } else {
      inner.push_back(moved(at, left_of(corner.in), side * half_));
      inner.push_back(moved(at, left_of(corner.out), side * half_));
    }
    // Tangents to the circle, the sides' own lines first and last.
    const double turn =
        arc_tangent(std::abs(cross(corner.in, corner.out)), dot(corner.in, corner.out));
    const int parts = static_cast<int>(std::ceil(turn / kRoundPart));
    const double reach = half_ / cosine(turn / parts / 2);
    const Vector normal = left_of(corner.in);
    for (int i = 0; i < parts; ++i) {
      const double angle = side * (i + 0.5) * turn / parts;
      const double cosine = core::cosine(angle), sine = core::sine(angle);
      const Vector turned{normal.x * cosine - normal.y * sine, normal.x * sine + normal.y * cosine};
      outer.push_back(moved(at, turned, -side * reach));
    }
  }

  // A rectangle, and octagons over its ends.
  void add_alone(std::size_t piece) {
    const Vector left = left_of(along_[piece]);
    const Point a = points_[piece], b = to(piece);
    outlines_.push_back({moved(a, left, -half_), moved(b, left, -half_), moved(b, left, half_),
                         moved(a, left, half_)});
    if (closed_ || piece > 0) add_octagon(a);
    if (closed_ || piece + 1 < pieces_) add_octagon(b);
  }

  // Its sides, not its corners, touch the circle.
  void add_octagon(Point centre) {
    Ring ring;
    const double reach = half_ / cosine(std::numbers::pi / 8);
    for (int i = 0; i < 8; ++i) {
      const double angle = (i + 0.5) * std::numbers::pi / 4;
      ring.push_back(moved(centre, {cosine(angle), sine(angle)}, reach));
    }
    outlines_.push_back(std::move(ring));
  }

  double half_;
  std::vector<Ring>& outlines_;
  bool closed_ = false;
  std::size_t pieces_ = 0;
  std::vector<Point> points_;
  std::vector<double> lengths_;  // by piece, in units
  std::vector<Vector> along_;    // by piece
  Ring right_;                   // of the outline in work, forward
  Ring left_;                    // forward, too
};

}  // namespace

void add_bead_outlines(const Road& road, Length width, std::vector<Ring>& outlines) {
  BeadOutline(road, static_cast<double>(width.units()) / 2, outlines).add();
}

Region uncovered(const Region& region, const std::vector<Road>& roads, Length width) {
  std::vector<Ring> rings;
  for (const Road& road : roads) add_bead_outlines(road, width, rings);
  // Turned round they count against the region.
  for (Ring& ring : rings) std::reverse(ring.begin(), ring.end());
  rings.insert(rings.end(), region.rings().begin(), region.rings().end());
  return clean(rings, FillRule::kPositive);
}

}  // namespace core
