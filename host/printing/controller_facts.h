// Asks a controller what it is, and ends: nothing is heated or moved.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "firmware_link/ports/byte_port.h"     // BytePort
#include "firmware_link/wire/travel_limits.h"  // TravelLimits

namespace host {

struct ControllerFacts {
  bool answered = false;
  std::string why_not;       // where it has not: in a sentence
  std::string firmware;      // M115's FIRMWARE_NAME; may be empty
  std::string dialect;       // as it is spoken to: "Marlin", "Klipper", "RepRapFirmware" …
  std::string machine_type;  // M115's MACHINE_TYPE; may be empty
  std::optional<firmware_link::TravelLimits> travel;  // M211; nothing: it does not tell
};

// Waits for at most `limit_s`, or until `stop_asked`.
[[nodiscard]] ControllerFacts ask_controller(firmware_link::BytePort& port, double limit_s,
                                             const std::function<bool()>& stop_asked);

}  // namespace host
