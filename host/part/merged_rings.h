// The rings of all objects in one layer. What marks or modifies an object may reach out of it, but
// not into others.
#pragma once

#include <vector>

#include "core/geometry.h"          // Box
#include "core/regions/region.h"    // Region, Ring
#include "core/slices/slice.h"      // Slice
#include "host/part/bed_placing.h"  // Shift

namespace host {

class MergedRings {
 public:
  // `room` is the part's own, before it is moved to its places.
  void add(const core::Slice& part, const core::Box& room, const std::vector<Shift>& places);
  // Not used afterwards.
  void put_into(core::Slice& merged);

 private:
  std::vector<core::Ring> slice_, enforced_, blocked_;
  core::ChangedAreas areas_;
};

}  // namespace host
