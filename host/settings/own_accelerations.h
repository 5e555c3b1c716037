// The settings of accelerations that need a default (core/motions/road_accelerations.h).
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "host/pipeline/print_settings.h"  // PrintSettings

namespace host {

inline constexpr std::array<std::pair<std::string_view, double PrintSettings::*>, 8>
    kOwnAccelerations = {{
        {"perimeter_acceleration_mm_s2", &PrintSettings::perimeter_acceleration_mm_s2},
        {"outer_perimeter_acceleration_mm_s2", &PrintSettings::outer_perimeter_acceleration_mm_s2},
        {"loose_acceleration_mm_s2", &PrintSettings::loose_acceleration_mm_s2},
        {"solid_acceleration_mm_s2", &PrintSettings::solid_acceleration_mm_s2},
        {"top_acceleration_mm_s2", &PrintSettings::top_acceleration_mm_s2},
        {"bridge_acceleration_mm_s2", &PrintSettings::bridge_acceleration_mm_s2},
        {"first_layer_acceleration_mm_s2", &PrintSettings::first_layer_acceleration_mm_s2},
        {"travel_acceleration_mm_s2", &PrintSettings::travel_acceleration_mm_s2},
    }};

}  // namespace host
