// What is told of a part that may not stand.
#pragma once

#include <string>
#include <vector>

#include "core/slices/standing.h"  // StandingReport

namespace host {

// A sentence on bodies that may come loose from the bed, and one on thin columns; each only where
// there are any.
[[nodiscard]] std::vector<std::string> standing_text(const core::StandingReport& report);

}  // namespace host
