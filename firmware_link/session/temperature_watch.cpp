#include "firmware_link/session/temperature_watch.h"

namespace firmware_link {

void TemperatureWatch::told(const Temperatures& temperatures) {
  const auto update = [](std::optional<double>& kept, const std::optional<double>& value) {
    if (value) kept = value;
  };
  update(known_.nozzle_celsius, temperatures.nozzle_celsius);
  update(known_.nozzle_target_celsius, temperatures.nozzle_target_celsius);
  update(known_.bed_celsius, temperatures.bed_celsius);
  update(known_.bed_target_celsius, temperatures.bed_target_celsius);
}

std::optional<std::string> TemperatureWatch::complaint(const Temperatures& told, Instant now) {
  std::optional<std::string> words;
  if (told.nozzle_celsius && told.nozzle_target_celsius) {
    words = nozzle_.heard(*told.nozzle_celsius, *told.nozzle_target_celsius, now);
  }
  if (!words && told.bed_celsius && told.bed_target_celsius) {
    words = bed_.heard(*told.bed_celsius, *told.bed_target_celsius, now);
  }
  return words;
}

}  // namespace firmware_link
