#include "host/settings/gcode_placeholders.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using host::GcodeOrigin;

namespace {

std::optional<std::string> known(std::string_view name, std::size_t index) {
  const std::vector<std::string> temperatures = {"215", "220"};
  if (name == "first_layer_temperature" && index < 2) return temperatures[index];
  if (name == "bed_temperature" && index == 0) return "60";
  return std::nullopt;
}

// The line as it is sent, or what is wrong in brackets.
std::string filled(const std::string& line, GcodeOrigin origin = GcodeOrigin::kProfile) {
  const auto result = host::fill_placeholders({line}, known, origin);
  if (!result.ok()) return "error: " + result.error().message;
  return result.value().empty() ? "" : result.value().front();
}

bool refused(const std::string& line, GcodeOrigin origin = GcodeOrigin::kProfile) {
  return filled(line, origin).starts_with("error: ");
}

}  // namespace

TEST_CASE("plain placeholders are filled in, in each of their spellings") {
  for (const char* spelled :
       {"[first_layer_temperature]", "{first_layer_temperature}", "{first_layer_temperature[0]}",
        "[first_layer_temperature_0]", "{ first_layer_temperature [ 0 ] }",
        "{first_layer_temperature[initial_tool]}", "{first_layer_temperature[initial_extruder]}",
        "[first_layer_temperature_[current_extruder]]"}) {
    CAPTURE(spelled);
    CHECK_EQ(filled(std::string("M104 S") + spelled + " ; hot"), "M104 S215");
  }
  CHECK_EQ(filled("M104 T1 S{first_layer_temperature[1]}"), "M104 T1 S220");
  CHECK_EQ(filled("M104 S[first_layer_temperature_1]"), "M104 S220");
  CHECK_EQ(filled("A[bed_temperature]B{bed_temperature}"), "A60B60");
  CHECK_EQ(filled("G28"), "G28");
  CHECK_EQ(filled("M201 X{8000}"), "M201 X8000");
  CHECK_EQ(filled("; only [a comment] {of it}"), "");
}

TEST_CASE("what is no plain placeholder is refused, not guessed") {
  for (const char* line :
       {"M104 S[no_such_thing]", "M104 S{no_such_thing[0]}", "{if layer_z > 1}G1{endif}", "{endif}",
        "M104 S{first_layer_temperature[0]+5}", "M104 S{first_layer_temperature[2]}",
        "M104 S[first_layer_temperature", "M104 S{first_layer_temperature[0]", "G1 X{}", "G1 X[]",
        "; {if bed_temperature > 50}", "G1 Z{max_layer_z + 10}", "[bed_temperature_1]",
        "{local a = 5}", "{bed_temperature > 5 ? 1 : 2}"}) {
    CAPTURE(line);
    CHECK(refused(line));
  }
}

TEST_CASE("the user's own lines may hold what the controller works out") {
  CHECK_EQ(filled("G1 Z{move.axes[2].max - 5}", GcodeOrigin::kOwn), "G1 Z{move.axes[2].max - 5}");
  CHECK_EQ(filled("M104 S{first_layer_temperature}", GcodeOrigin::kOwn), "M104 S215");
  CHECK(refused("M104 S[no_such_thing]", GcodeOrigin::kOwn));
  CHECK(refused("M104 S{no_such_thing}", GcodeOrigin::kOwn));
  CHECK(refused("{if layer_z > 1}", GcodeOrigin::kOwn));
}
