#include "host/part/arrangement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

#include "core/bed.h"         // Bed
#include "core/roads/brim.h"  // brim_reach

namespace host {
namespace {

using core::Box;
using core::Length;
using core::Point;

enum class Order { kFromMiddle, kFromCorner };

// How far the skirt reaches beyond the first layer's other roads.
Length skirt_reach(const core::Settings& settings) {
  if (settings.skirt_loops == 0) return {};
  return settings.skirt_distance + settings.road_width * settings.skirt_loops;
}

Point middle_of(const Box& box) {
  return {static_cast<std::int32_t>((std::int64_t{box.min.x} + box.max.x) / 2),
          static_cast<std::int32_t>((std::int64_t{box.min.y} + box.max.y) / 2)};
}

class Arranger {
 public:
  Arranger(const std::vector<Footprint>& things, const core::Settings& settings)
      : things_(things),
        bed_(settings),
        far_{static_cast<std::int32_t>(settings.bed_x.units()),
             static_cast<std::int32_t>(settings.bed_y.units())},
        gap_(object_gap(settings).units()),
        edge_(settings.centre ? first_layer_reach(settings) + skirt_reach(settings) : Length()),
        corner_(settings.centre ? Point{} : corner_of(settings)),
        by_size_(things.size()) {
    std::iota(by_size_.begin(), by_size_.end(), std::size_t{0});
    const auto area = [this](std::size_t i) {
      return things_[i].width.mm() * things_[i].depth.mm();
    };
    std::stable_sort(by_size_.begin(), by_size_.end(),
                     [&](std::size_t a, std::size_t b) { return area(a) > area(b); });
  }

  // Whether all of them have found a place.
  [[nodiscard]] bool place_all(Order order) {
    order_ = order;
    boxes_.clear();
    for (const std::size_t i : by_size_) {
      const std::optional<Box> box = best_place(things_[i]);
      if (!box) return false;
      boxes_.push_back(*box);
    }
    return true;
  }

  // All of them together go to the middle of the bed, if they can.
  void centre() {
    Box all;
    for (const Box& box : boxes_) all.add(box);
    const Point is = middle_of(all), wanted{far_.x / 2, far_.y / 2};
    std::vector<Box> moved = boxes_;
    for (Box& box : moved) {
      box = {{box.min.x + wanted.x - is.x, box.min.y + wanted.y - is.y},
             {box.max.x + wanted.x - is.x, box.max.y + wanted.y - is.y}};
      if (!on_bed(box)) return;
    }
    boxes_ = std::move(moved);
  }

  [[nodiscard]] std::vector<Point> corners() const {
    std::vector<Point> corners(things_.size());
    for (std::size_t i = 0; i < by_size_.size(); ++i) corners[by_size_[i]] = boxes_[i].min;
    return corners;
  }

  [[nodiscard]] std::size_t placed() const { return boxes_.size(); }
  [[nodiscard]] Length edge() const { return edge_; }

 private:
  static Point corner_of(const core::Settings& settings) {
    return {static_cast<std::int32_t>(settings.part_x.units()),
            static_cast<std::int32_t>(settings.part_y.units())};
  }

  [[nodiscard]] bool on_bed(const Box& box) const {
    const auto edge = static_cast<std::int32_t>(edge_.units());
    return box.min.x >= corner_.x && box.min.y >= corner_.y &&
           bed_.holds(
               Box{{box.min.x - edge, box.min.y - edge}, {box.max.x + edge, box.max.y + edge}});
  }

  [[nodiscard]] bool is_free(const Box& box) const {
    return std::none_of(boxes_.begin(), boxes_.end(), [&](const Box& other) {
      return box.min.x - other.max.x < gap_ && other.min.x - box.max.x < gap_ &&
             box.min.y - other.max.y < gap_ && other.min.y - box.max.y < gap_;
    });
  }

  // Less is better.
  [[nodiscard]] std::array<std::int64_t, 3> rank(const Box& box) const {
    if (order_ == Order::kFromCorner) return {box.min.y, box.min.x, 0};
    const Point at = middle_of(box);
    const std::int64_t x = at.x - far_.x / 2, y = at.y - far_.y / 2;
    return {x * x + y * y, box.min.y, box.min.x};
  }

  [[nodiscard]] std::optional<Box> best_place(const Footprint& thing) const {
    const auto width = static_cast<std::int32_t>(thing.width.units());
    const auto depth = static_cast<std::int32_t>(thing.depth.units());
    std::optional<Box> best;
    const auto look_at = [&](std::int64_t x, std::int64_t y) {
      if (x < 0 || y < 0 || x + width > far_.x || y + depth > far_.y) return;
      const Point from{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
      const Box box{from, {from.x + width, from.y + depth}};
      if (best && rank(*best) <= rank(box)) return;
      if (on_bed(box) && is_free(box)) best = box;
    };
    look_at((far_.x - width) / 2, (far_.y - depth) / 2);
    const std::int64_t edge = edge_.units();
    look_at(std::max<std::int64_t>(corner_.x, edge), std::max<std::int64_t>(corner_.y, edge));
    for (const Box& other : boxes_) {
      const std::array<std::int64_t, 2> beside{other.max.x + gap_, other.min.x - gap_ - width};
      const std::array<std::int64_t, 2> behind{other.max.y + gap_, other.min.y - gap_ - depth};
      const std::array<std::int64_t, 3> along_y{
          other.min.y, other.max.y - depth, (std::int64_t{other.min.y} + other.max.y - depth) / 2};
      const std::array<std::int64_t, 3> along_x{
          other.min.x, other.max.x - width, (std::int64_t{other.min.x} + other.max.x - width) / 2};
      for (const std::int64_t x : beside) {
        for (const std::int64_t y : along_y) look_at(x, y);
      }
      for (const std::int64_t y : behind) {
        for (const std::int64_t x : along_x) look_at(x, y);
        look_at(std::max<std::int64_t>(corner_.x, edge), y);  // the next row
      }
    }
    return best;
  }

  const std::vector<Footprint>& things_;
  core::Bed bed_;
  Point far_;  // the bed's back right corner
  std::int64_t gap_;
  Length edge_;
  Point corner_;  // nothing lies left of it, or before it
  std::vector<std::size_t> by_size_;
  Order order_ = Order::kFromMiddle;
  std::vector<Box> boxes_;  // placed so far, as by_size_
};

}  // namespace

Length first_layer_reach(const core::Settings& settings) {
  Length reach = core::brim_reach(settings);
  if (settings.raft_layers > 0) reach = std::max(reach, settings.raft_expansion);
  if (settings.supports != core::SupportPlace::kOff) {
    reach = std::max(reach, settings.support_xy_distance + settings.support_base_expansion);
  }
  return reach;
}

Length object_gap(const core::Settings& settings) {
  const Length reach = first_layer_reach(settings);
  const Length gap = std::max(settings.part_gap, reach * 2 + settings.road_width);
  return settings.sequential ? std::max(gap, settings.clearance_radius + reach) : gap;
}

core::Result<std::vector<Point>> arranged(const std::vector<Footprint>& things,
                                          const core::Settings& settings) {
  Arranger arranger(things, settings);
  if (settings.centre && arranger.place_all(Order::kFromMiddle)) {
    arranger.centre();
    return arranger.corners();
  }
  const std::size_t from_middle = arranger.placed();
  if (arranger.place_all(Order::kFromCorner)) {
    if (settings.centre) arranger.centre();
    return arranger.corners();
  }
  return core::Error{
      core::ErrorCode::kOutOfBounds,
      fmt::format("{} of the {} objects fit on the bed of {:g} x {:g} mm, {:g} mm from one another "
                  "and {:g} mm from its edges; print fewer, or set a smaller {}, "
                  "skirt_distance or brim_width",
                  std::max(from_middle, arranger.placed()), things.size(), settings.bed_x.mm(),
                  settings.bed_y.mm(), object_gap(settings).mm(), arranger.edge().mm(),
                  settings.sequential ? "clearance_radius" : "part_gap")};
}

}  // namespace host
