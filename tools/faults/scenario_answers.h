// Scenarios of answers that are missing, late by nature, or beside the point.
#pragma once

#include <vector>

#include "tools/faults/scenario.h"  // Scenario

namespace firmware_link {

void add_answer_scenarios(std::vector<Scenario>& all);

}  // namespace firmware_link
