// Scenarios of the other dialects: see scenario_checks.h.
#include <doctest/doctest.h>

#include "tests/firmware_link/scenarios/scenario_checks.h"

using namespace link_test;

TEST_CASE("Klipper, RepRapFirmware, Prusa") {
  play([](const Scenario& scenario) {
    return !scenario.about_answers && scenario.dialect != VirtualDialect::kMarlin;
  });
}
