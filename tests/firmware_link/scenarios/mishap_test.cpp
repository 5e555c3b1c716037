// Scenarios in which something happens to a Marlin: see scenario_checks.h.
#include <doctest/doctest.h>

#include "tests/firmware_link/scenarios/scenario_checks.h"

using namespace link_test;

TEST_CASE("resets, lost cables, dead heaters, waits") {
  play([](const Scenario& scenario) {
    return !scenario.about_answers && scenario.dialect == VirtualDialect::kMarlin &&
           scenario.mishap != Mishap::kNone;
  });
}
