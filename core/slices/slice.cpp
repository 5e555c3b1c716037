#include "core/slices/slice.h"

#include <algorithm>

namespace core {

void SliceDefects::add(const SliceDefects& other) {
  closed_chains += other.closed_chains;
  dropped_chains += other.dropped_chains;
  wide_chains += other.wide_chains;
  widest_gap = std::max(widest_gap, other.widest_gap);
  flipped_facets += other.flipped_facets;
  doubled_facets += other.doubled_facets;
  turned_contours += other.turned_contours;
  if (!turned_at) turned_at = other.turned_at;
}

}  // namespace core
