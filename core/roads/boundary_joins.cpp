#include "core/roads/boundary_joins.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "core/roads/boundary_ends.h"  // boundary_ends

namespace core {
namespace {

constexpr std::size_t kNone = kNotJoined;

class Joiner {
 public:
  Joiner(const std::vector<ClippedLine>& lines, const LineClipper& clipper, Length longest)
      : lines_(lines),
        clipper_(clipper),
        longest_(static_cast<double>(longest.units())),
        ends_(boundary_ends(lines, clipper)),
        joins_(ends_.size()),
        taken_(lines.size(), false),
        way_of_(lines.size()) {
    std::iota(way_of_.begin(), way_of_.end(), std::size_t{0});
  }

  [[nodiscard]] JoinedLines join() {
    for (std::size_t line = 0; line < lines_.size(); ++line) {
      if (taken_[line]) continue;
      taken_[line] = true;
      go_on_from(2 * line + 1);
      go_on_from(2 * line);
    }
    join_ways();
    JoinedLines joined;
    std::vector<bool> done(lines_.size(), false);
    for (std::size_t end = 0; end < ends_.size(); ++end) {
      if (joins_[end].to != kNone || done[end / 2]) continue;
      joined.ways.push_back(way_from(end, done));
    }
    joined.partners.reserve(ends_.size());
    for (const Join& join : joins_) joined.partners.push_back(join.to);
    return joined;
  }

 private:
  struct Join {
    std::size_t to = kNone;
    bool forwards = false;  // along the ring
  };

  void go_on_from(std::size_t end) {
    for (;;) {
      const std::size_t ahead = ends_[end].next, back = ends_[end].before;
      const bool may_ahead = !taken_[ahead / 2] && ends_[end].way <= longest_;
      const bool may_back = !taken_[back / 2] && ends_[back].way <= longest_;
      if (!may_ahead && !may_back) return;
      const bool forwards = may_ahead && (!may_back || ends_[end].way <= ends_[back].way);
      const std::size_t to = forwards ? ahead : back;
      taken_[to / 2] = true;
      join(end, to, forwards);
      end = to ^ 1U;
    }
  }

  void join(std::size_t from, std::size_t to, bool forwards) {
    joins_[from] = {to, forwards};
    joins_[to] = {from, !forwards};
    way_of_[root(from / 2)] = root(to / 2);
  }

  [[nodiscard]] std::size_t root(std::size_t line) {
    while (way_of_[line] != line) line = way_of_[line] = way_of_[way_of_[line]];
    return line;
  }

  void join_ways() {
    std::vector<std::size_t> free;  // ends that might be joined to the next
    for (std::size_t end = 0; end < ends_.size(); ++end) {
      const bool both = joins_[end].to == kNone && joins_[ends_[end].next].to == kNone;
      if (both && ends_[end].way <= longest_) free.push_back(end);
    }
    std::sort(free.begin(), free.end(), [this](std::size_t a, std::size_t b) {
      return ends_[a].way != ends_[b].way ? ends_[a].way < ends_[b].way : a < b;
    });
    for (const std::size_t end : free) {
      const std::size_t to = ends_[end].next;
      if (joins_[end].to != kNone || joins_[to].to != kNone) continue;
      if (root(end / 2) != root(to / 2)) join(end, to, true);
    }
  }

  [[nodiscard]] std::vector<Point> way_from(std::size_t end, std::vector<bool>& done) const {
    std::vector<Point> way;
    for (;;) {
      done[end / 2] = true;
      append_line(lines_[end / 2], end % 2 == 0, way);
      const Join& join = joins_[end ^ 1U];
      if (join.to == kNone) return way;
      clipper_.append_way(place_of(lines_, end ^ 1U), place_of(lines_, join.to), join.forwards,
                          way);
      end = join.to;
    }
  }

  const std::vector<ClippedLine>& lines_;
  const LineClipper& clipper_;
  double longest_;
  std::vector<BoundaryEnd> ends_;
  std::vector<Join> joins_;          // by end
  std::vector<bool> taken_;          // by line: part of a way
  std::vector<std::size_t> way_of_;  // by line, as sets that are united
};

}  // namespace

JoinedLines join_along_boundary(const std::vector<ClippedLine>& lines, const LineClipper& clipper,
                                Length longest) {
  return Joiner(lines, clipper, longest).join();
}

}  // namespace core
