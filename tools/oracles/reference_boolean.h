// The operations of boolean.h by Boost.Polygon: another, independent algorithm, several times
// slower. Tests and benches compare with it; the program does not use it.
#pragma once

#include <vector>

#include "core/booleans/boolean.h"  // FillRule

namespace core::reference {

[[nodiscard]] Region clean(const std::vector<Ring>& rings, FillRule rule);
[[nodiscard]] Region unite(const Region& a, const Region& b);
[[nodiscard]] Region intersect(const Region& a, const Region& b);
[[nodiscard]] Region subtract(const Region& a, const Region& b);
[[nodiscard]] Region exclusive_or(const Region& a, const Region& b);

}  // namespace core::reference
