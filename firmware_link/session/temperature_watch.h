// The temperatures that were told last, and a watch on each heater.
#pragma once

#include <optional>
#include <string>

#include "firmware_link/session/heater_watch.h"  // HeaterWatch
#include "firmware_link/wire/instant.h"          // Instant
#include "firmware_link/wire/reply.h"            // Temperatures

namespace firmware_link {

class TemperatureWatch {
 public:
  // What was told last of each; what is not told keeps its value.
  void told(const Temperatures& temperatures);
  [[nodiscard]] const Temperatures& known() const { return known_; }

  // Forgets how warm they were: a controller that waits for its user may let its nozzle cool, and
  // tell the target all the same.
  void restart() { nozzle_.restart(), bed_.restart(); }

  // A sentence when a heater does not do what it was told (heater_watch.h).
  [[nodiscard]] std::optional<std::string> complaint(const Temperatures& told, Instant now);

 private:
  Temperatures known_;
  HeaterWatch nozzle_{"the nozzle", nozzle_watch_limits()};
  HeaterWatch bed_{"the bed", bed_watch_limits()};
};

}  // namespace firmware_link
