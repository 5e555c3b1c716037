#include "core/supports/pieces_that_meet.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/booleans/boolean.h"  // intersect
#include "core/geometry.h"          // Box, Ring

namespace core {
namespace {

struct Placed {
  Box box;
  std::size_t number = 0;
};

void sort_by_begin(std::vector<Placed>& all) {
  std::sort(all.begin(), all.end(), [](const Placed& a, const Placed& b) {
    return std::pair(a.box.min.x, a.number) < std::pair(b.box.min.x, b.number);
  });
}

}  // namespace

std::vector<Region> pieces_that_meet(std::vector<Region> pieces, const Region& region) {
  std::vector<Placed> placed, rings;
  for (std::size_t i = 0; i < pieces.size(); ++i) placed.push_back({pieces[i].box(), i});
  for (std::size_t i = 0; i < region.rings().size(); ++i) {
    rings.push_back({box_of(region.rings()[i]), i});
  }
  sort_by_begin(placed);
  sort_by_begin(rings);
  // From west to east: rings that have begun, and may reach the piece.
  std::vector<Placed> open;
  std::size_t next = 0;
  std::vector<std::uint8_t> meets(pieces.size(), 0);
  for (const Placed& piece : placed) {
    while (next < rings.size() && rings[next].box.min.x <= piece.box.max.x) {
      open.push_back(rings[next++]);
    }
    std::erase_if(open, [&](const Placed& ring) { return ring.box.max.x < piece.box.min.x; });
    std::vector<Ring> near;
    for (const Placed& ring : open) {
      if (ring.box.overlaps(piece.box)) near.push_back(region.rings()[ring.number]);
    }
    const Region part = Region::from_clean_rings(std::move(near));
    meets[piece.number] = intersect(pieces[piece.number], part).empty() ? 0 : 1;
  }
  std::vector<Region> found;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (meets[i] != 0) found.push_back(std::move(pieces[i]));
  }
  return found;
}

}  // namespace core
