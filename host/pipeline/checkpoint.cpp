#include "host/pipeline/checkpoint.h"

#include "core/walls/loose_blocks.h"  // loose_block_layers

namespace host {

bool is_far_below(const core::Slice& slice, const Checkpoint& start,
                  const core::Settings& settings) {
  // The block whose inside is laid at once may begin below the start. Neither a block nor a layer
  // is higher than the nozzle's bore (layer_rules.h).
  const int block = core::loose_block_layers(settings) - 1;
  const core::Length block_height = block > 0 ? settings.nozzle_diameter : core::Length();
  const core::Length under = start.bottom - settings.nozzle_diameter - block_height;
  return slice.index + core::wall_layers(settings) + 1 + block < start.layer &&
         slice.top() + settings.wall_thickness <= under;
}

}  // namespace host
