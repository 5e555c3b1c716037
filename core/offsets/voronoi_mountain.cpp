#include "core/offsets/voronoi_mountain.h"

#include <algorithm>

#include "core/limits.h"                   // kDiagramTurnsMax
#include "core/offsets/capsule_offset.h"   // capsule_offset
#include "core/offsets/offset_walk.h"      // walk_offset
#include "core/offsets/polygon_offset.h"   // PolygonOffsetter
#include "core/offsets/voronoi_diagram.h"  // make_voronoi_diagram
#include "core/regions/contact_check.h"    // split_at_touches

namespace core {
namespace {

OffsetContours as_contours(const Region& region) {
  OffsetContours contours;
  for (const Ring& ring : region.rings()) {
    OffsetContour contour;
    for (const Point p : ring) contour.push_back({p, OffsetPiece::Kind::kLine, {}});
    contours.push_back(std::move(contour));
  }
  return contours;
}

// No point of the region is farther from its contours than half the box's shorter side.
bool deeper_than_any_point(const Region& region, Length depth) {
  const Box box = region.box();
  if (box.empty()) return true;
  const std::int64_t side =
      std::min(std::int64_t{box.max.x} - box.min.x, std::int64_t{box.max.y} - box.min.y);
  return 2 * depth.units() >= side;
}

}  // namespace

struct VoronoiMountain::Diagram {
  Region region;
  std::vector<Ring> rings;  // of the region, with corners wherever contours touch
  std::optional<VoronoiDiagram> voronoi;
  int retries = 0;
  int fallbacks = 0;

  void build(int first_turn) {
    voronoi = make_voronoi_diagram(rings, first_turn);
    const int last = voronoi ? voronoi->turns : kDiagramTurnsMax + 1;
    retries += last - (first_turn == 0 ? 0 : first_turn - 1);
  }

  OffsetContours offset(Length depth) {
    while (voronoi) {
      if (std::optional<OffsetContours> contours = walk_offset(*voronoi, depth)) return *contours;
      build(voronoi->turns + 1);
    }
    ++fallbacks;
    return as_contours(capsule_offset(region, depth));
  }
};

VoronoiMountain::VoronoiMountain(const Region& region) : diagram_(std::make_unique<Diagram>()) {
  diagram_->region = region;
  if (region.empty()) return;
  diagram_->rings = split_at_touches(region.rings());
  diagram_->build(0);
}

VoronoiMountain::~VoronoiMountain() = default;
VoronoiMountain::VoronoiMountain(VoronoiMountain&&) noexcept = default;
VoronoiMountain& VoronoiMountain::operator=(VoronoiMountain&&) noexcept = default;

OffsetContours VoronoiMountain::offset(Length depth) const {
  const Region& region = diagram_->region;
  if (depth == Length()) return as_contours(region);
  if (region.empty() || (depth > Length() && deeper_than_any_point(region, depth))) return {};
  return diagram_->offset(depth);
}

int VoronoiMountain::retries() const { return diagram_->retries; }
int VoronoiMountain::fallbacks() const { return diagram_->fallbacks; }

Region offset(const Region& region, Length depth, Length arc_tolerance, ArcForm form) {
  if (region.empty() || depth == Length()) return region;
  if (depth > Length() && deeper_than_any_point(region, depth)) return {};
  thread_local PolygonOffsetter offsetter;
  thread_local OffsetContours contours;
  offsetter.offset(region, std::span(&depth, 1), std::span(&contours, 1));
  return flatten(contours, arc_tolerance, form);
}

}  // namespace core
