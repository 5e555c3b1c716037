#include "core/slices/layer_heights.h"

#include <algorithm>

#include "core/check.h"  // RIND_CHECK

namespace core {

LayerIndex LayerHeights::count(Length top) const {
  RIND_CHECK(first > Length() && rest > Length());
  if (top * 2 < first) return 0;
  const std::int64_t above = ((top - first) * 2 + rest).units();
  return 1 + std::max<LayerIndex>(0, above / (2 * rest.units()));
}

LayerHeights layer_heights(const Settings& settings) {
  const Length first = settings.first_layer_height;
  return {first > Length() ? first : settings.layer_height, settings.layer_height};
}

}  // namespace core
