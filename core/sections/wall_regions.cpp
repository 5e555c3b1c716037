#include "core/sections/wall_regions.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"          // intersect, subtract
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/walls/wall_style.h"          // window_decides

namespace core {
namespace {

// I(S) of the neighbour at its depth, as it was cut; or made again, into `made`.
const Region& inner_of(const LayerWindow::Neighbour& neighbour, Length arc_tolerance,
                       Region& made) {
  const Layer& layer = *neighbour.layer;
  if (layer.offsets != nullptr) {
    for (const InnerOffset& inner : layer.offsets->wall_inners) {
      if (inner.depth == neighbour.depth) return inner.region;
    }
  }
  made = layer.slice.region.empty()
             ? Region()
             : offset(layer.slice.region, neighbour.depth, arc_tolerance, ArcForm::kBothSides);
  return made;
}

// The formula, for any kind of set; `see` makes one of a region.
template <typename Set, typename See>
void split_wall(const LayerWindow& window, See see, Set& own, Set& uncovered, Set& neighbours) {
  const std::vector<LayerWindow::Neighbour> all = window.neighbours();
  const Length arc_tolerance = window.settings().arc_tolerance;
  Region made;
  const Set& slice = see(window.layer().slice.region);
  // A copy, for `made` changes. NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
  const Set inner = see(inner_of(all.front(), arc_tolerance, made));
  own = subtract(slice, inner);
  Set covered = window.reaches_out() ? Set() : inner;
  Set common = covered;
  for (std::size_t i = 1; i < all.size() && !covered.empty(); ++i) {
    covered = intersect(covered, see(all[i].layer->slice.region));
    common = intersect(common, see(inner_of(all[i], arc_tolerance, made)));
  }
  uncovered = subtract(inner, covered);
  neighbours = subtract(covered, common);
}

}  // namespace

WallRegions wall_regions(const LayerWindow& window) {
  WallRegions regions;
  const SplitLayer& layer = window.layer();
  if (!window_decides(window.settings())) {
    regions.further = layer.solid;
    return regions;
  }
  const auto same = [](const Region& region) -> const Region& { return region; };
  split_wall(window, same, regions.own, regions.uncovered, regions.neighbours);
  Region rest = layer.solid;
  for (const Region* region : {&regions.own, &regions.uncovered, &regions.neighbours}) {
    rest = subtract(rest, *region);
  }
  std::vector<Ring> kept;
  for (Island& island : islands(rest)) {
    const Region piece = region_of(std::move(island));
    if (2 * piece.area_mm2() < kFurtherWidthMin.mm() * piece.perimeter_mm()) continue;
    kept.insert(kept.end(), piece.rings().begin(), piece.rings().end());
  }
  regions.further = Region::from_clean_rings(std::move(kept));
  return regions;
}

WallSection wall_section(const LayerWindow& window, const SectionLine& line) {
  WallSection section;
  const SplitLayer& layer = window.layer();
  section.slice = section_of(layer.slice.region, line);
  section.loose = section_of(layer.loose, line);
  if (!window_decides(window.settings())) {
    section.further = subtract(section.slice, section.loose);
    return section;
  }
  const auto see = [&](const Region& region) { return section_of(region, line); };
  split_wall(window, see, section.own, section.uncovered, section.neighbours);
  section.further = subtract(section.slice, section.loose);
  for (const Intervals* known : {&section.own, &section.uncovered, &section.neighbours}) {
    section.further = subtract(section.further, *known);
  }
  std::erase_if(section.further, [](const Interval& interval) {
    return interval.to - interval.from < kFurtherWidthMin.units();
  });
  return section;
}

}  // namespace core
