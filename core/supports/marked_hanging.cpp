#include "core/supports/marked_hanging.h"

#include <utility>
#include <vector>

#include "core/booleans/boolean.h"  // intersect, subtract, unite
#include "core/geometry.h"          // Ring
#include "core/roads/unheld.h"      // islands_in_air

namespace core {
namespace {

// Strips narrower than this come from contours that were simplified.
constexpr double kNoiseMm = 0.01;

bool is_noise(const Region& piece) {
  return 2 * piece.area_mm2() < kNoiseMm * piece.perimeter_mm();
}

void append(const Region& region, std::vector<Ring>& rings) {
  rings.insert(rings.end(), region.rings().begin(), region.rings().end());
}

// What is enforced of what lies over no part of the slice below.
HangingRegions enforced_of(const Region& slice, const Region& below, const Region& enforced) {
  HangingRegions found;
  std::vector<Ring> begun;
  for (const Region& island : islands_in_air(slice, below)) append(island, begun);
  const Region islands_begun = Region::from_clean_rings(std::move(begun));
  if (!islands_begun.empty()) found.islands = intersect(islands_begun, enforced);
  std::vector<Ring> strips;
  for (Island& island : islands(subtract(intersect(slice, enforced), below))) {
    const Region strip = region_of(std::move(island));
    if (!is_noise(strip)) append(strip, strips);
  }
  found.overhangs = Region::from_clean_rings(std::move(strips));
  if (!found.islands.empty()) found.overhangs = subtract(found.overhangs, found.islands);
  return found;
}

}  // namespace

MarkedHanging marked_hanging(const Region& slice, const Region& below, Length planes,
                             bool by_itself, const SupportMarks* marks, const Settings& settings) {
  MarkedHanging found;
  if (by_itself) {
    HangingRegions hanging = hanging_regions(slice, below, planes, settings);
    found.islands = std::move(hanging.islands);
    found.overhangs = std::move(hanging.overhangs);
  }
  if (marks == nullptr) return found;
  if (!marks->enforced.empty()) {
    HangingRegions enforced = enforced_of(slice, below, marks->enforced);
    found.islands = unite(found.islands, enforced.islands);
    found.enforced = std::move(enforced.overhangs);
    found.overhangs = unite(found.overhangs, found.enforced);
    if (!found.islands.empty()) found.overhangs = subtract(found.overhangs, found.islands);
  }
  if (!marks->blocked.empty() && !found.empty()) {
    found.islands = subtract(found.islands, marks->blocked);
    found.overhangs = subtract(found.overhangs, marks->blocked);
    found.enforced = subtract(found.enforced, marks->blocked);
  }
  return found;
}

}  // namespace core
