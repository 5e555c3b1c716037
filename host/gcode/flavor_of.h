// The firmware that the settings name, as the link spells it.
#pragma once

#include "core/settings.h"               // GcodeFlavor
#include "firmware_link/wire/command.h"  // Flavor

namespace host {

[[nodiscard]] inline firmware_link::Flavor flavor_of(core::GcodeFlavor flavor) {
  switch (flavor) {
    case core::GcodeFlavor::kKlipper:
      return firmware_link::Flavor::kKlipper;
    case core::GcodeFlavor::kRepRapFirmware:
      return firmware_link::Flavor::kRepRapFirmware;
    case core::GcodeFlavor::kMarlin:
      break;
  }
  return firmware_link::Flavor::kMarlin;
}

}  // namespace host
