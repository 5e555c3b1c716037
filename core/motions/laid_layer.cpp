#include "core/motions/laid_layer.h"

#include <utility>

#include "core/check.h"                    // RIND_CHECK
#include "core/motions/cooling.h"          // layer_cooling
#include "core/motions/fan_plan.h"         // fan_plan
#include "core/motions/height_slowdown.h"  // height_share
#include "core/motions/laid_areas.h"       // LaidAreas
#include "core/motions/road_pieces.h"      // RoadPieces
#include "core/motions/road_speeds.h"      // fan_share_least, full_speed_mm_s
#include "core/raft_heights.h"             // is_above_raft
#include "core/regions/polyline.h"         // distance_mm, length_mm
#include "core/regions/ring_corners.h"     // nearest_place
#include "core/roads/seams.h"              // opened, start_at

namespace core {
namespace {

// One layer at work.
class Laying {
 public:
  Laying(const Slice& slice, const Settings& settings, const LayerPace& pace)
      : slice_(slice), settings_(settings), areas_(slice.areas, settings), pieces_(settings) {
    laid_.pace = pace;
  }

  [[nodiscard]] LaidLayer lay(const std::vector<Road>& roads, std::optional<Point> from) {
    laid_.roads.reserve(roads.size());
    for (const Road& road : roads) add(road, from);
    plan();
    for (LaidRoad& road : laid_.roads) {
      for (LaidStretch& stretch : road.stretches) add_pieces(road, stretch);
    }
    return std::move(laid_);
  }

 private:
  void add(const Road& road, std::optional<Point> from) {
    RIND_CHECK(road.points.size() >= 2);
    LaidRoad& laid = laid_.roads.emplace_back(LaidRoad{road.kind,
                                                       is_small_perimeter(road),
                                                       road.layers,
                                                       road.closed,
                                                       road.spiral,
                                                       road.object,
                                                       {}});
    std::vector<WidthStretch> ways =
        width_stretches(as_laid(road, from), slice_.height * road.layers);
    if (!road.spiral) ways = areas_.cut(std::move(ways));
    laid.stretches.reserve(ways.size());
    for (WidthStretch& way : ways) laid.stretches.emplace_back().way = std::move(way);
  }

  // A closed road's end has a bead's blob, which its start's would double: it is opened at its
  // seam. A spiral's turn begins where the one below ended.
  [[nodiscard]] Road as_laid(const Road& road, std::optional<Point> from) const {
    if (!road.spiral) {
      const bool opens = road.closed && settings_.seam_gap > Length();
      return opens ? opened(road, settings_.seam_gap) : road;
    }
    Road turn = road;
    if (from) start_at(turn, nearest_place(turn.points, *from));
    return turn;
  }

  // The layer's cooling: each stretch's speed and its share of the fan.
  void plan() {
    std::vector<LaidWay> ways;
    std::vector<FanWish> wishes;
    const LayerPace& pace = laid_.pace;
    double travel_mm = 0;
    for (std::size_t i = 0; i < laid_.roads.size(); ++i) {
      LaidRoad& road = laid_.roads[i];
      if (i > 0) travel_mm += distance_mm(end_of(laid_.roads[i - 1]), start_of(road));
      for (LaidStretch& stretch : road.stretches) {
        const double mm = length_mm(stretch.way.points, stretch.way.closed);
        stretch.speed_mm_s = speed_mm_s(road, stretch.way);
        ways.push_back({mm, stretch.speed_mm_s, slowing_of(stretch.way.kind)});
        const double least = fan_share_least(settings_, stretch.way.kind, stretch.way.hold);
        wishes.push_back({mm, in_whole_percents(least * pace.fan_growth)});
      }
    }
    const LayerCooling cooling =
        layer_cooling(settings_, slice_.index,
                      travel_mm / (pace.speed_share * settings_.travel_speed_mm_s), ways);
    laid_.fan_share = cooling.fan_share;
    const std::vector<double> fan = fan_plan(cooling.fan_share, wishes);
    std::size_t way = 0;
    for (LaidRoad& road : laid_.roads) {
      for (LaidStretch& stretch : road.stretches) {
        const double slowdown = slowdown_of(cooling, slowing_of(stretch.way.kind));
        stretch.speed_mm_s =
            slowed_speed_mm_s(stretch.speed_mm_s, slowdown, settings_.slowed_speed_min_mm_s);
        stretch.fan_share = fan[way++];
      }
    }
  }

  static Point start_of(const LaidRoad& road) { return road.stretches.front().way.points.front(); }
  static Point end_of(const LaidRoad& road) {
    const WidthStretch& last = road.stretches.back().way;
    return last.closed ? last.points.front() : last.points.back();
  }

  [[nodiscard]] double speed_mm_s(const LaidRoad& road, const WidthStretch& way) const {
    const Settings* own = areas_.settings_of(way);
    return laid_.pace.speed_share *
           full_speed_mm_s(own != nullptr ? *own : settings_, slice_.index,
                           {road.kind, road.small, way.hold, way.area_mm2});
  }

  void add_pieces(const LaidRoad& road, LaidStretch& stretch) {
    stretch.sent_speed_mm_s = stretch.speed_mm_s;
    const bool arcs = laid_.pace.arcs && !road.spiral;
    const std::vector<RoadPiece>& pieces = pieces_.of(stretch.way, arcs, stretch.sent_speed_mm_s);
    stretch.first_piece = laid_.pieces.size();
    laid_.pieces.insert(laid_.pieces.end(), pieces.begin(), pieces.end());
    stretch.end_piece = laid_.pieces.size();
  }

  const Slice& slice_;
  const Settings& settings_;
  LaidAreas areas_;
  RoadPieces pieces_;
  LaidLayer laid_;
};

}  // namespace

LayerLaying::LayerLaying(const Settings& settings) : actions_(settings) {
  const std::size_t count = height_actions(settings).size();
  for (std::size_t done = 0; done <= count; ++done) {
    settings_.push_back(settings);
    actions_.apply(done, settings_.back());
  }
}

std::size_t LayerLaying::actions_below(Length bottom) const {
  return actions_.due(0, bottom).size();
}

LayerPace LayerLaying::pace(const Slice& slice, std::size_t actions, bool arcs) const {
  const Settings& settings = settings_.at(actions);
  return {actions,
          slice.index == 0,
          is_above_raft(settings, slice.index),
          arcs,
          height_share(settings, slice.top(), settings.height_slowdown_speed),
          fan_growth(settings, slice.index)};
}

LaidLayer LayerLaying::lay(const Slice& slice, const std::vector<Road>& roads,
                           const LayerPace& pace, std::optional<Point> from) const {
  return Laying(slice, settings_of(pace), pace).lay(roads, from);
}

}  // namespace core
