// Branches of a lightning fill: straight roads in the inside that hold what is laid over them
// (supports/lightning_fold.h).
#pragma once

#include <vector>

#include "core/geometry.h"  // Point

namespace core {

struct Branch {
  Point from, to;
  bool from_wall = false;  // whether that end meets the wall
  bool to_wall = false;
  bool operator==(const Branch&) const = default;
};

using Branches = std::vector<Branch>;

}  // namespace core
