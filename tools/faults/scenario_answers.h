// Scenarios with answers that are missing, late, or unrelated.
#pragma once

#include <vector>

#include "tools/faults/scenario.h"  // Scenario

namespace firmware_link {

void add_answer_scenarios(std::vector<Scenario>& all);

}  // namespace firmware_link
