// What is left of one offset element while capsules are cut from it.
//
// An element is an interval of its parameter. Every other edge removes the open interval that its
// capsule (all points nearer than the depth) covers; each end of an interval is named by the site
// that makes it, an edge or a corner, because contours are linked by those names.
//
//      lo                                        hi       the window: nothing is left beyond it
//      ├──────────(gap a)─────(gap  b)───────────┤        gaps: intervals that touch neither end
//
// An edge and a corner at its end touch smoothly, so where the one takes over from the other their
// ends agree to second order. The edge says (to first order, by where the foot of the point lies)
// whether the end is still its own: when both name the same place, the edge is right.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

// Edge i is site 2i, the corner where it begins is site 2i + 1. An edge's offset line and a reflex
// corner's arc carry the same numbers as elements.
using FootSite = std::int32_t;

struct FootEnd {
  double at;
  FootSite site;
};

struct FootPiece {
  double from;
  FootSite from_site, to_site;
  FootSite element;
  std::int32_t next;  // the piece that goes on where this one ends
};

// Pieces in the order they were found. Grows to what it needed most and stays.
class FootPieces {
 public:
  void clear() { count_ = 0; }
  void add(const FootPiece& piece) {
    if (count_ == pieces_.size()) pieces_.resize(2 * count_ + 64);
    pieces_[count_++] = piece;
  }
  [[nodiscard]] std::int32_t count() const { return static_cast<std::int32_t>(count_); }
  [[nodiscard]] std::span<FootPiece> all() { return std::span(pieces_).first(count_); }

 private:
  std::vector<FootPiece> pieces_;
  std::size_t count_ = 0;
};

class FootSpan {
 public:
  // `tolerance`: ends of an edge and a corner nearer than this are taken for one place.
  void reset(FootEnd lo, FootEnd hi, double tolerance) {
    lo_ = lo;
    hi_ = hi;
    natural_lo_ = lo.at;
    natural_hi_ = hi.at;
    tolerance_ = tolerance;
    gaps_.clear();
  }

  [[nodiscard]] double lo() const { return lo_.at; }
  [[nodiscard]] double hi() const { return hi_.at; }
  [[nodiscard]] bool dead() const { return !(lo_.at < hi_.at); }

  // Removes from `from` to `to`.
  void remove(FootEnd from, FootEnd to) {
    if (!(from.at < to.at) || to.at < lo_.at - tolerance_ || from.at > hi_.at + tolerance_) return;
    const bool at_lo = from.at <= lo_.at, at_hi = to.at >= hi_.at;
    if (at_lo && farther(to.at - lo_.at, to.site, lo_, natural_lo_)) lo_ = to;
    if (at_hi && farther(hi_.at - from.at, from.site, hi_, natural_hi_)) hi_ = from;
    if (!at_lo && !at_hi) gaps_.push_back({from, to});
  }

  // Appends what is left as pieces, in order. REQUIRES: !dead().
  void pieces(FootSite element, FootPieces& out) {
    if (!gaps_.empty()) split_by_gaps(element, out);
    if (!dead()) out.add({lo_.at, lo_.site, hi_.site, element, -1});
  }

 private:
  struct Gap {
    FootEnd from, to;
  };

  static bool is_edge(FootSite site) { return site % 2 == 0; }

  // Whether an end that lies `by` farther in replaces `old`.
  [[nodiscard]] bool farther(double by, FootSite site, const FootEnd& old, double natural) const {
    if (by > tolerance_ || old.at == natural || is_edge(site) == is_edge(old.site)) return by > 0;
    return is_edge(site) && by > -tolerance_;
  }

  void split_by_gaps(FootSite element, FootPieces& out) {
    std::sort(gaps_.begin(), gaps_.end(),
              [](const Gap& a, const Gap& b) { return a.from.at < b.from.at; });
    for (std::size_t i = 0; i < gaps_.size();) {
      // One hole of overlapping gaps.
      Gap hole = gaps_[i++];
      for (;
           i < gaps_.size() && gaps_[i].from.at <= std::max(hole.to.at, hole.from.at + tolerance_);
           ++i) {
        if (gaps_[i].from.at < hole.from.at + tolerance_ && is_edge(gaps_[i].from.site) &&
            !is_edge(hole.from.site)) {
          hole.from = gaps_[i].from;
        }
        if (farther(gaps_[i].to.at - hole.to.at, gaps_[i].to.site, hole.to, hole.to.at + 1)) {
          hole.to = gaps_[i].to;
        }
      }
      if (hole.from.at <= lo_.at) {
        if (farther(hole.to.at - lo_.at, hole.to.site, lo_, natural_lo_)) lo_ = hole.to;
      } else if (hole.to.at >= hi_.at) {
        if (farther(hi_.at - hole.from.at, hole.from.site, hi_, natural_hi_)) hi_ = hole.from;
        return;
      } else {
        out.add({lo_.at, lo_.site, hole.from.site, element, -1});
        lo_ = hole.to;
      }
    }
  }

  FootEnd lo_{}, hi_{};
  double natural_lo_ = 0, natural_hi_ = 0, tolerance_ = 0;
  std::vector<Gap> gaps_;
};

}  // namespace core
