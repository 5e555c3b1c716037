#include "host/settings/prusa_shares.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/settings/settings_text.h"  // read_number, write_number

namespace host {
namespace {

struct ShareOf {
  std::string_view key;
  std::string_view of;
};

constexpr std::array kShares = {
    ShareOf{"first_layer_height", "layer_height"},
    ShareOf{"external_perimeter_speed", "perimeter_speed"},
    ShareOf{"small_perimeter_speed", "perimeter_speed"},
    ShareOf{"solid_infill_speed", "infill_speed"},
    ShareOf{"top_solid_infill_speed", "solid_infill_speed"},
    ShareOf{"support_material_interface_speed", "support_material_speed"},
    ShareOf{"extrusion_width", "nozzle_diameter"},
    ShareOf{"first_layer_extrusion_width", "nozzle_diameter"},
    ShareOf{"top_infill_extrusion_width", "nozzle_diameter"},
    ShareOf{"support_material_extrusion_width", "nozzle_diameter"},
};

}  // namespace

std::string absolute_value(const ProfileValues& profile, std::string_view key) {
  const auto said = profile.find(key);
  if (said == profile.end()) return {};
  const std::string_view first = first_value(said->second);
  const auto* share = std::find_if(kShares.begin(), kShares.end(),
                                   [key](const ShareOf& one) { return one.key == key; });
  if (!first.ends_with('%') || share == kShares.end()) return said->second;
  const core::Result<double> percent = read_number(first.substr(0, first.size() - 1), "");
  const core::Result<double> whole =
      read_number(first_value(absolute_value(profile, share->of)), "");
  if (!percent.ok() || !whole.ok()) return said->second;
  // Without the rounding of binary fractions: 70 % of 0.3 is 0.21.
  const double value = percent.value() * whole.value() / 100;
  return write_number(std::round(value * 1e9) / 1e9);
}

}  // namespace host
