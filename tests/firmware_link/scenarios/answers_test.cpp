// Scenarios of answers that are missing, late by nature, or beside the point: see
// scenario_checks.h. All seeds of them:  RIND_SCENARIO_SEEDS=1000
// build/release/tests/firmware_link_scenarios_answers_test
#include <doctest/doctest.h>

#include "tests/firmware_link/scenarios/scenario_checks.h"

using namespace link_test;

TEST_CASE("answers that are missing, late, or beside the point") {
  play([](const Scenario& scenario) { return scenario.about_answers; }, 20);
}
