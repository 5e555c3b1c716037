// What a PrusaSlicer profile says of supports in terms of other settings.
#pragma once

#include "core/settings.h"                 // Settings
#include "host/settings/prusa_left_out.h"  // ProfileValues

namespace host {

// Gaps in layers from distances, the distance sideways from a share of a road's width, and what
// supports may stand on. REQUIRES: all that stands for itself was taken over.
void take_prusa_supports(const ProfileValues& profile, core::Settings& settings);

}  // namespace host
