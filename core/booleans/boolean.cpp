#include "core/booleans/boolean.h"

#include <algorithm>
#include <utility>

#include "core/booleans/overlay.h"  // Overlay
#include "core/check.h"             // RIND_CHECK
#include "core/limits.h"            // kCoordinateMax

namespace core {
namespace {

constexpr WindingRule kAnywhere{WindingRule::Kind::kAtLeast, 1};
constexpr WindingRule kInBoth{WindingRule::Kind::kAtLeast, 2};
constexpr WindingRule kNotCancelled{WindingRule::Kind::kNonZero, 0};
constexpr WindingRule kOdd{WindingRule::Kind::kOdd, 0};

const WindingRule& winding_rule(FillRule rule) {
  if (rule == FillRule::kNonZero) return kNotCancelled;
  return rule == FillRule::kEvenOdd ? kOdd : kAnywhere;
}

Region both(const Region& a, const Region& b) {
  std::vector<Ring> rings = a.rings();
  rings.insert(rings.end(), b.rings().begin(), b.rings().end());
  sort_rings(rings);
  return Region::from_clean_rings(std::move(rings));
}

bool apart(const Region& a, const Region& b) { return !a.box().overlaps(b.box()); }

Overlay& overlay() {
  thread_local Overlay overlay;
  return overlay;
}

}  // namespace

Region clean(const std::vector<Ring>& rings, FillRule rule) {
  return clean_with_winding(rings, rule).region;
}

CleanedRings clean_with_winding(const std::vector<Ring>& rings, FillRule rule) {
  for (const Ring& ring : rings) {
    for (const Point p : ring) {
      RIND_CHECK(p.x >= -kCoordinateMax && p.x <= kCoordinateMax);
      RIND_CHECK(p.y >= -kCoordinateMax && p.y <= kCoordinateMax);
    }
  }
  if (rings.empty()) return {};
  Region region = overlay().combine(rings, winding_rule(rule));
  const std::int32_t least = region.empty() ? 0 : overlay().least_winding();
  return {std::move(region), least};
}

Region unite(const Region& a, const Region& b) {
  if (a.empty() || a == b) return b;
  if (b.empty()) return a;
  if (apart(a, b)) return both(a, b);
  return overlay().combine(a, 1, b, 1, kAnywhere);
}

Region intersect(const Region& a, const Region& b) {
  if (a.empty() || b.empty() || apart(a, b)) return {};
  if (a == b) return a;
  return overlay().combine(a, 1, b, 1, kInBoth);
}

Region subtract(const Region& a, const Region& b) {
  if (a.empty() || a == b) return {};
  if (b.empty() || apart(a, b)) return a;
  return overlay().combine(a, 1, b, -1, kAnywhere);
}

Region subtract_within(const Region& a, const Region& b) {
  std::vector<Ring> rings;
  rings.reserve(a.rings().size() + b.rings().size());
  rings = a.rings();
  for (Ring ring : b.rings()) {
    std::reverse(ring.begin() + 1, ring.end());
    rings.push_back(std::move(ring));
  }
  sort_rings(rings);
  return Region::from_clean_rings(std::move(rings));
}

Region exclusive_or(const Region& a, const Region& b) {
  if (a == b) return {};
  if (a.empty()) return b;
  if (b.empty()) return a;
  if (apart(a, b)) return both(a, b);
  return overlay().combine(a, 1, b, -1, kNotCancelled);
}

std::int64_t boolean_retries() { return overlay().retries(); }

}  // namespace core
