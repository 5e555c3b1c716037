#include "core/roads/order_improvement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/regions/polyline.h"  // distance_mm
#include "core/roads/short_ways.h"  // kShortWayMax
#include "core/units.h"             // kUnitsPerMm

namespace core {
namespace {

// Less is not worth a change.
constexpr double kGainMinMm = 1e-6;

double cost_mm(Point from, Point to) {
  const double mm = distance_mm(from, to);
  return mm <= kShortWayMax.mm() ? mm : mm + kStopMm;
}

// At most cost_mm(), in floating point, too.
double least_cost_mm(Point from, Point to) {
  const double dx = std::abs(static_cast<double>(to.x) - from.x);
  const double dy = std::abs(static_cast<double>(to.y) - from.y);
  return std::max(dx, dy) / kUnitsPerMm;
}

Point end_of(const Road& road) { return road.closed ? road.points.front() : road.points.back(); }

class Order {
 public:
  Order(const std::vector<Road>& roads, Point from) {
    // Place 0 is the nozzle's.
    stops_.push_back({from, from, 0, false});
    for (std::size_t i = 0; i < roads.size(); ++i) {
      stops_.push_back({roads[i].points.front(), end_of(roads[i]), i, false});
    }
    ways_.resize(stops_.size() + 1, 0);
    changed_.resize(stops_.size() / kBlock + 1, 0);
    tried_.resize(stops_.size(), 0);
    changed(1, stops_.size());
  }

  [[nodiscard]] bool pass() {
    bool better = false;
    for (std::size_t i = 1; i < stops_.size(); ++i) {
      if (tried_in_vain(i)) continue;
      tried_[i] = ++step_;
      better = turn_run(i) || better;
      for (std::size_t count = 1; count <= kMovedRoadsMax; ++count) {
        if (i + count <= stops_.size()) better = move_run(i, count) || better;
      }
    }
    return better;
  }

  [[nodiscard]] std::vector<Road> take(std::vector<Road> roads) const {
    std::vector<Road> ordered;
    ordered.reserve(roads.size());
    for (std::size_t i = 1; i < stops_.size(); ++i) {
      ordered.push_back(std::move(roads[stops_[i].road]));
      if (stops_[i].turned && !ordered.back().closed) reverse(ordered.back());
    }
    return ordered;
  }

 private:
  struct Stop {
    Point begin, end;
    std::size_t road = 0;
    bool turned = false;
  };

  // Changes are noted by so many places together.
  static constexpr std::size_t kBlock = 32;

  // The places from `first` to before `last` have other stops than before.
  void changed(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i <= std::min(last, stops_.size() - 1); ++i) {
      ways_[i] = cost_mm(stops_[i - 1].end, stops_[i].begin);
    }
    for (std::size_t block = first / kBlock; block <= last / kBlock; ++block) {
      if (block < changed_.size()) changed_[block] = step_;
    }
  }

  // Whether nothing that decides what is done at a place has changed since it was tried, and
  // nothing was gained there.
  [[nodiscard]] bool tried_in_vain(std::size_t place) const {
    if (tried_[place] == 0) return false;
    const std::size_t reach = kOrderReach + kMovedRoadsMax + 1;
    const std::size_t first = place > reach ? (place - reach) / kBlock : 0;
    const std::size_t last = std::min((place + reach) / kBlock + 1, changed_.size());
    for (std::size_t block = first; block < last; ++block) {
      if (changed_[block] >= tried_[place]) return false;
    }
    return true;
  }

  // From the end of one stop to the begin of another; after the last there is no way.
  [[nodiscard]] double way(Point end, std::size_t next) const {
    return next < stops_.size() ? cost_mm(end, stops_[next].begin) : 0;
  }

  void turn(std::size_t first, std::size_t last) {
    const auto begin = stops_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = stops_.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    std::reverse(begin, end);
    for (auto stop = begin; stop != end; ++stop) {
      std::swap(stop->begin, stop->end);
      stop->turned = !stop->turned;
    }
    changed(first, last + 1);
  }

  // Turns the run from `first` on that gains most.
  bool turn_run(std::size_t first) {
    const Point before = stops_[first - 1].end;
    const double to_first = ways_[first];
    double best = kGainMinMm;
    std::size_t best_last = 0;
    for (std::size_t last = first; last < std::min(stops_.size(), first + kOrderReach); ++last) {
      const double now = to_first + ways_[last + 1];
      if (now - least_cost_mm(before, stops_[last].end) <= best) continue;
      const double turned = cost_mm(before, stops_[last].end) + way(stops_[first].begin, last + 1);
      if (now - turned <= best) continue;
      best = now - turned;
      best_last = last;
    }
    if (best_last == 0) return false;
    turn(first, best_last);
    return true;
  }

  // Moves `count` stops from `first` on to between two others, where that gains most.
  bool move_run(std::size_t first, std::size_t count) {
    const std::size_t after = first + count;
    const Point begin = stops_[first].begin, end = stops_[after - 1].end;
    const Point before = stops_[first - 1].end;
    const double closed = after < stops_.size() ? way(before, after) : 0;
    const double freed = ways_[first] + ways_[after] - closed;
    double best = kGainMinMm;
    std::size_t best_at = 0;
    bool best_turned = false;
    const std::size_t from = first > kOrderReach ? first - kOrderReach : 1;
    for (std::size_t at = from; at < std::min(stops_.size() + 1, after + kOrderReach); ++at) {
      if (at >= first && at <= after) continue;
      const Point left = stops_[at - 1].end;
      const double gain = freed + ways_[at];
      if (gain - std::min(least_cost_mm(left, begin), least_cost_mm(left, end)) <= best) continue;
      const double to_begin = gain - cost_mm(left, begin), to_end = gain - cost_mm(left, end);
      if (std::max(to_begin, to_end) <= best) continue;
      const double straight = to_begin - way(end, at), turned = to_end - way(begin, at);
      if (std::max(straight, turned) <= best) continue;
      best = std::max(straight, turned);
      best_at = at;
      best_turned = turned > straight;
    }
    if (best_at == 0) return false;
    if (best_turned) turn(first, after - 1);
    const auto stop = [this](std::size_t i) {
      return stops_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    if (best_at < first) {
      std::rotate(stop(best_at), stop(first), stop(after));
      changed(best_at, after);
    } else {
      std::rotate(stop(first), stop(after), stop(best_at));
      changed(first, best_at);
    }
    return true;
  }

  std::vector<Stop> stops_;
  std::vector<double> ways_;            // to each stop; none to the first, and after the last
  std::vector<std::uint64_t> changed_;  // by block: the latest step that changed something
  std::vector<std::uint64_t> tried_;    // by place: the step; 0: not yet
  std::uint64_t step_ = 0;
};

double sum_of_travels(const std::vector<Road>& roads, Point from, double (*of)(Point, Point)) {
  double sum = 0;
  for (const Road& road : roads) {
    sum += of(from, road.points.front());
    from = end_of(road);
  }
  return sum;
}

}  // namespace

void improve_order(std::vector<Road>& roads, Point from) {
  if (roads.size() < 2) return;
  Order order(roads, from);
  for (int pass = 0; pass < kOrderPassesMax; ++pass) {
    if (!order.pass()) break;
  }
  roads = order.take(std::move(roads));
}

double travel_cost_mm(const std::vector<Road>& roads, Point from) {
  return sum_of_travels(roads, from, cost_mm);
}

double travel_mm(const std::vector<Road>& roads, Point from) {
  return sum_of_travels(roads, from, distance_mm);
}

}  // namespace core
