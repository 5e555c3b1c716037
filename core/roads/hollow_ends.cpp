#include "core/roads/hollow_ends.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/booleans/boolean.h"    // subtract
#include "core/regions/polyline.h"    // between, distance_mm
#include "core/roads/branch_roads.h"  // branch_beads

namespace core {
namespace {

// Roads are looked at in steps of this.
constexpr double kStep_mm = 0.1;

// A road in small steps.
struct Trace {
  std::vector<Point> points;
  std::vector<Length> widths;
};

Trace trace_of(const Road& road) {
  Trace trace;
  const std::size_t count = road.points.size();
  for (std::size_t i = 0; i < (road.closed ? count : count - 1); ++i) {
    const std::size_t next = (i + 1) % count;
    const Point from = road.points[i], to = road.points[next];
    const int steps = std::max(1, static_cast<int>(std::ceil(distance_mm(from, to) / kStep_mm)));
    const double first = width_at(road, i).mm(), last = width_at(road, next).mm();
    for (int step = 0; step < steps; ++step) {
      const double share = static_cast<double>(step) / steps;
      trace.points.push_back(between(from, to, share));
      trace.widths.push_back(Length::from_mm(first + share * (last - first)));
    }
  }
  const std::size_t end = road.closed ? 0 : count - 1;
  trace.points.push_back(road.points[end]);
  trace.widths.push_back(width_at(road, end));
  return trace;
}

// Where the longest stretch in the air of a closed road begins; none: the number of its steps.
std::size_t longest_in_air(const Trace& trace, const PointLocation& hollow) {
  const std::size_t steps = trace.points.size() - 1;
  std::size_t best = steps, longest = 0, run = 0;
  for (std::size_t i = 0; i < 2 * steps; ++i) {
    run = hollow.contains(trace.points[i % steps]) ? run + 1 : 0;
    if (run <= longest) continue;
    longest = run;
    best = (i + 1 - run) % steps;
  }
  return best;
}

double length_in_air_mm(const Trace& trace, std::size_t from, const PointLocation& hollow) {
  const std::size_t steps = trace.points.size() - 1;
  double mm = 0;
  for (std::size_t i = 0; i < steps && hollow.contains(trace.points[(from + i) % steps]); ++i) {
    mm += distance_mm(trace.points[(from + i) % steps], trace.points[(from + i + 1) % steps]);
  }
  return mm;
}

// A closed road opened where it is in the air; false where it is not, for a long stretch: held at
// both ends, it spans bridge_max.
bool open_in_air(Trace& trace, const PointLocation& hollow, Length bridge_max) {
  const std::size_t at = longest_in_air(trace, hollow);
  if (at + 1 >= trace.points.size()) return false;
  if (length_in_air_mm(trace, at, hollow) <= bridge_max.mm()) return false;
  trace.points.pop_back();
  trace.widths.pop_back();
  const auto first = static_cast<std::ptrdiff_t>(at);
  std::rotate(trace.points.begin(), trace.points.begin() + first, trace.points.end());
  std::rotate(trace.widths.begin(), trace.widths.begin() + first, trace.widths.end());
  return true;
}

// Steps at the start that lie in the air; none where they are short.
std::size_t steps_in_air(const Trace& trace, const PointLocation& hollow) {
  double mm = 0;
  for (std::size_t i = 0; i < trace.points.size(); ++i) {
    if (i > 0) mm += distance_mm(trace.points[i - 1], trace.points[i]);
    if (!hollow.contains(trace.points[i])) return mm > kHollowStretchMax_mm ? i : 0;
  }
  return mm > kHollowStretchMax_mm ? trace.points.size() : 0;
}

void turn_round(Trace& trace) {
  std::reverse(trace.points.begin(), trace.points.end());
  std::reverse(trace.widths.begin(), trace.widths.end());
}

void cut_front(Trace& trace, std::size_t steps) {
  const auto cut = static_cast<std::ptrdiff_t>(steps);
  trace.points.erase(trace.points.begin(), trace.points.begin() + cut);
  trace.widths.erase(trace.widths.begin(), trace.widths.begin() + cut);
}

// False where nothing is left of it.
bool cut_ends(Road& road, const PointLocation& hollow, Length bridge_max) {
  Trace trace = trace_of(road);
  if (road.closed && !open_in_air(trace, hollow, bridge_max)) return true;
  bool any = false;
  for (int side = 0; side < 2; ++side) {
    const std::size_t steps = steps_in_air(trace, hollow);
    cut_front(trace, steps);
    if (trace.points.size() < 2) return false;
    any |= steps > 0;
    turn_round(trace);
  }
  if (!any) return true;
  road.closed = false;
  road.points = std::move(trace.points);
  road.widths = std::move(trace.widths);
  return true;
}

}  // namespace

bool has_pattern(const Settings& settings) {
  return settings.loose_density > 0 && settings.loose_pattern != LoosePattern::kLightning;
}

bool has_hollow_inside(const Settings& settings) {
  return settings.loose_roof != LooseRoof::kOff || !has_pattern(settings);
}

HollowEnds::HollowEnds(const SplitLayer& layer, const Settings& settings)
    : bridge_max_(settings.bridge_max) {
  if (!has_hollow_inside(settings) || !layer.below_loose || layer.below_loose->empty()) return;
  hollow_.emplace(layer.below_branches
                      ? subtract(*layer.below_loose, branch_beads(*layer.below_branches, settings))
                      : *layer.below_loose);
}

void HollowEnds::cut(std::vector<Road>& roads) const {
  if (!hollow_) return;
  const auto lost = [this](Road& road) {
    return road.kind == RoadKind::kGapFill && !cut_ends(road, *hollow_, bridge_max_);
  };
  roads.erase(std::remove_if(roads.begin(), roads.end(), lost), roads.end());
}

}  // namespace core
