#include "host/pipeline/floating_islands.h"

#include <fmt/format.h>

namespace host {

core::Status FloatingIslands::check(const core::Slice& slice, const core::HangingPlaces& hanging) {
  for (const core::HangingPlace& place : hanging.largest) {
    if (place.kind != core::HangingKind::kIsland) continue;
    const std::string what =
        fmt::format("{}: {}", part_, hanging_text({slice.index, slice.bottom, place}));
    if (action_ == OnFloating::kStop) {
      return core::Error{core::ErrorCode::kBadPart,
                         what + "; it needs a support, or --on-floating warn to print it"};
    }
    if (told_++ < kHangingTold) warnings_.put(what);
  }
  return {};
}

}  // namespace host
