#include "core/roads/fuzzy_skin.h"

#include <cstdint>
#include <utility>

#include "core/regions/polyline.h"  // between, distance_units
#include "core/regions/region.h"    // doubled_area_units
#include "core/rounded.h"           // rounded

namespace core {
namespace {

constexpr double kStepMin = 0.75;  // point distances
constexpr double kStepRange = 0.5;

// A number from 0 up to, not including, 1. The mixing is that of splitmix64 (Steele, Lea, Flood,
// "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014).
class Chance {
 public:
  Chance(Point at, LayerIndex layer)
      : state_((static_cast<std::uint64_t>(static_cast<std::uint32_t>(at.x)) << 32U |
                static_cast<std::uint32_t>(at.y)) ^
               static_cast<std::uint64_t>(layer) * 0xd1342543de82ef95U) {}

  [[nodiscard]] double next() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t mixed = state_;
    mixed = (mixed ^ (mixed >> 30U)) * 0xbf58476d1ce4e5b9U;
    mixed = (mixed ^ (mixed >> 27U)) * 0x94d049bb133111ebU;
    mixed ^= mixed >> 31U;
    return static_cast<double>(mixed >> 11U) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

bool is_rough(const Road& road, const Settings& settings) {
  if (road.kind != RoadKind::kOuterPerimeter) return false;
  return settings.fuzzy_skin == FuzzySkin::kAll || !road.closed ||
         doubled_area_units(road.points) > 0;
}

class FuzzyRoad {
 public:
  FuzzyRoad(const Road& road, LayerIndex layer, const Settings& settings)
      : road_(road),
        layer_(layer),
        thickness_(static_cast<double>(settings.fuzzy_skin_thickness.units())),
        distance_(static_cast<double>(settings.fuzzy_skin_point_distance.units())) {}

  [[nodiscard]] Road make() {
    made_ = road_;
    made_.points.clear();
    made_.widths.clear();
    made_.holds.clear();
    const std::size_t count = road_.points.size();
    double next = 0;  // from the segment's start to the next point
    for (std::size_t i = 0; i + (road_.closed ? 0 : 1) < count; ++i) {
      const double length = distance_units(road_.points[i], road_.points[(i + 1) % count]);
      while (next < length) {
        put(i, length, next);
        next += step_;
      }
      next -= length;
    }
    // A closed road's last point is not next to its first.
    if (!road_.closed) {
      const double length = distance_units(road_.points[count - 2], road_.points[count - 1]);
      if (length > 0) put(count - 2, length, length);
    } else if (made_.points.size() > 3 && next < distance_ / 4) {
      drop_last();
    }
    if (made_.points.size() < (road_.closed ? 3U : 2U)) return road_;
    return std::move(made_);
  }

 private:
  // A point so far along the segment from point i, moved across it.
  void put(std::size_t i, double length, double along) {
    const std::size_t j = (i + 1) % road_.points.size();
    const Point from = road_.points[i], to = road_.points[j];
    const Point at = between(from, to, along / length);
    Chance chance(at, layer_);
    const double aside = (2 * chance.next() - 1) * thickness_ / length;
    step_ = distance_ * (kStepMin + kStepRange * chance.next());
    const double dx = static_cast<double>(to.x) - from.x, dy = static_cast<double>(to.y) - from.y;
    made_.points.push_back({at.x + rounded(-dy * aside), at.y + rounded(dx * aside)});
    if (!road_.widths.empty()) {
      const double a = road_.widths[i].mm(), b = road_.widths[j].mm();
      made_.widths.push_back(Length::from_mm(a + (b - a) * along / length));
    }
    if (!road_.holds.empty()) made_.holds.push_back(road_.holds[i]);
  }

  void drop_last() {
    made_.points.pop_back();
    if (!made_.widths.empty()) made_.widths.pop_back();
    if (!made_.holds.empty()) made_.holds.pop_back();
  }

  const Road& road_;
  LayerIndex layer_;
  double thickness_;  // units
  double distance_;   // units
  double step_ = 0;   // units, from the last point to the next
  Road made_;
};

}  // namespace

void make_fuzzy(std::vector<Road>& roads, LayerIndex layer, const Settings& settings) {
  if (settings.fuzzy_skin == FuzzySkin::kNone || layer == 0) return;
  for (Road& road : roads) {
    if (is_rough(road, settings)) road = FuzzyRoad(road, layer, settings).make();
  }
}

}  // namespace core
