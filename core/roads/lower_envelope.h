// The lower envelope of a few curves over one parameter: which curve is the lowest where.
//
//     ╲      ╱╲                A curve type offers
//      ╲____╱  ╲___ ╱            double value(place of t)           what is compared
//     1 ┆ 2 ┆ 1 ┆ 3 ┆            double low, high                   where the curve is defined
//                                two members for pairs of curves    below
//
// Any two curves of a type meet at most twice where both are defined. With two curves the envelope
// is exact. With more, it is the lowest at every end of a piece, but between two pieces that cross,
// a third curve's dip can be missed. narrow_diagram.h notices that when it links the pieces.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace core {

// From the piece before to `to` the curve is the lowest.
struct EnvelopePiece {
  double to = 0;
  std::uint32_t curve = 0;
};

// Curve:  kSame, values nearer than which are one; Place, what values need to know of a parameter,
//         explicitly made from it; and two members beside those above:
//         double crossing(const Curve& other, double from, double to)
//             where the two meet, if it lies between, else halfway
//         double closest(const Curve& other, const Place& from, const Place& to)
//             where other.value() - value() is least: between, or at one of the two
template <typename Curve>
class LowerEnvelope {
 public:
  // REQUIRES: from < to; at every parameter at least one curve is defined.
  // COSTS: O(curves²) at worst, evaluations() tells; keeps its memory.
  const std::vector<EnvelopePiece>& find(const std::vector<Curve>& curves, double from, double to) {
    curves_ = &curves;
    splits_left_ = kSplitsPerCurve * curves.size();
    pieces_.clear();
    stops_.assign({from, to});
    for (const Curve& curve : curves) {
      for (const double limit : {curve.low, curve.high}) {
        if (from < limit && limit < to) stops_.push_back(limit);
      }
    }
    std::sort(stops_.begin(), stops_.end());
    for (std::size_t i = 0; i + 1 < stops_.size(); ++i) between(stops_[i], stops_[i + 1]);
    return pieces_;
  }

  // How often curves have been evaluated, in all calls.
  [[nodiscard]] std::size_t evaluations() const { return evaluations_; }

 private:
  using Place = typename Curve::Place;

  // True breaks are fewer. Rounding may seem to make more: they are cut short here.
  static constexpr std::size_t kSplitsPerCurve = 8;

  // No curve's limit lies between.
  void between(double from, double to) {
    if (!(from < to)) return;
    const double middle = (from + to) / 2;
    open_.clear();
    for (std::uint32_t i = 0; i < curves_->size(); ++i) {
      if ((*curves_)[i].low <= middle && middle <= (*curves_)[i].high) open_.push_back(i);
    }
    const Place start(from), end(to);
    split(start, lowest(start), end, lowest(end));
  }

  [[nodiscard]] std::uint32_t lowest(const Place& place) {
    std::uint32_t best = open_.front();
    double least = std::numeric_limits<double>::max();
    evaluations_ += open_.size();
    for (const std::uint32_t i : open_) {
      const double there = value(i, place);
      if (there >= least) continue;
      least = there;
      best = i;
    }
    return best;
  }

  [[nodiscard]] double value(std::uint32_t curve, const Place& place) const {
    return (*curves_)[curve].value(place);
  }

  void split(const Place& from, std::uint32_t first, const Place& to, std::uint32_t last) {
    // Curves that touch where one of them ends do not cross.
    if (value(first, to) <= value(last, to) + Curve::kSame) {
      last = first;
    } else if (value(last, from) <= value(first, from) + Curve::kSame) {
      first = last;
    }
    const Curve& a = (*curves_)[first];
    if (first != last) {
      const Place at(a.crossing((*curves_)[last], from.t, to.t));
      const std::uint32_t there = lowest(at);
      const bool other =
          there != first && there != last && value(there, at) < a.value(at) - Curve::kSame;
      if (!other || splits_left_ == 0 || !(from.t < at.t && at.t < to.t)) {
        add(at.t, first);
        add(to.t, last);
        return;
      }
      --splits_left_;
      split(from, first, at, there);
      split(at, there, to, last);
      return;
    }
    evaluations_ += open_.size();
    for (const std::uint32_t i : open_) {
      if (i == first || splits_left_ == 0) continue;
      const double closest = a.closest((*curves_)[i], from, to);
      if (!(from.t < closest && closest < to.t)) continue;
      const Place at(closest);
      if (value(i, at) >= a.value(at) - Curve::kSame) continue;
      const std::uint32_t there = lowest(at);
      --splits_left_;
      split(from, first, at, there);
      split(at, there, to, last);
      return;
    }
    add(to.t, first);
  }

  void add(double to, std::uint32_t curve) {
    if (!pieces_.empty() && pieces_.back().curve == curve) {
      pieces_.back().to = to;
    } else {
      pieces_.push_back({to, curve});
    }
  }

  const std::vector<Curve>* curves_ = nullptr;
  std::size_t splits_left_ = 0;
  std::size_t evaluations_ = 0;
  std::vector<double> stops_;
  std::vector<std::uint32_t> open_;
  std::vector<EnvelopePiece> pieces_;
};

}  // namespace core
