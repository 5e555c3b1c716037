#include "core/roads/seams.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "core/limits.h"            // kSeamsMax
#include "core/regions/polyline.h"  // distance_mm

namespace core {

namespace {

// Of the cost of leaving the seam below, in merit: for each millimetre within the reach of a
// corner that goes on, for a jump beyond, and for a jump across the whole part.
constexpr double kMoveCostPerMm = 0.15;
constexpr double kJumpCost = 0.3;
constexpr double kFarCost = 0.1;
constexpr double kFarMm = 20;

// Of two places whose merits differ by less, the one farther back is taken.
constexpr double kAlikeMerit = 0.05;

double leaving_cost(double mm) {
  if (mm <= kSeamFollow.mm()) return kMoveCostPerMm * mm;
  return kJumpCost + kFarCost * std::min(1.0, mm / kFarMm);
}

// The part's rear as seen from the loop: the middle of its box, far behind it.
Point behind(const Box& box) {
  const std::int32_t side = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  const std::int32_t middle = box.min.x + (box.max.x - box.min.x) / 2;
  return {middle, std::min<std::int32_t>(box.max.y + side, kCoordinateMax)};
}

// REQUIRES: not all is alike.
RingPlace nearest_held_point(const SeamLoop& loop, const Road& road, Point to) {
  std::vector<RingPlace> places = loop.held_between;
  for (std::size_t i = 0; i < road.points.size(); ++i) {
    if (loop.held_points[i]) places.push_back({road.points[i], i});
  }
  return *std::min_element(places.begin(), places.end(), [to](RingPlace a, RingPlace b) {
    return distance_units(a.at, to) < distance_units(b.at, to);
  });
}

RingPlace nearest_held_place(const SeamLoop& loop, const Road& road, Point to) {
  const RingPlace nearest = nearest_place(road.points, to);
  return is_held(loop, road, nearest) ? nearest : nearest_held_point(loop, road, to);
}

RingPlace rear_place(const SeamLoop& loop, const Road& road) {
  return nearest_held_place(loop, road, behind(loop.box));
}

// Where nothing below says where.
RingPlace first_place(const SeamLoop& loop, const Road& road) {
  const SeamPlace* best = nullptr;
  for (const SeamPlace& corner : loop.corners) {
    if (best != nullptr) {
      const double more = corner.merit - best->merit;
      const auto back = std::pair(corner.place.at.y, corner.place.at.x);
      const bool farther_back = back > std::pair(best->place.at.y, best->place.at.x);
      if (more < -kAlikeMerit || (more <= kAlikeMerit && !farther_back)) continue;
    }
    best = &corner;
  }
  return best != nullptr && best->merit > 0 ? best->place : rear_place(loop, road);
}

RingPlace next_place(const SeamLoop& loop, const Road& road, Point below) {
  RingPlace best = nearest_held_place(loop, road, below);
  double best_value = -leaving_cost(distance_mm(best.at, below));
  for (const SeamPlace& corner : loop.corners) {
    const double value = corner.merit - leaving_cost(distance_mm(corner.place.at, below));
    if (value <= best_value) continue;
    best = corner.place;
    best_value = value;
  }
  return best;
}

std::uint64_t mixed(std::uint64_t value) {  // SOURCE: splitmix64, Steele and others 2014
  value += 0x9e3779b97f4a7c15;
  value = (value ^ value >> 30) * 0xbf58476d1ce4e5b9;
  value = (value ^ value >> 27) * 0x94d049bb133111eb;
  return value ^ value >> 31;
}

RingPlace random_place(const SeamLoop& loop, const Road& road, LayerIndex index,
                       std::size_t number) {
  const std::uint64_t hash = mixed(mixed(static_cast<std::uint64_t>(index)) + number);
  double way = static_cast<double>(hash >> 11) * 0x1p-53 * length_mm(road);
  for (std::size_t i = 0; i < road.points.size(); ++i) {
    const Point a = road.points[i], b = road.points[i + 1 < road.points.size() ? i + 1 : 0];
    const double mm = distance_mm(a, b);
    if (way < mm) return nearest_held_place(loop, road, between(a, b, way / mm));
    way -= mm;
  }
  return nearest_held_place(loop, road, road.points.front());
}

std::int64_t gap_between(const Box& box, Point p) {
  const std::int64_t x =
      std::max({std::int64_t{box.min.x} - p.x, std::int64_t{p.x} - box.max.x, std::int64_t{0}});
  const std::int64_t y =
      std::max({std::int64_t{box.min.y} - p.y, std::int64_t{p.y} - box.max.y, std::int64_t{0}});
  return std::max(x, y);
}

// A loop that passes by a remembered seam.
struct Meeting {
  bool kept = false;  // the layer below had no loop there
  double mm = 0;
  std::size_t seam = 0;
  std::size_t loop = 0;
  auto key() const { return std::tie(kept, mm, seam, loop); }
};

std::vector<Meeting> meetings(const SeamMemory& memory, const LayerRoads& roads,
                              const LayerSeams& seams) {
  std::vector<Meeting> all;
  for (std::size_t s = 0; s < memory.size(); ++s) {
    const RememberedSeam& seam = memory[s];
    for (std::size_t i = 0; i < seams.loops.size(); ++i) {
      const SeamLoop& loop = seams.loops[i];
      if (loop.hole != seam.hole || gap_between(loop.box, seam.at) > kSeamReach.units()) continue;
      const Road& road = roads.islands[loop.island][loop.road];
      const double mm = distance_mm(nearest_place(road.points, seam.at).at, seam.at);
      if (mm <= kSeamReach.mm()) all.push_back({seam.layers_ago > 0, mm, s, i});
    }
  }
  std::sort(all.begin(), all.end(),
            [](const Meeting& a, const Meeting& b) { return a.key() < b.key(); });
  return all;
}

}  // namespace

std::vector<RingPlace> SeamPlacer::place(LayerIndex index, const LayerRoads& roads,
                                         const LayerSeams& seams) {
  std::vector<RingPlace> places;
  if (position_ == SeamPosition::kNearest) return places;
  const auto road_of = [&](const SeamLoop& loop) -> const Road& {
    return roads.islands[loop.island][loop.road];
  };
  if (position_ != SeamPosition::kAligned) {
    for (std::size_t i = 0; i < seams.loops.size(); ++i) {
      const SeamLoop& loop = seams.loops[i];
      places.push_back(position_ == SeamPosition::kRear
                           ? rear_place(loop, road_of(loop))
                           : random_place(loop, road_of(loop), index, i));
    }
    return places;
  }
  std::vector<std::optional<RingPlace>> chosen(seams.loops.size());
  std::vector<bool> gone_on(memory_.size());
  for (const Meeting& meeting : meetings(memory_, roads, seams)) {
    if (chosen[meeting.loop] || gone_on[meeting.seam]) continue;
    const SeamLoop& loop = seams.loops[meeting.loop];
    chosen[meeting.loop] = next_place(loop, road_of(loop), memory_[meeting.seam].at);
    gone_on[meeting.seam] = true;
  }
  for (std::size_t i = 0; i < seams.loops.size(); ++i) {
    const SeamLoop& loop = seams.loops[i];
    places.push_back(chosen[i] ? *chosen[i] : first_place(loop, road_of(loop)));
  }
  remember(seams, places, gone_on);
  return places;
}

void SeamPlacer::remember(const LayerSeams& seams, const std::vector<RingPlace>& places,
                          const std::vector<bool>& gone_on) {
  std::vector<std::size_t> order(places.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  if (order.size() > kSeamsMax) {
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return seams.loops[a].length_mm > seams.loops[b].length_mm;
    });
    order.resize(kSeamsMax);
  }
  SeamMemory now;
  for (const std::size_t i : order) now.push_back({places[i].at, seams.loops[i].hole, 0});
  for (std::size_t i = 0; i < memory_.size() && now.size() < kSeamsMax; ++i) {
    RememberedSeam kept = memory_[i];
    if (!gone_on[i] && ++kept.layers_ago <= kSeamLayersKept) now.push_back(kept);
  }
  memory_ = std::move(now);
}

void set_starts(const LayerSeams& seams, const std::vector<RingPlace>& places, LayerRoads& roads) {
  for (std::size_t i = 0; i < seams.loops.size(); ++i) {
    const SeamLoop& loop = seams.loops[i];
    Road& road = roads.islands[loop.island][loop.road];
    if (!places.empty()) {
      start_at(road, places[i]);
      road.starts = {0};
      continue;
    }
    for (const SeamPlace& corner : loop.corners) {
      road.starts.push_back(static_cast<std::uint32_t>(corner.place.edge));
    }
    if (!road.starts.empty()) continue;
    for (std::size_t k = 0; k < loop.held_points.size(); ++k) {
      if (loop.held_points[k]) road.starts.push_back(static_cast<std::uint32_t>(k));
    }
    if (loop.held_between.empty()) continue;
    start_at(road, loop.held_between.front());
    road.starts = {0};
  }
  if (places.empty()) return;
  for (const SeamFollower& follower : seams.followers) {
    Road& road = roads.islands[follower.island][follower.road];
    start_at(road, nearest_place(road.points, places[follower.loop].at));
    road.starts = {0};
  }
}

}  // namespace core
