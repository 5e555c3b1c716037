#include "firmware_link/dialects/dialects.h"

#include <algorithm>
#include <iterator>

#include "firmware_link/dialects/klipper_dialect.h"
#include "firmware_link/dialects/marlin_dialect.h"
#include "firmware_link/dialects/prusa_dialect.h"
#include "firmware_link/dialects/reprap_dialect.h"

namespace firmware_link {

std::unique_ptr<Dialect> dialect_for(std::string_view firmware_name) {
  const auto says = [&](std::string_view word) {
    return firmware_name.find(word) != std::string_view::npos;
  };
  if (says("Klipper")) return std::make_unique<KlipperDialect>();
  if (says("RepRapFirmware")) return std::make_unique<RepRapDialect>();
  if (says("Prusa-Firmware")) return std::make_unique<PrusaDialect>();
  return std::make_unique<MarlinDialect>();
}

bool is_known_firmware(std::string_view firmware_name) {
  constexpr std::string_view kKnown[] = {"Marlin", "Klipper", "RepRapFirmware", "Prusa-Firmware"};
  return std::any_of(std::begin(kKnown), std::end(kKnown), [&](std::string_view name) {
    return firmware_name.find(name) != std::string_view::npos;
  });
}

}  // namespace firmware_link
