// How long a virtual controller moves for lines of G-code, in simulated time: what clocks are held
// against.
#pragma once

#include <string_view>

#include "firmware_link/virtual/virtual_controller.h"

namespace firmware_link {

class ControllerTime {
 public:
  // Filament may be moved cold, and all axes are known.
  explicit ControllerTime(VirtualControllerOptions options);

  // One line, without its end; a comment is left out. Waits for its `ok`, and for heaters.
  void execute(std::string_view line);

  // How long it has moved, once all has ended: heating, homing and pauses are left out.
  [[nodiscard]] double seconds();

  [[nodiscard]] VirtualControllerState state() const { return controller_.state(); }
  [[nodiscard]] const VirtualControllerTotals& totals() const { return controller_.totals(); }

 private:
  [[nodiscard]] bool hears_ok();

  Instant now_{};
  VirtualController controller_;
};

}  // namespace firmware_link
