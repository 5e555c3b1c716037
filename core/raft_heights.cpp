#include "core/raft_heights.h"

#include <algorithm>

namespace core {

Length raft_layer_height(const Settings& settings, LayerIndex layer) {
  const bool own = layer == 0 && settings.first_layer_height > Length();
  return own ? settings.first_layer_height : settings.layer_height;
}

Length raft_layer_bottom(const Settings& settings, LayerIndex layer) {
  if (layer == 0) return {};
  return raft_layer_height(settings, 0) + settings.layer_height * (layer - 1);
}

Length raft_lift(const Settings& settings) {
  if (settings.raft_layers == 0) return {};
  return raft_layer_bottom(settings, settings.raft_layers) + settings.raft_contact_distance;
}

Settings settings_above_raft(Settings settings) {
  if (settings.raft_layers == 0) return settings;
  if (settings.axis_z > Length()) {
    settings.axis_z = std::max(settings.axis_z - raft_lift(settings), Length::from_units(1));
  }
  settings.first_layer_height = {};
  settings.first_layer_width = {};
  settings.first_layer_flow = 1;
  settings.elephant_foot_compensation = {};
  settings.brim_width = {};
  settings.skirt_loops = 0;
  settings.skirt_length_min = {};
  return settings;
}

bool is_above_raft(const Settings& settings, LayerIndex layer) {
  return settings.raft_layers > 0 && layer == settings.raft_layers;
}

}  // namespace core
