#include "tools/parts/outlines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace parts {
namespace {

double turn(const Corner& a, const Corner& b, const Corner& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool same(const Corner& a, const Corner& b) { return a.x == b.x && a.y == b.y; }

double area(const CornerRing& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Corner &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum / 2;
}

bool contains(const CornerRing& ring, const Corner& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Corner &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

// Whether a-b crosses c-d between their ends.
bool cross(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  if (same(a, c) || same(a, d) || same(b, c) || same(b, d)) return false;
  return (turn(a, b, c) > 0) != (turn(a, b, d) > 0) && (turn(c, d, a) > 0) != (turn(c, d, b) > 0);
}

bool sees(const CornerRing& ring, const Corner& a, const Corner& b) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (cross(a, b, ring[i], ring[(i + 1) % ring.size()])) return false;
  }
  return true;
}

// Joins a hole to the outline by a cut, there and back, between two corners that see one another.
// REQUIRES: holes farther to the right were joined before.
void join_hole(CornerRing& outline, const CornerRing& hole) {
  const auto right = static_cast<std::size_t>(
      std::max_element(hole.begin(), hole.end(),
                       [](const Corner& a, const Corner& b) { return a.x < b.x; }) -
      hole.begin());
  const Corner from = hole[right];
  std::vector<std::size_t> nearest(outline.size());
  for (std::size_t i = 0; i < nearest.size(); ++i) nearest[i] = i;
  const auto away = [&](std::size_t i) {
    return std::hypot(outline[i].x - from.x, outline[i].y - from.y);
  };
  std::sort(nearest.begin(), nearest.end(),
            [&](std::size_t a, std::size_t b) { return away(a) < away(b); });
  for (const std::size_t i : nearest) {
    const Corner& to = outline[i];
    if (to.x <= from.x || !sees(outline, from, to) || !sees(hole, from, to)) continue;
    // Where a corner is there twice, only one of them has the hole in its angle.
    const Corner& before = outline[(i + outline.size() - 1) % outline.size()];
    const Corner& after = outline[(i + 1) % outline.size()];
    const bool left_of_before = turn(before, to, from) > 0,
               left_of_after = turn(to, after, from) > 0;
    const bool convex = turn(before, to, after) > 0;
    if (convex ? !(left_of_before && left_of_after) : !(left_of_before || left_of_after)) continue;
    CornerRing way;
    for (std::size_t k = 0; k <= hole.size(); ++k) way.push_back(hole[(right + k) % hole.size()]);
    way.push_back(to);
    outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(i) + 1, way.begin(), way.end());
    return;
  }
}

// Whether the corner at `i` of what is left can be cut off.
bool is_ear(const CornerRing& ring, const std::vector<std::size_t>& left, std::size_t i) {
  const Corner& a = ring[left[(i + left.size() - 1) % left.size()]];
  const Corner& b = ring[left[i]];
  const Corner& c = ring[left[(i + 1) % left.size()]];
  if (!(turn(a, b, c) > 0)) return false;
  return std::none_of(left.begin(), left.end(), [&](std::size_t k) {
    const Corner& p = ring[k];
    if (same(p, a) || same(p, b) || same(p, c)) return false;
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
  });
}

// Cuts ears off, beginning after the last one, so that no corner has very many facets.
void fill(const FacetSink& sink, const CornerRing& ring, Looking looking) {
  std::vector<std::size_t> left(ring.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  std::size_t at = 0;
  for (std::size_t vain = 0; left.size() > 2 && vain <= left.size();) {
    at %= left.size();
    if (left.size() > 3 && !is_ear(ring, left, at)) {
      ++at;
      ++vain;
      continue;
    }
    const Corner& a = ring[left[(at + left.size() - 1) % left.size()]];
    const Corner& b = ring[left[at]];
    const Corner& c = ring[left[(at + 1) % left.size()]];
    sink(looking == Looking::kUp ? Facet{a, b, c} : Facet{a, c, b});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    ++at;
    vain = 0;
  }
}

}  // namespace

CornerRing rectangle(Corner at, double width, double depth) {
  return {at,
          {at.x + width, at.y, at.z},
          {at.x + width, at.y + depth, at.z},
          {at.x, at.y + depth, at.z}};
}

CornerRing reversed(CornerRing ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

void plate_sides(const FacetSink& sink, const Outlines& outlines, double height) {
  for (const CornerRing& ring : outlines) {
    CornerRing high = ring;
    for (Corner& corner : high) corner.z += height;
    band(sink, ring, high, Facing::kOutward);
  }
}

void plate_face(const FacetSink& sink, const Outlines& outlines, Looking looking) {
  for (const CornerRing& outer : outlines) {
    if (area(outer) < 0) continue;
    std::vector<const CornerRing*> holes;
    for (const CornerRing& hole : outlines) {
      if (area(hole) < 0 && contains(outer, hole.front())) holes.push_back(&hole);
    }
    const auto right_end = [](const CornerRing* ring) {
      double x = std::numeric_limits<double>::lowest();
      for (const Corner& corner : *ring) x = std::max(x, corner.x);
      return x;
    };
    std::sort(holes.begin(), holes.end(), [&](const CornerRing* a, const CornerRing* b) {
      return right_end(a) > right_end(b);
    });
    CornerRing joined = outer;
    for (const CornerRing* hole : holes) join_hole(joined, *hole);
    fill(sink, joined, looking);
  }
}

void plate(const FacetSink& sink, const Outlines& outlines, double height) {
  Outlines high = outlines;
  for (CornerRing& ring : high) {
    for (Corner& corner : ring) corner.z += height;
  }
  plate_face(sink, outlines, Looking::kDown);
  plate_sides(sink, outlines, height);
  plate_face(sink, high, Looking::kUp);
}

}  // namespace parts
