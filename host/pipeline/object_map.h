// Which of several objects on the bed a road belongs to.
#pragma once

#include <vector>

#include "core/geometry.h"          // Box, Point
#include "core/roads/road.h"        // Road
#include "host/part/opened_part.h"  // PartObject

namespace host {

class ObjectMap {
 public:
  explicit ObjectMap(const std::vector<PartObject>& objects);

  // The object whose box is nearest; kNoObject if there are none. COSTS: O(objects).
  [[nodiscard]] int at(core::Point point) const;

  // Tells each road whose it is: the part's, its supports' and its brim's. Skirt and raft are
  // nobody's.
  void mark(std::vector<core::Road>& roads) const;

 private:
  std::vector<core::Box> boxes_;
};

}  // namespace host
