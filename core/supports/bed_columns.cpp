#include "core/supports/bed_columns.h"

#include "core/booleans/boolean.h"          // intersect
#include "core/supports/support_regions.h"  // shared

namespace core {

SupportLayer BedColumns::standing(const SupportLayer& layer) {
  SupportLayer result = layer;
  if (last_ && last_->region == layer.region && last_->interface == layer.interface) {
    result = *last_standing_;
    result.index = layer.index;
  } else if (below_) {
    result.region = shared(intersect(*layer.region, *below_));
    result.interface = shared(intersect(*layer.interface, *below_));
  }
  below_ = result.region;
  last_ = layer;
  last_standing_ = result;
  return result;
}

}  // namespace core
