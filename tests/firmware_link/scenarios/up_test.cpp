// Scenarios whose damage is on the way back from a Marlin: see scenario_checks.h.
#include <doctest/doctest.h>

#include "tests/firmware_link/scenarios/scenario_checks.h"

using namespace link_test;

TEST_CASE("damage on the way back, and both ways") {
  play([](const Scenario& scenario) {
    return !scenario.about_answers && scenario.dialect == VirtualDialect::kMarlin &&
           scenario.mishap == Mishap::kNone && damages(scenario.up);
  });
}
