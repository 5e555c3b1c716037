#include "host/pipeline/slice_intake.h"

#include <utility>

#include "core/offsets/compensation.h"  // compensated, compensates
#include "host/part/layer_rules.h"      // check_layer_height

namespace host {

core::LayerIndex SliceIntake::layers() const {
  const core::LayerIndex layers = part_.summary.layers;
  return layers > 0 ? layers - settings_.raft_layers : 0;
}

core::Result<TakenSlice> SliceIntake::next() {
  core::Result<std::optional<core::Slice>> next = part_.layers->next();
  if (!next.ok()) return next.error();
  TakenSlice taken;
  if (!next.value()) return taken;
  ++taken_;
  core::Slice& slice = taken.slice.emplace(std::move(*next.value()));
  core::Status fine = check_layer_height(name_, slice, settings_);
  if (!fine.ok()) return fine.error();
  auto pause = bad_layers_.check(slice, layers());
  if (!pause.ok()) return pause.error();
  taken.pause = std::move(pause).value();
  if (core::compensates(settings_)) slice.region = core::compensated(slice, settings_);
  return taken;
}

}  // namespace host
