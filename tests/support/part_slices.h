// All slices of an opened part, at once.
#pragma once

#include <doctest/doctest.h>

#include <utility>
#include <vector>

#include "core/slices/slice.h"    // Slice
#include "host/part/part_file.h"  // OpenedPart

namespace test {

// REQUIRES: none of them is refused.
inline std::vector<core::Slice> all_slices(host::OpenedPart& part) {
  std::vector<core::Slice> slices;
  while (true) {
    auto slice = part.layers->next();
    REQUIRE_MESSAGE(slice.ok(), (slice.ok() ? "" : slice.error().message));
    if (!slice.value()) return slices;
    slices.push_back(*std::move(slice).value());
  }
}

}  // namespace test
