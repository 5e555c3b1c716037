// What lines of G-code change about how a machine moves (core/motions/motion_model.h).
//
//     "M204 P800 T1500"                   accelerations
//     "M201 X500 Y500" "M203 E60"         limits of axes (M203 of RepRapFirmware: in mm/min)
//     "M205 X8 Y8" "M205 J0.02" "M566 …"  corners
//     "SET_VELOCITY_LIMIT ACCEL=3000 SQUARE_CORNER_VELOCITY=5"
#pragma once

#include <string_view>

#include "core/motions/motion_model.h"   // MotionModel
#include "firmware_link/wire/command.h"  // Flavor

namespace host {

// True if the line has changed the model. `command`: its word in canonical form (gcode_words.h);
// `parameters`: what stands behind the word.
bool changes_model(std::string_view command, std::string_view parameters,
                   firmware_link::Flavor flavor, core::MotionModel& model);

}  // namespace host
