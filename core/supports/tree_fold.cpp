#include "core/supports/tree_fold.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/booleans/boolean.h"          // clean, intersect, subtract, unite
#include "core/booleans/simplified.h"       // simplified
#include "core/check.h"                     // RIND_CHECK
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/regions/point_location.h"    // PointLocation
#include "core/rounded.h"                   // rounded
#include "core/supports/support_regions.h"  // grown, kSupportTolerance, shared
#include "core/supports/tree_reach.h"       // blocked_for_branches, branch_core, branch_step
#include "core/supports/tree_standing.h"    // branch_overhang
#include "core/supports/tree_tips.h"        // tip_places
#include "core/trigonometry.h"              // cosine, sine

namespace core {
namespace {

// A branch is laid as a polygon of so many corners, its radius in whole multiples of this, so that
// straight ones stay the same for some layers.
constexpr int kDiscCorners = 24;
constexpr double kRadiusGrain = 500;

// A tip is left out where there is a branch within this share of their spacing.
constexpr double kTipNearShare = 0.6;

Ring disc(Point centre, double radius) {
  Ring ring;
  ring.reserve(kDiscCorners);
  for (int i = 0; i < kDiscCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kDiscCorners;
    ring.push_back(
        {centre.x + rounded(radius * cosine(angle)), centre.y + rounded(radius * sine(angle))});
  }
  return ring;
}

double laid_radius(double radius) {
  return std::max(kRadiusGrain, std::floor(radius / kRadiusGrain) * kRadiusGrain);
}

// Whether nothing of a disc, or next to nothing, is outside the region.
bool covered(const TreeNode& node, const PointLocation& region) {
  if (!region.contains(node.at)) return false;
  for (const double share : {0.5, 1.0}) {
    const Ring around = disc(node.at, laid_radius(node.radius) * share);
    if (std::any_of(around.begin(), around.end(),
                    [&](Point point) { return !region.contains(point); })) {
      return false;
    }
  }
  return true;
}

}  // namespace

TreeFold::TreeFold(const Settings& settings)
    : settings_(settings),
      roofs_(settings),
      nodes_(settings),
      beyond_bed_(
          offset(blocked_for_branches({}, settings), branch_core(settings), kSupportTolerance)) {}

void TreeFold::push(FoldSlice slice, SharedRegion avoided) {
  roofs_.push(slice);
  levels_.push_back({std::move(slice), std::move(avoided)});
}

const TreeFold::Level* TreeFold::level(LayerIndex index) const {
  if (levels_.empty() || index > levels_.front().slice.index) return nullptr;
  const auto place = static_cast<std::size_t>(levels_.front().slice.index - index);
  return place < levels_.size() ? &levels_[place] : nullptr;
}

std::optional<SupportLayer> TreeFold::next() {
  std::optional<SupportLayer> roof = roofs_.next();
  if (!roof) return {};
  const LayerIndex index = roof->index;
  const Level* at = level(index);
  RIND_CHECK(at != nullptr);
  SupportLayer layer = decide(*at, *std::move(roof));
  // Above the next layer, its gap and the layer that branches come from are asked for.
  const LayerIndex above = std::max(settings_.support_top_gap_layers, 1);
  while (levels_.size() > 1 && levels_.front().slice.index > index - 1 + above) {
    levels_.pop_front();
  }
  return layer;
}

Region TreeFold::slices_between(LayerIndex from, LayerIndex to) const {
  Region all;
  const Region* last = nullptr;
  for (LayerIndex i = from; i <= to; ++i) {
    const Level* at = level(i);
    if (at == nullptr || at->slice.region.get() == last) continue;
    last = at->slice.region.get();
    all = unite(all, *last);
  }
  return all;
}

// What a tip's place is away from what it holds, at most.
Length TreeFold::tip_reach() const {
  return branch_core(settings_) + settings_.support_xy_distance + settings_.road_width;
}

// A roof over what branches may reach.
Region TreeFold::within_reach(const Level& at, const Region& roof) const {
  if (settings_.supports != SupportPlace::kBed || roof.empty()) return roof;
  return subtract(roof, offset(*at.avoided, tip_reach(), kSupportTolerance));
}

SupportLayer TreeFold::decide(const Level& at, SupportLayer roof) {
  if (settings_.supports == SupportPlace::kBed && !roof.empty()) {
    roof.region = shared(within_reach(at, *roof.region));
    roof.interface = shared(intersect(*roof.interface, *roof.region));
  }
  const bool begins = roof_above_ && !roof_above_->empty() && roof_above_ != roof.region;
  const SharedRegion roof_above = std::exchange(roof_above_, roof.region);
  if (nodes_.all().empty() && !begins) return roof;
  const Level* above = level(at.slice.index + 1);
  RIND_CHECK(above != nullptr);
  look(at);
  const Length planes = Length::from_units((at.slice.height + above->slice.height).units() / 2);
  const Length step = branch_step(planes, settings_);
  nodes_.descend({at.slice.bottom, at.slice.height, step, avoided_.get(), blocked_.get()});
  if (begins) {
    start_tips(subtract(*roof_above, grown(*roof.region, step)), above->slice.height);
  }
  const Region on_part = laid_on_part(at);
  const Region branches = subtract(unite(laid_to_bed(at), on_part), *roof.region);
  SupportLayer layer{at.slice.index, roof.region, roof.interface, shared(branches), nullptr, step};
  if (branches.empty()) return layer;
  layer.region = shared(unite(*roof.region, branches));
  if (on_part.empty()) return layer;
  const LayerIndex bottom = at.slice.index - settings_.support_bottom_gap_layers - 1;
  const Length beside = settings_.support_xy_distance + branch_overhang(step);
  layer.feet =
      shared(intersect(on_part, grown(slices_between(bottom, at.slice.index - 1), beside)));
  const Region under =
      slices_between(bottom - settings_.support_bottom_interface_layers + 1, bottom);
  layer.interface = shared(unite(*roof.interface, intersect(on_part, under)));
  return layer;
}

void TreeFold::look(const Level& at) {
  if (avoided_of_ != at.avoided) {
    avoided_of_ = at.avoided;
    avoided_ = std::make_unique<TreeObstacle>(*at.avoided);
    cut_ = offset(*at.avoided, branch_core(settings_), kSupportTolerance);
  }
  if (settings_.supports == SupportPlace::kBed || blocked_of_ == at.slice.region) return;
  blocked_of_ = at.slice.region;
  blocked_ = std::make_unique<TreeObstacle>(blocked_for_branches(*at.slice.region, settings_));
}

void TreeFold::start_tips(const Region& open, Length height) {
  const Length near = scaled(settings_.support_tip_spacing, kTipNearShare);
  const auto radius = static_cast<double>(branch_core(settings_).units());
  for (const Point place : tip_places(open, height, settings_)) {
    if (nodes_.any_near(place, near)) continue;
    const std::optional<Point> to_bed = avoided_->nearest_free(place, tip_reach());
    if (to_bed) {
      if (*to_bed == place || !nodes_.any_near(*to_bed, scaled(near, 0.5))) {
        nodes_.start({*to_bed, radius, true});
      }
    } else if (settings_.supports == SupportPlace::kEverywhere) {
      nodes_.start({blocked_->nearest_free(place, tip_reach()).value_or(place), radius, false});
    }
  }
}

Region TreeFold::branches(const Level& at, bool to_bed) const {
  const Length base = std::max(settings_.support_base_expansion - at.slice.bottom, Length());
  std::vector<Ring> discs;
  for (const TreeNode& node : nodes_.all()) {
    if (node.to_bed != to_bed) continue;
    discs.push_back(disc(node.at, laid_radius(node.radius) + static_cast<double>(base.units())));
  }
  return discs.empty() ? Region() : clean(discs, FillRule::kPositive);
}

// What the cut leaves of a branch beyond an obstacle has another way down, or none: it is left out.
Region TreeFold::with_cores(const Region& laid) const {
  std::vector<Ring> kept;
  for (Island& island : islands(laid)) {
    const Box box = box_of(island.outer);
    const Region piece = region_of(std::move(island));
    const bool core = std::any_of(nodes_.all().begin(), nodes_.all().end(), [&](const auto& node) {
      return node.to_bed && box.overlaps({node.at, node.at}) && piece.contains(node.at);
    });
    if (core) kept.insert(kept.end(), piece.rings().begin(), piece.rings().end());
  }
  return Region::from_clean_rings(std::move(kept));
}

Region TreeFold::laid_to_bed(const Level& at) const {
  const Region discs = branches(at, true);
  if (discs.empty()) return {};
  const LayerIndex index = at.slice.index;
  return with_cores(subtract(subtract(discs, cut_),
                             slices_between(index + 1, index + settings_.support_top_gap_layers)));
}

Region TreeFold::laid_on_part(const Level& at) {
  const LayerIndex index = at.slice.index;
  const Region discs = branches(at, false);
  if (discs.empty()) return {};
  const Region simple = simplified(*at.slice.region, kSupportTolerance);
  Region around = unite(grown(simple, settings_.support_xy_distance + kSupportTolerance * 2),
                        slices_between(index - settings_.support_bottom_gap_layers, index - 1));
  around = unite(around, beyond_bed_);
  const PointLocation where(around);
  nodes_.end_where([&](const TreeNode& node) { return !node.to_bed && covered(node, where); });
  return subtract(subtract(discs, around),
                  slices_between(index + 1, index + settings_.support_top_gap_layers));
}

}  // namespace core
