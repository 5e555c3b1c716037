// Scenarios whose damage is on the way to a Marlin: see scenario_checks.h.
#include <doctest/doctest.h>

#include "tests/firmware_link/scenarios/scenario_checks.h"

using namespace link_test;

TEST_CASE("damage on the way to the controller") {
  play([](const Scenario& scenario) {
    return !scenario.about_answers && scenario.dialect == VirtualDialect::kMarlin &&
           scenario.mishap == Mishap::kNone && !damages(scenario.up);
  });
}
