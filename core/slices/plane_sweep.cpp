#include "core/slices/plane_sweep.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/booleans/boolean.h"       // clean
#include "core/check.h"                  // RIND_CHECK
#include "core/regions/contact_check.h"  // surely_clean
#include "core/regions/simplify.h"       // simplify
#include "core/slices/inside_out.h"      // turn_inside_out
#include "core/slices/plane_crossing.h"  // is_above, plane_crossing
#include "core/slices/segment_chains.h"  // rings_of, OnOneLine
#include "core/slices/sound_rings.h"     // sound_rings

namespace core {
namespace {

// REQUIRES: the triangle has corners on both sides.
Segment cut_triangle(const Triangle& triangle, std::int64_t doubled_z) {
  Segment segment;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex& a = triangle.corners[i];
    const Vertex& b = triangle.corners[(i + 1) % 3];
    if (is_above(a, doubled_z) == is_above(b, doubled_z)) continue;
    // Seen from outside, the part is behind, and left of one who walks from left to right.
    (is_above(a, doubled_z) ? segment.from : segment.to) = plane_crossing(a, b, doubled_z);
  }
  return segment;
}

// Whether both facets stand upright on one line, as on a wall that goes straight up.
bool on_one_wall(const Triangle& a, const Triangle& b) {
  const auto flat = [](const Vertex& v) { return Point{v.x, v.y}; };
  const auto& [p, q, r] = a.corners;
  if (cross(flat(p), flat(q), flat(r)) != 0) return false;
  const Point start = flat(p), end = flat(q) == start ? flat(r) : flat(q);
  return std::all_of(b.corners.begin(), b.corners.end(),
                     [&](const Vertex& corner) { return cross(start, end, flat(corner)) == 0; });
}

// By lowest z, then by corners.
bool is_before(const Triangle& a, const Triangle& b) {
  const std::int64_t za = a.lowest_z(), zb = b.lowest_z();
  return za != zb ? za < zb : a.corners < b.corners;
}

// A mesh that is inside out gives the same part, and the same rings. Returns whether it is.
bool turn_outwards(std::vector<Ring>& rings) {
  double doubled_area = 0;
  for (const Ring& ring : rings) doubled_area += doubled_area_units(ring);
  if (doubled_area >= 0) return false;
  for (Ring& ring : rings) std::reverse(ring.begin() + 1, ring.end());
  return true;
}

// Equal slices are to be equal in memory: each ring from its lowest point on, rings in order.
std::vector<Ring> in_one_order(std::vector<Ring> rings) {
  for (Ring& ring : rings) {
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  }
  std::sort(rings.begin(), rings.end());
  return rings;
}

}  // namespace

PlaneSweep::PlaneSweep(const Options& options, TriangleSource source)
    : options_(options), source_(std::move(source)) {
  RIND_CHECK(options.simplify_tolerance.units() >= 0);
  RIND_CHECK(options.chain_gap_max.units() >= 0);
}

Status PlaneSweep::take_triangles_below(std::int64_t doubled_z) {
  std::erase_if(held_, [&](const Triangle& t) { return 2 * t.highest_z() < doubled_z; });
  while (true) {
    if (!waiting_ && !source_ended_) {
      Result<std::optional<Triangle>> next = source_();
      if (!next.ok()) return next.error();
      source_ended_ = !next.value().has_value();
      waiting_ = next.value();
    }
    if (!waiting_ || 2 * waiting_->lowest_z() >= doubled_z) break;
    if (2 * waiting_->highest_z() >= doubled_z) held_.push_back(*waiting_);
    waiting_.reset();
  }
  peak_triangles_held_ = std::max(peak_triangles_held_, static_cast<std::int64_t>(held_.size()));
  return {};
}

void PlaneSweep::cut() {
  segments_.clear();
  segments_.reserve(held_.size());
  for (const Triangle& triangle : held_) segments_.push_back(cut_triangle(triangle, doubled_z_));
}

Result<bool> PlaneSweep::advance() {
  if (options_.layers && next_index_ == *options_.layers) return false;
  doubled_z_ = options_.heights.doubled_plane(next_index_);
  if (Status taken = take_triangles_below(doubled_z_); !taken.ok()) return taken.error();
  const bool over = held_.empty() && !waiting_ && source_ended_;
  if (!options_.layers && over) return false;
  ++next_index_;
  return true;
}

SliceRings PlaneSweep::rings(SliceDefects& defects) {
  const OnOneLine on_one_line = [this](SegmentIndex a, SegmentIndex b) {
    return on_one_wall(held_[a], held_[b]);
  };
  cut();
  if (auto sound = sound_rings(segments_, on_one_line)) return {*std::move(sound), {}};
  // Of what is there twice, one is taken: which one must not depend on the source's order.
  std::sort(held_.begin(), held_.end(), is_before);
  cut();
  return rings_of(segments_, options_.chain_gap_max, on_one_line, defects);
}

Region PlaneSweep::region_of(SliceRings contours, SliceDefects& defects) const {
  std::vector<Ring>& rings = contours.rings;
  // Bodies that are there twice, once inside out: their contours nest.
  std::vector<Ring> twice;
  for (Ring& ring : contours.cancelled) {
    if (!stands_out(ring, rings)) continue;
    defects.doubled_facets += static_cast<std::int64_t>(ring.size());
    twice.push_back(std::move(ring));
  }
  if (!twice.empty()) {
    const Region bodies = clean(twice, FillRule::kEvenOdd);
    rings.insert(rings.end(), bodies.rings().begin(), bodies.rings().end());
  }
  // Most slices are clean as they are; in_one_order() has been here.
  const bool clean_already = !options_.unsure && twice.empty() && surely_clean(rings);
  if (clean_already) return Region::from_clean_rings(rings);
  CleanedRings cleaned = clean_with_winding(rings, FillRule::kNonZero);
  if (cleaned.least_winding < 0 || options_.unsure) {
    const TurnedRings turned = turn_inside_out(rings, options_.unsure);
    defects.turned_contours = turned.count;
    defects.turned_at = turned.first;
    if (turned.count > 0) cleaned.region = clean(rings, FillRule::kNonZero);
  }
  return Region::from_clean_rings(in_one_order(cleaned.region.rings()));
}

Result<std::optional<SliceDefects>> PlaneSweep::next_defects() {
  const Result<bool> more = advance();
  if (!more.ok()) return more.error();
  if (!more.value()) return std::optional<SliceDefects>();
  SliceDefects defects;
  (void)rings(defects);
  return std::optional<SliceDefects>(defects);
}

Result<std::optional<Slice>> PlaneSweep::next() {
  const Result<bool> more = advance();
  if (!more.ok()) return more.error();
  if (!more.value()) return std::optional<Slice>();
  Slice slice;
  slice.index = next_index_ - 1;
  slice.bottom = options_.heights.bottom(slice.index);
  slice.height = options_.heights.height(slice.index);
  SliceRings contours = rings(slice.defects);
  for (std::vector<Ring>* kind : {&contours.rings, &contours.cancelled}) {
    for (Ring& ring : *kind) ring = simplify(ring, options_.simplify_tolerance);
    std::erase_if(*kind, [](const Ring& ring) { return ring.empty(); });
  }
  const bool inside_out = turn_outwards(contours.rings);
  if (!contours.rings.empty()) {
    // A body that is turned otherwise than what was there below, and is alone here.
    if (inside_out_.value_or(inside_out) != inside_out) {
      slice.defects.turned_contours = static_cast<std::int64_t>(contours.rings.size());
      slice.defects.turned_at = contours.rings[0][0];
    }
    if (!inside_out_) inside_out_ = inside_out;
  }
  contours.rings = in_one_order(std::move(contours.rings));
  if (contours != last_rings_) {
    last_turned_ = {};
    last_region_ = region_of(contours, last_turned_);
    last_rings_ = std::move(contours);
  }
  slice.defects.add(last_turned_);
  slice.region = last_region_;
  return std::optional<Slice>(std::move(slice));
}

}  // namespace core
