#include "core/slices/plane_crossing.h"

#include <utility>

#include "core/wide_product.h"  // rounded_share

namespace core {
namespace {

// a + (b − a) · part / whole, rounded to nearest, halves up. REQUIRES: 0 <= part <= whole.
std::int32_t between(std::int32_t a, std::int32_t b, std::int64_t part, std::int64_t whole) {
  const std::int64_t way = std::int64_t{b} - a;
  if (way == 0) return a;
  // |way| < 2^31: below this all that follows fits 64 bits.
  constexpr std::int64_t kNarrow = std::int64_t{1} << 30;
  if (whole >= kNarrow) return static_cast<std::int32_t>(a + rounded_share(way, part, whole));
  const std::int64_t doubled = 2 * way * part + whole;
  const std::int64_t quotient = doubled / (2 * whole);
  return static_cast<std::int32_t>(a + quotient - (doubled % (2 * whole) < 0 ? 1 : 0));
}

}  // namespace

Point plane_crossing(Vertex a, Vertex b, std::int64_t doubled_z) {
  if (b.z < a.z) std::swap(a, b);
  const std::int64_t part = doubled_z - 2 * a.z, whole = 2 * (b.z - a.z);
  return {between(a.x, b.x, part, whole), between(a.y, b.y, part, whole)};
}

}  // namespace core
