#include "core/roads/bead_lines.h"

#include <algorithm>
#include <cmath>

#include "core/trigonometry.h"  // arc_cosine, arc_tangent, cosine, sine

namespace core {
namespace {

// Points nearer than this are one. Units.
constexpr double kSamePoint = 1;

// Chords of an arc turn by this at most.
constexpr double kArcStepMax = M_PI / 4;

// Where a line ends and another one starts on the other side of the axis: a node, or an edge.
constexpr std::uint64_t kAtEdge = std::uint64_t{1} << 32;

// A stretch of line along one contour.
struct Stretch {
  std::vector<BeadPoint> points;
  std::uint64_t start = 0;  // where it comes from the other side
  std::uint64_t end = 0;    // and where it goes there
  bool closed = false;
};

class Walk {
 public:
  Walk(const Beading& beading, const AxisGraph& graph, const BeadSpans& spans, int level,
       double tolerance)
      : beading_(beading), graph_(graph), spans_(spans), level_(level), tolerance_(tolerance) {}

  [[nodiscard]] std::vector<BeadLine> lines() {
    for (std::size_t ring = 0; ring + 1 < spans_.starts().size(); ++ring) walk_ring(ring);
    return linked();
  }

 private:
  void walk_ring(std::size_t ring) {
    ring_ = ring;
    const std::size_t first = stretches_.size();
    going_ = false;
    bool from_the_start = false;
    for (std::size_t i = spans_.starts()[ring]; i < spans_.starts()[ring + 1]; ++i) {
      const BeadSpan& span = spans_.spans()[i];
      const bool was_going = going_;
      walk_span(span, spans_.ends()[i]);
      const bool started = !was_going && stretches_.size() > first;
      if (i == spans_.starts()[ring] && started) from_the_start = starts_whole_;
    }
    if (!going_) return;
    Stretch& last = stretches_.back();
    if (!from_the_start) {
      last.end = spans_.spans()[spans_.starts()[ring]].from;
    } else if (stretches_.size() == first + 1) {
      last.closed = true;
    } else {
      Stretch& start = stretches_[first];
      last.points.insert(last.points.end(), start.points.begin(), start.points.end());
      start.points = std::move(last.points);
      start.start = last.start;
      stretches_.pop_back();
    }
  }

  void begin(std::uint64_t at) {
    stretches_.push_back({{}, at, at, false});
    going_ = true;
  }
  void end(std::uint64_t at) {
    if (going_) stretches_.back().end = at;
    going_ = false;
  }

  void walk_span(const BeadSpan& span, const BeadSpanEnds& ends) {
    starts_whole_ = true;
    if (span.edge == BeadSpan::kOpen) {
      if (!going_) begin(span.from);
      add_open(span, ends);
      return;
    }
    const AxisEdge& edge = graph_.edges()[span.edge];
    const BeadState& from = edge.states[span.forward ? 0 : 1];
    const BeadState& to = edge.states[span.forward ? 1 : 0];
    if (level_ > beading_.levels(from.count)) return end(span.from);
    const AxisNode& a = graph_.nodes()[span.from];
    const AxisNode& b = graph_.nodes()[span.to];
    const Bead first = beading_.bead(level_, from), last = beading_.bead(level_, to);
    const double room_a = a.radius - first.depth, room_b = b.radius - last.depth;
    if (room_a <= 0 && room_b <= 0) return end(span.from);
    if (room_a <= 0) {
      starts_whole_ = false;
      end(span.from);
      begin(kAtEdge | span.edge);
    } else if (!going_) {
      begin(span.from);
    }
    if (room_a > 0 && room_b > 0) {
      return add_between(span.site, ends.from_foot, ends.from, first, ends.to_foot, ends.to, last);
    }
    // Where the line meets the axis; the same point from both sides.
    const double share = span.forward ? room_a / (room_a - room_b) : room_b / (room_b - room_a);
    const Vector start = graph_.nodes()[edge.from].at, stop = graph_.nodes()[edge.to].at;
    const Vector meeting = start + (stop - start) * share;
    const double met = span.forward ? share : 1 - share;
    const Bead middle{first.depth + met * (last.depth - first.depth),
                      first.room + met * (last.room - first.room)};
    add_stretch(span.site, room_a > 0 ? a.at : meeting, room_a > 0 ? first : middle,
                room_b > 0 ? b.at : meeting, room_b > 0 ? last : middle);
    if (room_b <= 0) end(kAtEdge | span.edge);
  }

  // Along one site, from the way to one axis point to that to another.
  void add_stretch(std::uint32_t site, Vector a, const Bead& first, Vector b, const Bead& last) {
    const ContourSites& sites = graph_.sites();
    add_between(site, sites.foot(site, a), sites.direction(site, a), first, sites.foot(site, b),
                sites.direction(site, b), last);
  }

  void add_between(std::uint32_t site, Vector foot_a, Vector a, const Bead& first, Vector foot_b,
                   Vector b, const Bead& last) {
    add(foot_a + a * first.depth, first.room);
    const double depth = std::max({first.depth, last.depth, tolerance_});
    if (graph_.sites()[site].is_corner() && dot(a, b) < step_cosine(depth)) {
      const double turn = arc_tangent(std::abs(cross(a, b)), dot(a, b));
      const double step = std::min(kArcStepMax, 2 * arc_cosine(1 - tolerance_ / depth));
      const int parts = static_cast<int>(std::ceil(turn / step));
      for (int i = 1; i < parts; ++i) {
        const double share = static_cast<double>(i) / parts;
        const double angle = -turn * share, c = cosine(angle), s = sine(angle);
        const Vector turned{a.x * c - a.y * s, a.x * s + a.y * c};
        add(foot_a + turned * (first.depth + share * (last.depth - first.depth)),
            first.room + share * (last.room - first.room));
      }
    }
    add(foot_b + b * last.depth, last.room);
  }

  // Of the turn that one chord may make at that depth, as cosine(2 · arc_cosine(x)) = 2x² − 1.
  [[nodiscard]] double step_cosine(double depth) const {
    const double half = 1 - tolerance_ / depth;
    return std::max(M_SQRT1_2, 2 * half * half - 1);
  }

  // At a wide place's depth, from site to site.
  void add_open(const BeadSpan& span, const BeadSpanEnds& ends) {
    const ContourSites& sites = graph_.sites();
    const Bead bead = beading_.bead(level_, {beading_.wide(), 0, 0});
    const std::uint32_t ring_start = sites.starts()[ring_], ring_end = sites.starts()[ring_ + 1];
    const bool whole = span.from == BeadSpan::kOpen;
    bool first = true, going_round = span.round;
    for (std::uint32_t site = span.site;; site = site + 1 < ring_end ? site + 1 : ring_start) {
      const ContourSite& on = sites[site];
      Vector a = on.first, b = on.last, foot_a = on.at;
      Vector foot_b = on.at + Vector{a.y, -a.x} * on.length;
      const bool last = site == span.last && !going_round;
      if (!whole && first) {
        a = ends.from;
        foot_a = ends.from_foot;
      }
      if (!whole && last) {
        b = ends.to;
        foot_b = ends.to_foot;
      }
      add_between(site, foot_a, a, bead, foot_b, b, bead);
      if (last) return;
      first = going_round = false;
    }
  }

  void add(Vector at, double room) {
    std::vector<BeadPoint>& points = stretches_.back().points;
    if (!points.empty()) {
      const Vector step = at - points.back().at;
      if (std::abs(step.x) + std::abs(step.y) < kSamePoint &&
          std::abs(room - points.back().room) < kSamePoint) {
        return;
      }
    }
    points.push_back({at, room});
  }

  // Joins stretches where one ends and another one starts.
  [[nodiscard]] std::vector<BeadLine> linked() {
    std::vector<std::uint32_t> ends, starts;
    for (std::uint32_t i = 0; i < stretches_.size(); ++i) {
      if (stretches_[i].closed) continue;
      ends.push_back(i);
      starts.push_back(i);
    }
    std::stable_sort(ends.begin(), ends.end(), [&](std::uint32_t a, std::uint32_t b) {
      return stretches_[a].end < stretches_[b].end;
    });
    std::stable_sort(starts.begin(), starts.end(), [&](std::uint32_t a, std::uint32_t b) {
      return stretches_[a].start < stretches_[b].start;
    });
    std::vector<std::uint32_t> next(stretches_.size(), UINT32_MAX);
    std::vector<std::uint8_t> follows(stretches_.size(), 0);
    for (std::size_t i = 0, j = 0; i < ends.size() && j < starts.size();) {
      const std::uint64_t end = stretches_[ends[i]].end, start = stretches_[starts[j]].start;
      if (end == start) {
        next[ends[i++]] = starts[j];
        follows[starts[j++]] = 1;
      } else {
        ++(end < start ? i : j);
      }
    }
    std::vector<BeadLine> lines;
    for (const bool open : {true, false}) {
      for (std::uint32_t i = 0; i < stretches_.size(); ++i) {
        if (!open || (follows[i] == 0 && !stretches_[i].closed)) add_line(i, next, lines);
      }
    }
    return lines;
  }

  void add_line(std::uint32_t first, std::vector<std::uint32_t>& next,
                std::vector<BeadLine>& lines) {
    if (stretches_[first].points.empty()) return;
    BeadLine line{{}, stretches_[first].closed};
    for (std::uint32_t i = first; i != UINT32_MAX && !stretches_[i].points.empty();) {
      std::vector<BeadPoint>& points = stretches_[i].points;
      line.points.insert(line.points.end(), points.begin(), points.end());
      points.clear();
      i = next[i];
      if (i == first) line.closed = true;
    }
    lines.push_back(std::move(line));
  }

  const Beading& beading_;
  const AxisGraph& graph_;
  const BeadSpans& spans_;
  int level_;
  double tolerance_;
  std::size_t ring_ = 0;
  bool going_ = false;        // the last stretch goes on
  bool starts_whole_ = true;  // the last span has the line right from its start
  std::vector<Stretch> stretches_;
};

}  // namespace

std::vector<BeadLine> bead_lines(const Beading& beading, const AxisGraph& graph,
                                 const BeadSpans& spans, int level, double tolerance) {
  if (!spans.sound()) return {};
  return Walk(beading, graph, spans, level, tolerance).lines();
}

}  // namespace core
