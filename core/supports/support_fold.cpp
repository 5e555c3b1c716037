#include "core/supports/support_fold.h"

#include <algorithm>
#include <utility>

#include "core/booleans/boolean.h"           // intersect, subtract, unite
#include "core/booleans/simplified.h"        // simplified
#include "core/check.h"                      // RIND_CHECK
#include "core/offsets/voronoi_mountain.h"   // offset
#include "core/supports/marked_hanging.h"    // marked_hanging
#include "core/supports/pieces_that_meet.h"  // pieces_that_meet
#include "core/supports/support_regions.h"   // grown, kSupportTolerance, scaled, shared

namespace core {
namespace {

// Demand narrower than this share of the narrowest road is opened away.
constexpr double kOpeningWidths = 1;

// Demand is opened this exactly: twice as coarse as what is laid keeps its distance to the part.
constexpr Length kDemandTolerance = kSupportTolerance * 2;

// Right under what hangs, supports come this much nearer to the part, as a share of the distance.
constexpr double kNearShare = 0.5;

// Pieces narrower than a road grow by this share of one, if they are as long. Corners of wide ones
// are not such pieces.
constexpr double kNarrowGrowth = 0.3;
constexpr Length kNarrowSlack = Length::from_units(500);
constexpr double kNarrowLength_mm = 0.8;

void append(const Region& region, std::vector<Ring>& rings) {
  rings.insert(rings.end(), region.rings().begin(), region.rings().end());
}

// Its contour may lie beyond the region's by the tolerance.
Region opened(const Region& region, Length by) {
  if (region.empty()) return region;
  return offset(offset(region, by, kDemandTolerance), -by, kDemandTolerance);
}

// Islands, each grown until it is about as wide as asked for.
Region widened(const Region& region, Length width) {
  Region all;
  for (Island& island : islands(region)) {
    const Region whole = region_of(std::move(island));
    const double breadth_mm = 2 * whole.area_mm2() / whole.perimeter_mm();
    all = unite(all, grown(whole, scaled(width - Length::from_mm(breadth_mm), 0.5)));
  }
  return all;
}

// What of a region is narrower than a road, but long enough to be held.
Region narrow_pieces(const Region& region, Length width) {
  const Length half = scaled(width, 0.5);
  const Region wide = grown(offset(region, half, kSupportTolerance), half + kNarrowSlack);
  std::vector<Ring> pieces;
  for (Island& island : islands(subtract(region, wide))) {
    const Region whole = region_of(std::move(island));
    if (whole.perimeter_mm() < 2 * kNarrowLength_mm) continue;
    append(whole, pieces);
  }
  return Region::from_clean_rings(std::move(pieces));
}

Region without_small(const Region& region, double area_min_mm2, const Region& but) {
  if (area_min_mm2 <= 0) return region;
  std::vector<Ring> kept, small;
  std::vector<Region> pieces;
  for (Island& island : islands(region)) {
    Region whole = region_of(std::move(island));
    const bool is_small = whole.area_mm2() < area_min_mm2;
    append(whole, is_small ? small : kept);
    if (is_small) pieces.push_back(std::move(whole));
  }
  if (pieces.empty()) return region;
  const Region common = intersect(Region::from_clean_rings(std::move(small)), but);
  for (const Region& piece : pieces_that_meet(std::move(pieces), common)) append(piece, kept);
  return Region::from_clean_rings(std::move(kept));
}

}  // namespace

SupportFold::SupportFold(const Settings& settings)
    : settings_(settings), heights_(settings), none_(shared({})) {}

const SupportFold::Level* SupportFold::level(LayerIndex index) const {
  if (levels_.empty() || index > levels_.front().slice.index) return nullptr;
  const auto place = static_cast<std::size_t>(levels_.front().slice.index - index);
  return place < levels_.size() ? &levels_[place] : nullptr;
}

void SupportFold::push(FoldSlice slice) {
  Level added{std::move(slice), none_, none_, none_, none_};
  if (levels_.empty()) {
    next_ = std::min(added.slice.index, decide_from_.value_or(added.slice.index));
    levels_.push_back(std::move(added));
    return;
  }
  const Level& above = levels_.back();
  RIND_CHECK(added.slice.index == above.slice.index - 1);
  added.overhangs = above.overhangs;
  added.islands = above.islands;
  added.enforced = above.enforced;
  const bool same = added.slice.region == above.slice.region;
  if (!same) {
    const Region& own = *added.slice.region;
    const Length planes = Length::from_units((added.slice.height + above.slice.height).units() / 2);
    const SupportMarks* marks = above.slice.marks.get();
    const MarkedHanging hanging = marked_hanging(
        *above.slice.region, own, planes, heights_.hold_at(above.slice.bottom), marks, settings_);
    Region islands = widened(hanging.islands, settings_.support_section_min);
    if (marks != nullptr && !islands.empty()) islands = subtract(islands, marks->blocked);
    if (!hanging.empty()) added.born = shared(unite(hanging.overhangs, islands));
    added.overhangs = shared(subtract(unite(*above.overhangs, hanging.overhangs), own));
    added.islands = shared(subtract(unite(*above.islands, islands), own));
    if (!hanging.enforced.empty() || !above.enforced->empty()) {
      added.enforced = shared(subtract(unite(*above.enforced, hanging.enforced), own));
      if (*added.enforced == *above.enforced) added.enforced = above.enforced;
    }
    if (*added.overhangs == *above.overhangs) added.overhangs = above.overhangs;
    if (*added.islands == *above.islands) added.islands = above.islands;
  }
  levels_.push_back(std::move(added));
  drop_above();
}

std::optional<SupportLayer> SupportFold::next() {
  if (next_ < 0) return {};
  const LayerIndex below =
      settings_.support_bottom_gap_layers + settings_.support_bottom_interface_layers;
  if (!ended_ && levels_.back().slice.index > next_ - below) return {};
  const Level* at = level(next_);
  RIND_CHECK(at != nullptr);
  SupportLayer layer = decide(*at);
  --next_;
  drop_above();
  return layer;
}

void SupportFold::drop_above() {
  const LayerIndex above = settings_.support_top_gap_layers + settings_.support_interface_layers;
  while (levels_.size() > 1 && levels_.front().slice.index > next_ + above) levels_.pop_front();
}

// There is no layer under the first one to leave out.
LayerIndex SupportFold::top_gap_over(LayerIndex index) const {
  return index == 0 ? 0 : settings_.support_top_gap_layers;
}

// All that the support of a layer depends on, besides how high it is.
std::vector<SharedRegion> SupportFold::inputs_of(LayerIndex index) const {
  const LayerIndex above = settings_.support_top_gap_layers + settings_.support_interface_layers;
  const LayerIndex below =
      settings_.support_bottom_gap_layers + settings_.support_bottom_interface_layers;
  const LayerIndex top_gap = top_gap_over(index);
  std::vector<SharedRegion> inputs;
  for (LayerIndex i = index + above; i >= index - below; --i) {
    const Level* at = level(i);
    inputs.push_back(at != nullptr ? at->slice.region : nullptr);
    if (i == index + top_gap) {
      inputs.push_back(at != nullptr ? at->overhangs : nullptr);
      inputs.push_back(at != nullptr ? at->islands : nullptr);
      inputs.push_back(at != nullptr ? at->enforced : nullptr);
    }
    if (i >= index + top_gap) {
      inputs.push_back(at != nullptr ? at->born : nullptr);
    }
  }
  return inputs;
}

Region SupportFold::united(LayerIndex from, LayerIndex to, SharedRegion Level::*what) const {
  Region all;
  for (LayerIndex i = from; i <= to; ++i) {
    if (const Level* at = level(i)) all = unite(all, *(at->*what));
  }
  return all;
}

Region SupportFold::slices_between(LayerIndex from, LayerIndex to) const {
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

// Demand that is wide enough to be held.
const Region& SupportFold::held_by(const Level& source) {
  if (held_.overhangs == source.overhangs && held_.islands == source.islands &&
      held_.enforced == source.enforced) {
    return held_.region;
  }
  const Length by = scaled(settings_.road_width_min, kOpeningWidths / 2);
  const Region overhangs = simplified(*source.overhangs, kDemandTolerance);
  const Region any_size = unite(*source.islands, *source.enforced);
  held_ = {source.overhangs, source.islands, source.enforced,
           unite(without_small(opened(overhangs, by), settings_.support_area_min_mm2, any_size),
                 *source.islands)};
  return held_.region;
}

const SupportFold::GrownSlice& SupportFold::grown_slice(const SharedRegion& slice) {
  if (grown_.of == slice) return grown_;
  const Length distance = settings_.support_xy_distance;
  const Region simple = simplified(*slice, kSupportTolerance);
  grown_ = {slice, grown(simple, distance), grown(simple, scaled(distance, kNearShare))};
  return grown_;
}

Region SupportFold::laid(const Level& at, const Level& source, Length base) {
  const LayerIndex index = at.slice.index, top_gap = top_gap_over(index);
  const Region recent =
      united(index + top_gap, index + top_gap + settings_.support_interface_layers, &Level::born);
  const bool roofs_only = settings_.support_style == SupportStyle::kTree;
  if (roofs_only && recent.empty()) return {};
  const Region& held = held_by(source);
  const auto& [of, far, near] = grown_slice(at.slice.region);
  Region region = roofs_only ? Region() : subtract(held, far);
  if (!recent.empty()) {
    const Region under = intersect(held, recent);
    region = unite(region, subtract(under, near));
  }
  const Region narrow = narrow_pieces(region, settings_.road_width);
  if (!narrow.empty()) {
    const Length by = scaled(settings_.road_width, kNarrowGrowth);
    region = unite(region, subtract(grown(narrow, by), near));
  }
  if (base > Length() && !roofs_only) region = unite(region, subtract(grown(region, base), far));
  region = subtract(region, slices_between(index + 1, index + top_gap));
  region = subtract(region, slices_between(index - settings_.support_bottom_gap_layers, index - 1));
  return simplified(region, kSupportTolerance);
}

Region SupportFold::interface_of(const Level& at, const Region& region) const {
  const LayerIndex index = at.slice.index, top = index + top_gap_over(index);
  const LayerIndex bottom = index - settings_.support_bottom_gap_layers - 1;
  Region near = united(top, top + settings_.support_interface_layers - 1, &Level::born);
  near =
      unite(near, slices_between(bottom - settings_.support_bottom_interface_layers + 1, bottom));
  return near.empty() ? near : intersect(region, near);
}

SupportLayer SupportFold::decide(const Level& at) {
  const LayerIndex index = at.slice.index;
  const Level* source = level(index + top_gap_over(index));
  if (source == nullptr || (source->overhangs->empty() && source->islands->empty())) {
    return {index, none_, none_};
  }
  const Length base = std::max(settings_.support_base_expansion - at.slice.bottom, Length());
  Made made{inputs_of(index), base, {index, none_, none_}};
  if (made_ && made_->base == base && made_->of == made.of) {
    made_->layer.index = index;
    return made_->layer;
  }
  Region region = laid(at, *source, base);
  Region interface = interface_of(at, region);
  made.layer = {index, shared(std::move(region)), shared(std::move(interface))};
  made_ = std::move(made);
  return made_->layer;
}

}  // namespace core
