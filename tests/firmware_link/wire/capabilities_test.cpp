#include "firmware_link/wire/capabilities.h"

#include <doctest/doctest.h>

using namespace firmware_link;

TEST_CASE("capabilities and names out of what M115 says") {
  Capabilities can;
  for (const char* text : {"ARCS:1", "EMERGENCY_PARSER:1", "MEATPACK:0", "NOTHING:1", "x", ":"}) {
    note_capability(text, can);
  }
  CHECK(can.arcs);
  CHECK(can.emergency_parser);
  CHECK_FALSE(can.meatpack);
  CHECK_FALSE(can.autoreport_temperatures);
  CHECK(firmware_name_in("Marlin 2.1 (x y) SOURCE_CODE_URL:z") == "Marlin 2.1 (x y)");
  CHECK(firmware_name_in(" RepRapFirmware for Duet 2 FIRMWARE_VERSION: 3") ==
        "RepRapFirmware for Duet 2");
}
