#include "host/pipeline/checkpoint.h"

#include <algorithm>

#include "core/walls/loose_blocks.h"  // loose_block_layers

namespace host {

bool is_far_below(const core::Slice& slice, const Checkpoint& start,
                  const core::Settings& settings) {
  // The block whose inside is laid at once may begin below the start.
  const int block = core::loose_block_layers(settings) - 1;
  const core::Length block_height = block > 0 ? settings.nozzle_diameter : core::Length();
  const core::Length layer_height = std::max(settings.layer_height, slice.height);
  const core::Length under = start.bottom - layer_height - block_height;
  return slice.index + core::wall_layers(settings) + 1 + block < start.layer &&
         slice.top() + settings.wall_thickness <= under;
}

}  // namespace host
