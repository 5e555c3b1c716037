#include "firmware_link/wire/refused_commands.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "firmware_link/wire/command.h"
#include "firmware_link/wire/gcode_words.h"

using namespace firmware_link;

namespace {

using Words = std::vector<std::string>;

bool refused(const std::string& line, const Words& allowed = {}) {
  return refused_in(line, allowed).has_value();
}

bool sendable(const std::string& line) {
  return std::holds_alternative<Verbatim>(verbatim_from(line));
}

}  // namespace

TEST_CASE("commands are found however they are written") {
  CHECK(commands_in("G28") == Words{"G28"});
  CHECK(commands_in("  g1 x5 ; M500") == Words{"G1"});
  CHECK(commands_in("m0500") == Words{"M500"});
  CHECK(commands_in("M 500.1") == Words{"M500"});
  CHECK(commands_in("(first) M500") == Words{"M500"});
  CHECK(commands_in("M5(x)00") == Words{"M500"});
  CHECK(commands_in("\tM500\tP1") == Words{"M500"});
  CHECK(commands_in("G1 X5 M500") == Words{"G1", "M500"});
  CHECK(commands_in("G28X0M500") == Words{"G28", "M500"});
  CHECK(commands_in("G90 G1 X5 m 028 a.g") == Words{"G90", "G1", "M28"});
  CHECK(commands_in("M810 G28|M500") == Words{"M810", "G28", "M500"});
  CHECK(commands_in("firmware_restart") == Words{"FIRMWARE_RESTART"});
  CHECK(commands_in("Restart=1") == Words{"RESTART"});
  CHECK(commands_in("G00") == Words{"G0"});
  // A tool behind another command is a parameter; a text is a text.
  CHECK(commands_in("M104 T1 S200") == Words{"M104"});
  CHECK(commands_in("M117 then M500") == Words{"M117"});
  CHECK(commands_in("M98 P\"/macros/M500.g\"") == Words{"M98"});
  CHECK(commands_in("SET_PIN PIN=M500") == Words{"SET_PIN"});
  CHECK(commands_in("; M500").empty());
  CHECK(commands_in("").empty());
  CHECK(has_parameter("G1 X5 e1", 'E'));
  CHECK(has_parameter("G1X5E1", 'E'));
  CHECK_FALSE(has_parameter("G1 X5 ; E1", 'E'));
}

TEST_CASE("what changes the printer for good, or harms, is refused unless it is named") {
  for (const char* line : {"M500",
                           "m500",
                           "M0500",
                           "M 500",
                           "M500.0",
                           "\tM500",
                           "(store) M500",
                           "G28 M500",
                           "G1 X5 M500",
                           "M501",
                           "M502",
                           "M30 a.g",
                           "M23 a.g",
                           "M24",
                           "M26 S0",
                           "M32 P!a.g#",
                           "M33 a",
                           "M81",
                           "M108",
                           "M43 T",
                           "M111 S8",
                           "M113 S0",
                           "M154 S1",
                           "M155 S0",
                           "M504",
                           "M505",
                           "M512 S1",
                           "M540 P1",
                           "M551 Px",
                           "M552 S0",
                           "M562 P1",
                           "M587 S\"a\"",
                           "M910",
                           "M993",
                           "M994",
                           "M916",
                           "M471 S\"a\" T\"b\"",
                           "PRUSA FR",
                           "prusa mmures",
                           "SDCARD_PRINT_FILE FILENAME=a",
                           "sdcard_reset_file",
                           "SDCARD_LOOP_BEGIN COUNT=0",
                           "RUN_SHELL_COMMAND CMD=x"}) {
    CAPTURE(line);
    CHECK(refused(line));
    const std::optional<RefusedCommand> found = refused_in(line, {});
    REQUIRE(found);
    CHECK_FALSE(found->never);
    CHECK_FALSE(found->reason.empty());
    CHECK_FALSE(refused(line, {std::string(found->command)}));
    CHECK(refused(line, {"M1"}));
  }
  // One that is named does not open another.
  CHECK(refused("M500 M501", {"M500"}));
  CHECK_FALSE(refused("M500 M501", {"M500", "M501"}));
}

TEST_CASE("what breaks the conversation is never sent, whoever names it") {
  for (const char* line : {"M28 a.g",
                           "M29",
                           "M110 N0",
                           "M112",
                           "M0112",
                           "M 112",
                           "G28 M112",
                           "M410",
                           "M510",
                           "M555 P2",
                           "M559",
                           "M560",
                           "M575 P1 B9600",
                           "M876 S0",
                           "M928 a.g",
                           "M936",
                           "M997",
                           "M998",
                           "M999",
                           "M999 S1",
                           "D0",
                           "D3 Ax0",
                           "D-1",
                           "FIRMWARE_RESTART",
                           "firmware_restart",
                           "restart",
                           "SAVE_CONFIG"}) {
    CAPTURE(line);
    CHECK_FALSE(sendable(line));
    const std::string word = std::string(line).substr(0, std::string(line).find(' '));
    if (word != "D-1" && word != "M555") CHECK(refused(line, {canonical(word)}));
  }
  for (const char* line :
       {"N-5 M500", "N 5 M500", "n5 G28", "RESPOND TYPE=error MSG=x", "respond prefix=ok MSG=x"}) {
    CAPTURE(line);
    CHECK_FALSE(sendable(line));
  }
}

TEST_CASE("what start G-code is made of is let through") {
  for (const char* line : {"G28",
                           "G28 W",
                           "G29 P1",
                           "G80",
                           "G32",
                           "G92 E0",
                           "M17",
                           "M73 P0",
                           "M82",
                           "M83",
                           "M84",
                           "M104 S215 T0",
                           "M117 M500 is stored",
                           "M115 U3.13.2",
                           "M201 X1000",
                           "M204 P1000",
                           "M220 S100",
                           "M221 S95",
                           "M300 S440 P200",
                           "M302 S160",
                           "M420 S1",
                           "M486 Abox_M28",
                           "M503",
                           "M569 S1",
                           "M555 X0 Y0 W250 H210",
                           "M572 D0 S0.05",
                           "M600",
                           "M862.3 P \"MK3S\"",
                           "M900 K0.05",
                           "M98 P\"start.g\"",
                           "M118 E1 hello",
                           "T0",
                           "Tx",
                           "START_PRINT BED=60",
                           "DELTA_CALIBRATE",
                           "BED_MESH_PROFILE LOAD=default",
                           "RESPOND MSG=hello",
                           "PAUSE",
                           "SAVE_VARIABLE VARIABLE=a"}) {
    CAPTURE(line);
    CHECK_FALSE(refused(line));
    CHECK(sendable(line));
  }
}
