// Tells the stretches of a road apart that run in a layer's dense part: where its centre line
// enters and leaves it.
#pragma once

#include <utility>
#include <vector>

#include "core/regions/point_location.h"  // PointLocation
#include "core/regions/region.h"          // Region
#include "core/roads/line_clip.h"         // LineClipper
#include "core/roads/road.h"              // Road

namespace core {

class DenseParts {
 public:
  // Keeps a reference to the region. COSTS: O(points).
  explicit DenseParts(const Region& dense)
      : empty_(dense.empty()), inside_(dense), contours_(dense) {}

  // The road's stretches in their order, each with whether it is dense. A road that is one stretch
  // stays as it is; of others, `holds` and `starts` are left out.
  // COSTS: O(points · cells passed).
  [[nodiscard]] std::vector<std::pair<Road, bool>> of(Road road) const;

 private:
  struct Station {
    Point at;
    Length width;
  };

  [[nodiscard]] std::vector<Station> stations(const Road& road) const;
  static Road started(const Road& like, const Station& at);
  static void go_on(const Station& to, Road& part);

  bool empty_;
  PointLocation inside_;
  LineClipper contours_;
};

}  // namespace core
