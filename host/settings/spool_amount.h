// The filament that is left on a spool, as a user tells it (--spool-left).
#pragma once

#include <string>

#include "core/result.h"    // Result
#include "core/settings.h"  // Settings

namespace host {

// A length or a weight: one of the two is 0.
struct SpoolAmount {
  double mm = 0;
  double grams = 0;
};

// Reads "12 m", "350g", "0.4 kg", "900 mm". Error: it has no unit, or is no number of 0 or more.
[[nodiscard]] core::Result<SpoolAmount> spool_amount(const std::string& text);

// In mm. Error: it is a weight, and the settings have no density of the filament.
[[nodiscard]] core::Result<double> spool_mm(const SpoolAmount& amount,
                                            const core::Settings& settings);

}  // namespace host
