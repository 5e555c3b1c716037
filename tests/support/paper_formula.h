// The solid region of layer n by the paper's own formula (DETC2000/DAC-14285, after figure 10): the
// oracle for core/walls/wall_splitter.h, which computes it in another way.
//
//     Offset(S_n) ∪ S_n ∩ ⋃_{i=1..T} [(S_{n+i-1} − S_{n+i}) ∪ (S_{n-i+1} − S_{n-i})
//                                      ∪ Offset(S_{n+i}) ∪ Offset(S_{n-i})],   Offset(S) = S − I(S)
//
// Set is a region, or another type with these three operations.
#pragma once

#include <cstddef>
#include <vector>

namespace test {

// Operations: unite(a, b), intersect(a, b), subtract(a, b). Set() is the empty set, which stands
// for the slices below and above the part. REQUIRES: 0 <= n < slices.size() == inners.size()
template <typename Operations, typename Set>
Set paper_solid(const std::vector<Set>& slices, const std::vector<Set>& inners, int n, int t) {
  const auto at = [](const std::vector<Set>& stack, int i) {
    return 0 <= i && i < static_cast<int>(stack.size()) ? stack[static_cast<std::size_t>(i)]
                                                        : Set();
  };
  const auto slice = [&](int i) { return at(slices, i); };
  const auto offset = [&](int i) { return Operations::subtract(slice(i), at(inners, i)); };
  Set extended{};
  const auto extend = [&](const Set& set) { extended = Operations::unite(extended, set); };
  for (int i = 1; i <= t; ++i) {
    extend(Operations::subtract(slice(n + i - 1), slice(n + i)));
    extend(Operations::subtract(slice(n - i + 1), slice(n - i)));
    extend(offset(n + i));
    extend(offset(n - i));
  }
  return Operations::unite(offset(n), Operations::intersect(slice(n), extended));
}

}  // namespace test
