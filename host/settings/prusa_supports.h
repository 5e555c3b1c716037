// What a PrusaSlicer profile says of supports in terms of other settings.
#pragma once

#include <functional>
#include <string>

#include "core/settings.h"                 // Settings
#include "host/settings/prusa_left_out.h"  // ProfileValues

namespace host {

// What supports may stand on, and the angle from which on they hold. REQUIRES: all that stands for
// itself was taken over.
void take_prusa_supports(const ProfileValues& profile, core::Settings& settings);

// Gaps in layers from distances, the distance sideways from a share of a road's width: those of the
// settings that are not assigned by hand. REQUIRES: layer_height and road_width are what the print
// will have.
using IsAssigned = std::function<bool(const std::string& key)>;
void take_prusa_support_distances(const ProfileValues& profile, const IsAssigned& assigned,
                                  core::Settings& settings);

}  // namespace host
