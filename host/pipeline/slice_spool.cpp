#include "host/pipeline/slice_spool.h"

#include <utility>

namespace host {

SpooledLayer spooled(const core::Slice& slice, std::shared_ptr<const core::Region> region,
                     std::optional<std::string> pause) {
  SpooledLayer layer;
  layer.index = slice.index;
  layer.bottom = slice.bottom;
  layer.height = slice.height;
  layer.defects = slice.defects;
  layer.note = std::move(pause);
  layer.areas = slice.areas;
  layer.regions.front() = std::move(region);
  return layer;
}

core::Result<TakenSlice> next_slice(LayerSpool& spool) {
  core::Result<std::optional<SpooledLayer>> layer = spool.next();
  if (!layer.ok()) return layer.error();
  TakenSlice taken;
  if (!layer.value()) return taken;
  SpooledLayer& found = *layer.value();
  taken.slice =
      core::Slice{found.index, found.bottom, found.height, *found.regions.front(), found.defects};
  taken.slice->areas = std::move(found.areas);
  taken.pause = std::move(found.note);
  return taken;
}

}  // namespace host
