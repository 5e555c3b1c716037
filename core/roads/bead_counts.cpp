#include "core/roads/bead_counts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace core {
namespace {

bool is_central(const AxisEdge& edge) { return edge.central; }

// Central edges with one count that hang together.
struct Piece {
  int count = 0;
  double length = 0;
  double own_length = 0;  // where the room asks for this count
  double room_low = std::numeric_limits<double>::max();
  double room_high = std::numeric_limits<double>::lowest();
  int lower = 0;  // the greatest count below this that it meets; 0: none
  int higher = std::numeric_limits<int>::max();
  bool open = false;
  bool ends = false;  // somewhere in nothing
};

class Counts {
 public:
  Counts(const Beading& beading, AxisGraph& graph)
      : beading_(beading), graph_(graph), at_(graph, is_central) {}

  void settle() {
    for (int pass = 0; pass < kCountPassesMax; ++pass) {
      find_pieces();
      if (!change_pieces()) return;
    }
  }

 private:
  void find_pieces() {
    pieces_.clear();
    of_edge_.assign(graph_.edges().size(), UINT32_MAX);
    for (std::uint32_t edge = 0; edge < graph_.edges().size(); ++edge) {
      if (graph_.edges()[edge].central && of_edge_[edge] == UINT32_MAX) add_piece(edge);
    }
  }

  void add_piece(std::uint32_t first) {
    const auto name = static_cast<std::uint32_t>(pieces_.size());
    Piece piece;
    piece.count = graph_.edges()[first].count;
    stack_.assign(1, first);
    of_edge_[first] = name;
    while (!stack_.empty()) {
      const AxisEdge& edge = graph_.edges()[stack_.back()];
      stack_.pop_back();
      const double length = graph_.length(edge);
      piece.length += length;
      if (asked_for(edge) == edge.count) piece.own_length += length;
      for (const std::uint32_t node : {edge.from, edge.to}) {
        const double room = beading_.room(graph_.nodes()[node].radius);
        piece.room_low = std::min(piece.room_low, room);
        piece.room_high = std::max(piece.room_high, room);
        if (graph_.nodes()[node].open) piece.open = true;
        if (at_.count(node) == 1) piece.ends = true;
        for (const std::uint32_t* next = at_.begin(node); next != at_.end(node); ++next) {
          const int count = graph_.edges()[*next].count;
          if (count < piece.count) piece.lower = std::max(piece.lower, count);
          if (count == 0) piece.ends = true;
          if (count > piece.count) piece.higher = std::min(piece.higher, count);
          if (count != piece.count || of_edge_[*next] != UINT32_MAX) continue;
          of_edge_[*next] = name;
          stack_.push_back(*next);
        }
      }
    }
    pieces_.push_back(piece);
  }

  [[nodiscard]] int asked_for(const AxisEdge& edge) const {
    const double a = graph_.nodes()[edge.from].radius, b = graph_.nodes()[edge.to].radius;
    return beading_.count_at(beading_.room((a + b) / 2));
  }

  // The count that a piece should have.
  [[nodiscard]] int wanted(const Piece& piece) const {
    const double s = beading_.spacing();
    const bool lower = piece.lower > 0, higher = piece.higher < std::numeric_limits<int>::max();
    if (piece.count == 0 || piece.open) return piece.count;
    // What it took over from narrower ones does not make it longer.
    if (higher && lower) {
      return piece.own_length < kCountLengthMin * s ? piece.higher : piece.count;
    }
    if (piece.length >= kCountLengthMin * s) return piece.count;
    if (lower) {
      const double most = (piece.lower + 0.5 + kBulgeRoomMax) * s;
      return piece.room_high <= most ? piece.lower : piece.count;
    }
    if (!higher) return piece.count;
    const double least = beading_.room_from(piece.higher) - kNeckRoomMax * s;
    const bool short_end = piece.ends && piece.length < kEndLengthMin * s;
    return short_end || piece.room_low >= least ? piece.higher : piece.count;
  }

  // The shortest first, none beside one that changed just now.
  bool change_pieces() {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      if (wanted(pieces_[i]) != pieces_[i].count) order.push_back(i);
    }
    if (order.empty()) return false;
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return pieces_[a].length < pieces_[b].length;
    });
    collect_edges();
    std::vector<std::uint8_t> fixed(pieces_.size(), 0);
    for (const std::uint32_t name : order) {
      if (fixed[name] != 0) continue;
      const int count = wanted(pieces_[name]);
      for (std::uint32_t i = starts_[name]; i < starts_[name + 1]; ++i) {
        AxisEdge& edge = graph_.edges()[members_[i]];
        for (const std::uint32_t node : {edge.from, edge.to}) {
          for (const std::uint32_t* next = at_.begin(node); next != at_.end(node); ++next) {
            fixed[of_edge_[*next]] = 1;
          }
        }
        edge.count = count;
      }
    }
    return true;
  }

  void collect_edges() {
    starts_.assign(pieces_.size() + 1, 0);
    for (const std::uint32_t piece : of_edge_) {
      if (piece != UINT32_MAX) ++starts_[piece];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& start : starts_) start = (sum += start);
    members_.resize(sum);
    for (std::uint32_t edge = 0; edge < of_edge_.size(); ++edge) {
      if (of_edge_[edge] != UINT32_MAX) members_[--starts_[of_edge_[edge]]] = edge;
    }
  }

  const Beading& beading_;
  AxisGraph& graph_;
  EdgesAt at_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> of_edge_;
  std::vector<std::uint32_t> stack_;
  std::vector<std::uint32_t> starts_;  // by piece, into members_
  std::vector<std::uint32_t> members_;
};

void set_states(AxisGraph& graph) {
  for (AxisEdge& edge : graph.edges()) {
    if (!edge.central) continue;
    edge.states[0] = {edge.count, 0, graph.nodes()[edge.from].radius};
    edge.states[1] = {edge.count, 0, graph.nodes()[edge.to].radius};
  }
}

// One edge and the end of it at which a walk comes in.
struct Step {
  std::uint32_t edge = 0;
  std::uint32_t node = 0;
};

class Transitions {
 public:
  Transitions(const Beading& beading, AxisGraph& graph)
      : beading_(beading), graph_(graph), at_(graph, is_central) {}

  void make() {
    const auto nodes = static_cast<std::uint32_t>(graph_.nodes().size());
    for (std::uint32_t node = 0; node < nodes; ++node) {
      if (at_.count(node) != 2) continue;
      const std::uint32_t a = *at_.begin(node), b = *(at_.begin(node) + 1);
      const int there = graph_.edges()[a].count, here = graph_.edges()[b].count;
      if (there == here) continue;
      const std::uint32_t lower = there < here ? a : b, higher = there < here ? b : a;
      // A bead between the pairs begins where they have made room for it; without one, the pairs
      // fill the place up to where the wider beading begins.
      if (beading_.has_centre(std::max(there, here))) {
        add(node, lower, std::max(there, here));
      } else {
        add(node, higher, std::min(there, here));
      }
    }
    for (const auto& [path, count, length] : ramps_) bend(path, count, length);
  }

 private:
  struct Ramp {
    std::vector<Step> path;
    int count = 0;
    double length = 0;
  };

  [[nodiscard]] std::uint32_t far(const Step& step) const {
    const AxisEdge& edge = graph_.edges()[step.edge];
    return edge.from == step.node ? edge.to : edge.from;
  }

  // Looks for the way along which beads move. Nothing is split before all ways are known.
  void add(std::uint32_t node, std::uint32_t edge, int count) {
    if (!moves(node, graph_.edges()[edge].count, count)) return;
    const double wanted = kTransitionLength * beading_.spacing();
    Ramp ramp{{}, count, 0};
    Step step{edge, node};
    for (;;) {
      ramp.path.push_back(step);
      ramp.length += graph_.length(graph_.edges()[step.edge]);
      const std::uint32_t end = far(step);
      if (ramp.length >= 2 * wanted || at_.count(end) != 2) break;
      const std::uint32_t next = at_.other(end, step.edge);
      if (graph_.edges()[next].count != graph_.edges()[edge].count) break;
      step = {next, end};
    }
    // Another transition may come the other way.
    ramp.length = std::min(wanted, ramp.length / 2);
    ramps_.push_back(std::move(ramp));
  }

  // Whether any bead lies elsewhere after the change.
  [[nodiscard]] bool moves(std::uint32_t node, int from, int to) const {
    const double radius = graph_.nodes()[node].radius;
    for (int level = 1; level <= std::min(beading_.levels(from), beading_.levels(to)); ++level) {
      const double a = beading_.bead(level, {from, 0, radius}).depth;
      const double b = beading_.bead(level, {to, 0, radius}).depth;
      if (std::abs(a - b) > 1) return true;
    }
    return false;
  }

  void bend(const std::vector<Step>& path, int count, double length) {
    double done = 0;
    for (Step step : path) {
      const double left = length - done;
      if (left <= 0) return;
      const AxisEdge& edge = graph_.edges()[step.edge];
      if (edge.from != step.node && edge.to != step.node) step.edge = rests_.at(step.edge);
      const double mm = graph_.length(graph_.edges()[step.edge]);
      if (mm > left) return bend_part(step, count, length, done, left / mm);
      set(step, count, 1 - done / length, 1 - (done + mm) / length);
      done += mm;
    }
  }

  void set(const Step& step, int count, double near, double far) {
    AxisEdge& edge = graph_.edges()[step.edge];
    const bool forward = edge.from == step.node;
    BeadState& first = edge.states[forward ? 0 : 1];
    BeadState& last = edge.states[forward ? 1 : 0];
    first.toward = last.toward = count;
    first.share = near;
    last.share = far;
  }

  // The transition ends within this edge. Its other part keeps the path's later edges.
  void bend_part(const Step& step, int count, double length, double done, double share) {
    const bool forward = graph_.edges()[step.edge].from == step.node;
    const double at = forward ? share : 1 - share;
    if (at <= 1e-6 || at >= 1 - 1e-6) return set(step, count, 1 - done / length, 0);
    const std::uint32_t node = graph_.split(step.edge, at);
    const auto rest = static_cast<std::uint32_t>(graph_.edges().size()) - 1;
    rests_[step.edge] = rest;
    const BeadState state{graph_.edges()[step.edge].count, 0, graph_.nodes()[node].radius};
    graph_.edges()[step.edge].states[1] = graph_.edges()[rest].states[0] = state;
    set({forward ? step.edge : rest, step.node}, count, 1 - done / length, 0);
  }

  const Beading& beading_;
  AxisGraph& graph_;
  EdgesAt at_;
  std::vector<Ramp> ramps_;
  std::map<std::uint32_t, std::uint32_t> rests_;  // what was split off an edge
};

// From the central axis and from where it was cut off, out into the spurs.
void inherit_states(const Beading& beading, AxisGraph& graph) {
  const EdgesAt at(graph, [](const AxisEdge&) { return true; });
  std::vector<BeadState> states(graph.nodes().size());
  std::vector<std::uint32_t> queue;
  for (std::uint32_t node = 0; node < graph.nodes().size(); ++node) {
    BeadState& state = states[node];
    if (graph.nodes()[node].open) state = {beading.wide(), 0, graph.nodes()[node].radius};
    for (const std::uint32_t* i = at.begin(node); i != at.end(node); ++i) {
      const AxisEdge& edge = graph.edges()[*i];
      if (edge.central) state = edge.states[edge.from == node ? 0 : 1];
    }
    if (state.count > 0) queue.push_back(node);
  }
  for (std::size_t done = 0; done < queue.size(); ++done) {
    const std::uint32_t node = queue[done];
    for (const std::uint32_t* i = at.begin(node); i != at.end(node); ++i) {
      AxisEdge& edge = graph.edges()[*i];
      if (edge.central || edge.states[0].count > 0) continue;
      edge.states[0] = edge.states[1] = states[node];
      const std::uint32_t next = edge.from == node ? edge.to : edge.from;
      if (states[next].count > 0) continue;
      states[next] = states[node];
      queue.push_back(next);
    }
  }
}

}  // namespace

void decide_bead_counts(const Beading& beading, AxisGraph& graph) {
  Counts(beading, graph).settle();
  set_states(graph);
  Transitions(beading, graph).make();
  inherit_states(beading, graph);
}

}  // namespace core
