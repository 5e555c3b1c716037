#include "core/roads/inside_fill.h"

#include <algorithm>
#include <utility>

#include "core/booleans/boolean.h"       // intersect, subtract, unite
#include "core/offsets/slice_offsets.h"  // perimeter_spacing
#include "core/roads/loose_fill.h"       // loose_roads
#include "core/walls/regularise.h"       // regularise_loose

namespace core {
namespace {

// What is wide enough for a road, and the strips that are not.
struct Sorted {
  Region wide, narrow;
};

Sorted sorted(Region region, Length road, Length arc_tolerance) {
  if (region.empty()) return {};
  Region wide = regularise_loose(region, {road, 0, arc_tolerance});
  if (wide == region) return {std::move(region), {}};
  Region narrow = subtract(region, wide);
  return {std::move(wide), std::move(narrow)};
}

Settings changed(Settings settings, const AreaChange& change) {
  settings.loose_density = change.density.value_or(settings.loose_density);
  settings.loose_pattern = change.pattern.value_or(settings.loose_pattern);
  return settings;
}

// Where the inside is filled otherwise than the settings say. Areas in which it is not the inside
// that differs don't part it.
ChangedAreas filling(const Slice& slice, const Settings& settings) {
  ChangedAreas some;
  if (!slice.areas) return some;
  for (const ChangedArea& area : *slice.areas) {
    if (!area.change.fills_otherwise()) continue;
    some.push_back({{area.change.density, area.change.pattern}, area.region});
  }
  some = parted(some);
  std::erase_if(some, [&](const ChangedArea& area) {
    return area.change.density.value_or(settings.loose_density) == settings.loose_density &&
           area.change.pattern.value_or(settings.loose_pattern) == settings.loose_pattern;
  });
  return some;
}

}  // namespace

std::vector<InsidePiece> inside_pieces(const Region& inside, const Slice& slice,
                                       const Settings& settings) {
  const Length road = perimeter_spacing(settings, slice.height);
  std::vector<InsidePiece> pieces;
  Region rest = inside;
  const ChangedAreas areas = filling(slice, settings);
  for (std::size_t i = areas.size(); i-- > 0 && !rest.empty();) {
    const ChangedArea& area = areas[i];
    if (!area.region.box().overlaps(rest.box())) continue;
    // Strips along the area's border that are too narrow stay with the rest.
    Region own = sorted(intersect(rest, area.region), road, settings.arc_tolerance).wide;
    if (own.empty()) continue;
    Sorted left = sorted(subtract(rest, own), road, settings.arc_tolerance);
    if (!left.narrow.empty()) own = unite(own, left.narrow);
    pieces.push_back({std::move(own), changed(settings, area.change)});
    rest = std::move(left.wide);
  }
  if (!rest.empty()) pieces.push_back({std::move(rest), settings});
  return pieces;
}

std::vector<Road> inside_fill(const Region& inside, const Region& within, const Slice& slice,
                              const Settings& settings) {
  if (!slice.areas) return loose_roads(inside, within, slice, settings);
  const std::vector<InsidePiece> pieces = inside_pieces(inside, slice, settings);
  std::vector<Road> roads;
  for (const InsidePiece& piece : pieces) {
    // Free ends reach into the wall, not into other pieces.
    const Region room =
        pieces.size() == 1 ? within : subtract(within, subtract(inside, piece.region));
    for (Road& road : loose_roads(piece.region, room, slice, piece.settings)) {
      roads.push_back(std::move(road));
    }
  }
  return roads;
}

}  // namespace core
