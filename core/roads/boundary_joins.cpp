#include "core/roads/boundary_joins.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace core {
namespace {

constexpr std::size_t kNone = kNotJoined;

// Ends are numbered: 2 i where line i begins, 2 i + 1 where it ends.
class Joiner {
 public:
  Joiner(const std::vector<ClippedLine>& lines, const LineClipper& clipper, Length longest)
      : lines_(lines),
        clipper_(clipper),
        longest_(static_cast<double>(longest.units())),
        ends_(lines.size() * 2),
        taken_(lines.size(), false),
        way_of_(lines.size()) {
    std::iota(way_of_.begin(), way_of_.end(), std::size_t{0});
    link_neighbours();
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
      if (ends_[end].joined != kNone || done[end / 2]) continue;
      joined.ways.push_back(way_from(end, done));
    }
    joined.partners.reserve(ends_.size());
    for (const End& end : ends_) joined.partners.push_back(end.joined);
    return joined;
  }

 private:
  struct End {
    std::size_t next = kNone, before = kNone;  // along the ring
    double way = 0;                            // to the next
    std::size_t joined = kNone;
    bool forwards = false;  // along the ring, to the end it is joined to
  };

  [[nodiscard]] const BoundaryPlace& place(std::size_t end) const {
    return end % 2 == 0 ? lines_[end / 2].from : lines_[end / 2].to;
  }

  void link_neighbours() {
    std::vector<std::size_t> order(ends_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      const BoundaryPlace &p = place(a), &q = place(b);
      if (p.ring != q.ring) return p.ring < q.ring;
      return p.along != q.along ? p.along < q.along : a < b;
    });
    for (std::size_t first = 0; first < order.size();) {
      std::size_t end = first;
      const std::size_t ring = place(order[first]).ring;
      while (end < order.size() && place(order[end]).ring == ring) ++end;
      for (std::size_t i = first; i < end; ++i) {
        const std::size_t a = order[i], b = order[i + 1 < end ? i + 1 : first];
        ends_[a].next = b;
        ends_[b].before = a;
        ends_[a].way = place(b).along - place(a).along;
        if (i + 1 == end) ends_[a].way += clipper_.ring_length(ring);
      }
      first = end;
    }
  }

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
    ends_[from].joined = to;
    ends_[from].forwards = forwards;
    ends_[to].joined = from;
    ends_[to].forwards = !forwards;
    way_of_[root(from / 2)] = root(to / 2);
  }

  [[nodiscard]] std::size_t root(std::size_t line) {
    while (way_of_[line] != line) line = way_of_[line] = way_of_[way_of_[line]];
    return line;
  }

  void join_ways() {
    std::vector<std::size_t> free;  // ends that might be joined to the next
    for (std::size_t end = 0; end < ends_.size(); ++end) {
      const bool both = ends_[end].joined == kNone && ends_[ends_[end].next].joined == kNone;
      if (both && ends_[end].way <= longest_) free.push_back(end);
    }
    std::sort(free.begin(), free.end(), [this](std::size_t a, std::size_t b) {
      return ends_[a].way != ends_[b].way ? ends_[a].way < ends_[b].way : a < b;
    });
    for (const std::size_t end : free) {
      const std::size_t to = ends_[end].next;
      if (ends_[end].joined != kNone || ends_[to].joined != kNone) continue;
      if (root(end / 2) != root(to / 2)) join(end, to, true);
    }
  }

  [[nodiscard]] std::vector<Point> way_from(std::size_t end, std::vector<bool>& done) const {
    std::vector<Point> way;
    for (;;) {
      const std::vector<Point>& points = lines_[end / 2].points;
      done[end / 2] = true;
      if (end % 2 == 0) {
        way.insert(way.end(), points.begin(), points.end());
      } else {
        way.insert(way.end(), points.rbegin(), points.rend());
      }
      const End& far = ends_[end ^ 1U];
      if (far.joined == kNone) return way;
      clipper_.append_way(place(end ^ 1U), place(far.joined), far.forwards, way);
      end = far.joined;
    }
  }

  const std::vector<ClippedLine>& lines_;
  const LineClipper& clipper_;
  double longest_;
  std::vector<End> ends_;
  std::vector<bool> taken_;          // by line: part of a way
  std::vector<std::size_t> way_of_;  // by line, as sets that are united
};

}  // namespace

JoinedLines join_along_boundary(const std::vector<ClippedLine>& lines, const LineClipper& clipper,
                                Length longest) {
  return Joiner(lines, clipper, longest).join();
}

}  // namespace core
