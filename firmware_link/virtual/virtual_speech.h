// What the virtual controller says, by dialect: the words of Marlin and Klipper are those that were
// measured, byte for byte; Prusa's and RepRapFirmware's are those of their sources.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "firmware_link/virtual/virtual_controller.h"  // VirtualDialect, VirtualControllerState

namespace firmware_link {

struct HeaterReport {
  double nozzle_celsius = 0, nozzle_target = 0;
  double bed_celsius = 0, bed_target = 0;
  int nozzle_power = 0, bed_power = 0;
};

// Each with its line ends.
[[nodiscard]] std::string banner_of(VirtualDialect dialect);
[[nodiscard]] std::string identity_of(const VirtualControllerOptions& options);
[[nodiscard]] std::string unknown_command(VirtualDialect dialect, std::string_view text);
[[nodiscard]] std::string position_of(VirtualDialect dialect, const VirtualControllerState& state);
[[nodiscard]] std::string cold_extrusion(VirtualDialect dialect);

// Without line end: " T:25.45 /0.00 B:25.45 /0.00 @:0 B@:0".
[[nodiscard]] std::string temperatures_of(VirtualDialect dialect, const HeaterReport& report);

// It numbers lines, asks for damaged ones again, and says when it is busy.
[[nodiscard]] constexpr bool numbers_lines(VirtualDialect dialect) {
  return dialect == VirtualDialect::kMarlin || dialect == VirtualDialect::kPrusa;
}

}  // namespace firmware_link
