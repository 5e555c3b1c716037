// What is left of one offset element while capsules are cut from it.
//
// An element is an interval of its parameter. Every other edge removes the open interval that its
// capsule (all points nearer than the depth) covers. Each end of an interval is named by the site
// that makes it, an edge or a corner, because contours are linked by these names.
//
//      lo                                        hi       the window: nothing is left beyond it
//      ├──────────(gap a)─────(gap  b)───────────┤        gaps: intervals that touch neither end
//
// An edge and a corner at its end touch smoothly: where the one takes over from the other, their
// ends agree to second order. There the edge decides, because it can tell to first order, by where
// the foot of the point lies, whether the end is still its own.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

// Edge i is site 2i, the corner where it starts is site 2i + 1. An edge's offset line and a reflex
// corner's arc carry the same numbers as elements.
using OffsetSite = std::int32_t;

struct OffsetEnd {
  double at;
  OffsetSite site;
};

struct TrimmedPiece {
  double from;  // any number where an arc starts as its edge ends
  OffsetSite from_site, to_site;
  OffsetSite element;
  std::int32_t next;  // the piece that starts where this one ends
};

// Pieces in the order they were found. Grows to what it needed most and stays.
class TrimmedPieces {
 public:
  void clear() { count_ = 0; }
  void add(const TrimmedPiece& piece) {
    if (count_ == pieces_.size()) pieces_.resize(2 * count_ + 64);
    pieces_[count_++] = piece;
  }
  [[nodiscard]] std::int32_t count() const { return static_cast<std::int32_t>(count_); }
  [[nodiscard]] std::span<TrimmedPiece> all() { return std::span(pieces_).first(count_); }

 private:
  std::vector<TrimmedPiece> pieces_;
  std::size_t count_ = 0;
};

class OffsetSpan {
 public:
  // `tolerance`: ends of an edge and a corner nearer than this are taken for one place.
  void reset(OffsetEnd lo, OffsetEnd hi, double tolerance) {
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
  void remove(OffsetEnd from, OffsetEnd to) {
    if (!(from.at < to.at) || to.at < lo_.at - tolerance_ || from.at > hi_.at + tolerance_) return;
    const bool at_lo = from.at <= lo_.at, at_hi = to.at >= hi_.at;
    if (at_lo && farther(to.at - lo_.at, to.site, lo_, natural_lo_)) lo_ = to;
    if (at_hi && farther(hi_.at - from.at, from.site, hi_, natural_hi_)) hi_ = from;
    if (!at_lo && !at_hi) gaps_.push_back({from, to});
  }

  // Appends what is left as pieces, in order. REQUIRES: !dead().
  void pieces(OffsetSite element, TrimmedPieces& out) {
    if (!gaps_.empty()) split_by_gaps(element, out);
    if (!dead()) out.add({lo_.at, lo_.site, hi_.site, element, -1});
  }

 private:
  struct Gap {
    OffsetEnd from, to;
  };

  static bool is_edge(OffsetSite site) { return site % 2 == 0; }

  // Whether an end that lies `by` farther in replaces `old`.
  [[nodiscard]] bool farther(double by, OffsetSite site, const OffsetEnd& old,
                             double natural) const {
    if (by > tolerance_ || old.at == natural || is_edge(site) == is_edge(old.site)) return by > 0;
    return is_edge(site) && by > -tolerance_;
  }

  void split_by_gaps(OffsetSite element, TrimmedPieces& out) {
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

  OffsetEnd lo_{}, hi_{};
  double natural_lo_ = 0, natural_hi_ = 0, tolerance_ = 0;
  std::vector<Gap> gaps_;
};

}  // namespace core
