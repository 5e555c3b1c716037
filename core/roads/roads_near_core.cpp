#include "core/roads/roads_near_core.h"

#include <algorithm>
#include <cmath>

#include "core/regions/contour_proximity.h"  // frechet_within
#include "core/regions/polyline.h"           // between, distance_mm
#include "core/regions/segment_grid.h"       // SegmentGrid
#include "core/regions/simplify.h"           // simplify

namespace core {

namespace {

// A point on a ring and whether the core is near it.
struct Sample {
  Point point;
  bool near = false;
  bool corner = false;  // of the ring; the others lie between two corners
};

// The ring's vertices, and points between them at most `step` apart.
std::vector<Sample> samples(const Ring& ring, const SegmentGrid& core, Length reach, Length step) {
  std::vector<Sample> all;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    const auto parts =
        std::max<std::int64_t>(1, std::llround(std::ceil(distance_mm(a, b) / step.mm())));
    for (std::int64_t part = 0; part < parts; ++part) {
      const Point p = between(a, b, static_cast<double>(part) / static_cast<double>(parts));
      all.push_back({p, core.any_within(p, reach), part == 0});
    }
  }
  return all;
}

// Runs of equal `near` shorter than `shortest` take their neighbours' value: first the gaps in
// what is kept, then the crumbs.
void smooth(std::vector<Sample>& ring, Length shortest) {
  for (const bool value : {false, true}) {
    const std::size_t count = ring.size();
    std::size_t start = 0;
    while (start < count && ring[start].near == value) ++start;
    if (start == count) return;
    for (std::size_t i = 0; i < count;) {
      const std::size_t first = (start + i) % count;
      if (ring[first].near != value) {
        ++i;
        continue;
      }
      std::size_t run = 0;
      double mm = 0;
      while (ring[(first + run) % count].near == value) {
        mm += distance_mm(ring[(first + run) % count].point, ring[(first + run + 1) % count].point);
        ++run;
      }
      if (mm < shortest.mm()) {
        for (std::size_t k = 0; k < run; ++k) ring[(first + k) % count].near = !value;
      }
      i += run;
    }
  }
}

// The runs of samples with `near` as asked, each as an open road.
void add_runs(const std::vector<Sample>& ring, bool near, Length width, RoadKind kind,
              std::vector<Road>& roads) {
  const std::size_t count = ring.size();
  std::size_t start = 0;
  while (ring[start].near == near) ++start;
  for (std::size_t i = 0; i < count;) {
    Road road{kind, width, false, {}};
    while (i < count && ring[(start + i) % count].near == near) {
      const Sample& sample = ring[(start + i) % count];
      ++i;
      const bool last = i == count || ring[(start + i) % count].near != near;
      if (road.points.empty() || last || sample.corner) road.points.push_back(sample.point);
    }
    if (road.points.empty()) ++i;
    if (road.points.size() >= 2) roads.push_back(std::move(road));
  }
}

bool all_near(const std::vector<Sample>& ring, bool near) {
  return std::all_of(ring.begin(), ring.end(), [&](const Sample& s) { return s.near == near; });
}

}  // namespace

std::vector<Road> roads_near_core(const Region& line, const Region& core, Length reach,
                                  Length width, RoadKind kind, Length tolerance) {
  std::vector<Road> roads;
  if (core.empty()) return roads;
  // The simplified rings stray from the line by the tolerance at most.
  const bool whole = reach > tolerance && frechet_within(line, core, reach - tolerance);
  const SegmentGrid grid(reach, whole ? Region() : core);
  for (const Ring& exact : line.rings()) {
    const Ring ring = simplify(exact, tolerance);
    if (ring.size() < 3) continue;
    if (whole || all_near(samples(ring, grid, reach, reach), true)) {
      roads.push_back({kind, width, true, ring});
      continue;
    }
    std::vector<Sample> fine = samples(
        ring, grid, reach, Length::from_units(std::max<std::int64_t>(1, reach.units() / 4)));
    smooth(fine, width);
    if (all_near(fine, true)) {
      roads.push_back({kind, width, true, ring});
    } else if (!all_near(fine, false)) {
      add_runs(fine, true, width, kind, roads);
    }
  }
  return roads;
}

}  // namespace core
