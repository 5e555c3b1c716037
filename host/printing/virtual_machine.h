// The virtual controller as the machine of the settings: its words, bed and ways of moving.
#pragma once

#include "core/settings.h"                             // Settings
#include "firmware_link/virtual/virtual_controller.h"  // VirtualControllerOptions

namespace host {

[[nodiscard]] firmware_link::VirtualControllerOptions virtual_machine(
    const core::Settings& settings);

}  // namespace host
