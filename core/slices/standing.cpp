#include "core/slices/standing.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/booleans/boolean.h"     // intersect
#include "core/regions/convex_hull.h"  // convex_hull, breadth_of

namespace core {
namespace {

// Of the square column that bends as easily.
double column_thickness_mm(const Ring& hull) {
  const Breadth breadth = breadth_of(hull);
  const double least = breadth.least_mm;
  return std::sqrt(std::sqrt(breadth.length_mm * least * least * least));
}

bool overlap(const Region& a, const Region& b) { return !intersect(a, b).empty(); }

// The narrowest brim that holds it, for comparing.
int brim_needed_mm(const StandingBody& body) {
  return brim_that_holds_mm(body.foot, body.height.mm()).value_or(kBrimAdvisedMax_mm + 1);
}

double slenderness_of(const StandingBody& body) { return slenderness(body.foot, body.height.mm()); }

}  // namespace

void Standing::add(const Slice& slice) {
  if (slice.region.empty() && on_bed_) return;
  if (slice.region != last_) follow(slice);
  for (Followed& island : islands_) {
    if (island.body) bodies_[whole(*island.body)].height = slice.top();
    judge_columns(island, slice.top());
  }
}

void Standing::follow(const Slice& slice) {
  std::vector<Island> found = core::islands(slice.region);
  if (found.size() > kStandingIslandsMax) {
    ended_.islands_not_followed += static_cast<std::int64_t>(found.size() - kStandingIslandsMax);
    found.resize(kStandingIslandsMax);
  }
  std::vector<Followed> above;
  above.reserve(found.size());
  for (Island& island : found) above.push_back(followed(std::move(island), slice));
  islands_ = std::move(above);
  last_ = slice.region;
  on_bed_ = false;
}

Standing::Followed Standing::followed(Island island, const Slice& slice) {
  const Ring hull = convex_hull(island.outer);
  const double thickness_mm = column_thickness_mm(hull);
  Followed above;
  above.box = box_of(island.outer);
  above.region = region_of(std::move(island));
  for (std::size_t i = 0; i < kColumnThicknesses_mm.size(); ++i) {
    if (thickness_mm < kColumnThicknesses_mm[i]) above.stretches[i] = {slice.bottom, thickness_mm};
  }
  if (on_bed_) start_body(above, hull);
  for (const Followed& below : islands_) {
    if (!below.box.overlaps(above.box) || !overlap(below.region, above.region)) continue;
    if (below.body) join(above, *below.body);
    for (std::size_t i = 0; i < kColumnThicknesses_mm.size(); ++i) {
      const Stretch& under = below.stretches[i];
      Stretch& stretch = above.stretches[i];
      if (stretch.thickest_mm == 0 || under.thickest_mm == 0) continue;
      stretch.bottom = std::min(stretch.bottom, under.bottom);
      stretch.thickest_mm = std::max(stretch.thickest_mm, under.thickest_mm);
    }
    // The widest stretch goes on: it is the same column.
    if (above.stretches.back().thickest_mm > 0) above.counted |= below.counted;
  }
  return above;
}

void Standing::start_body(Followed& island, const Ring& hull) {
  island.body = bodies_.size();
  bodies_.push_back({hull, island.region.area_mm2(), Length(), Length(), bodies_.size()});
}

std::size_t Standing::whole(std::size_t body) const {
  while (bodies_[body].part_of != body) body = bodies_[body].part_of;
  return body;
}

void Standing::join(Followed& island, std::size_t body) {
  body = whole(body);
  const std::size_t kept = island.body ? whole(*island.body) : body;
  island.body = kept;
  if (kept == body) return;
  Body& one = bodies_[kept];
  Body& other = bodies_[body];
  // Three that meet in one layer never stood as two.
  for (Body* joined : {&one, &other}) {
    if (joined->height > joined->joined_at) judge(*joined, brim_mm_, ended_);
    joined->joined_at = joined->height;
  }
  one.hull.insert(one.hull.end(), other.hull.begin(), other.hull.end());
  one.hull = convex_hull(std::move(one.hull));
  one.area_mm2 += other.area_mm2;
  other = {{}, 0, Length(), Length(), kept};
}

void Standing::judge_columns(Followed& island, Length top) {
  for (const Stretch& stretch : island.stretches) {
    if (stretch.thickest_mm == 0) continue;
    const double slender =
        (top - stretch.bottom).mm() / std::max(stretch.thickest_mm, kRoadBreadth_mm);
    if (slender < kColumnSlenderness) continue;
    if (!std::exchange(island.counted, true)) ++ended_.thin_columns;
    if (ended_.thinnest && slender <= ended_.thinnest->slenderness) continue;
    const Box& box = island.box;
    const auto middle = [](std::int64_t a, std::int64_t b) {
      return static_cast<std::int32_t>((a + b) / 2);
    };
    ended_.thinnest = {{middle(box.min.x, box.max.x), middle(box.min.y, box.max.y)},
                       stretch.bottom,
                       top,
                       stretch.thickest_mm,
                       slender};
  }
}

void Standing::judge(const Body& body, double brim_mm, StandingReport& report) {
  const StandingBody standing{foot_of(body.hull, body.area_mm2), body.height};
  const double slender = slenderness_of(standing);
  if (!report.slenderest || slender > slenderness_of(*report.slenderest)) {
    report.slenderest = standing;
  }
  if (!may_come_loose(with_brim(standing.foot, brim_mm), standing.height.mm())) return;
  ++report.loose_bodies;
  const auto need = [](const StandingBody& one) {
    return std::tuple(brim_needed_mm(one), slenderness_of(one));
  };
  if (!report.loosest || need(standing) > need(*report.loosest)) report.loosest = standing;
}

void Standing::next_object() {
  ended_ = report();
  last_ = Region();
  islands_.clear();
  bodies_.clear();
  on_bed_ = true;
}

StandingReport Standing::report() const {
  StandingReport report = ended_;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (whole(i) == i) judge(bodies_[i], brim_mm_, report);
  }
  return report;
}

}  // namespace core
