#include "host/settings/gcode_placeholders.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using host::GcodeOrigin;

namespace {

core::Result<std::optional<host::Variable>> known(std::string_view name, std::size_t index) {
  using host::VariableKind;
  using Found = std::optional<host::Variable>;
  const auto whole = [](const char* text) { return Found({text, VariableKind::kWhole}); };
  const auto number = [](const char* text) { return Found({text, VariableKind::kNumber}); };
  const auto words = [](const char* text) { return Found({text, VariableKind::kText}); };
  if (name == "first_layer_temperature" && index < 2) return whole(index == 0 ? "215" : "220");
  if (name == "bed_temperature" && index == 0) return whole("60");
  if (name == "initial_tool" || name == "current_extruder" || name == "initial_extruder") {
    return whole("0");
  }
  if (name == "layer_height") return number("0.15");
  if (name == "max_print_height") return number("210");
  if (name == "max_layer_z") return number("20.05");
  if (name == "filament_type") return words("PETG");
  if (name == "notes") return words("Don't remove\nPRINTER_MODEL_MINI\nend");
  if (name == "fill_density") return number("15%");
  if (name == "has_wipe_tower") return whole("0");
  return Found();
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

TEST_CASE("expressions, as PrusaSlicer works them out") {
  const std::pair<const char*, const char*> kCases[] = {
      {"{first_layer_temperature[0]-50}", "165"},
      {"{first_layer_temperature[0] * 0.791}", "170.065"},
      {"{7/2} {7.0/2} {-7/2} {7%4} {2+3*4} {(2+3)*4}", "3 3.5 -3 3 14 20"},
      {"{min(max_layer_z+2, max_print_height)}", "22.05"},
      {"{max(first_layer_temperature[0], first_layer_temperature[1])}", "220"},
      {"{max_print_height*0.6} {int(3.9)} {round(3.5)} {round(-3.5)}", "126 3 4 -4"},
      {"{\"\" + ((filament_type[0]==\"FLEX\") ? 1 : ((filament_type[0]==\"PVA\") ? 2 : 0))}", "0"},
      {"{1 < 2} {2 <= 1} {1 <> 2} {\"a\" == \"a\"} {not has_wipe_tower}",
       "true false true true true"},
      {"{true and not false} {0 || 0.5} {1 && 0} {!true}", "true true false false"},
      {"{if notes=~/.*MODEL_MINI.*/}mini{else}other{endif}", "mini"},
      {"{if notes=~/MODEL_MINI/}mini{else}other{endif}", "other"},
      {"{if filament_type!~/PE?TG|PLA/}a{else}b{endif}", "b"},
      {"{digits(5, 3)}|{zdigits(5.25, 6, 1)}", "5|0005.2"},
      {"{fill_density} [fill_density]", "15 15%"},
      {"{1000000.0} {0.1+0.2} {1/3.0}", "1e+06 0.3 0.333333"},
      {"{if layer_height<0.075}A{elsif layer_height<0.2}B{else}C{endif}", "B"},
      {"{if 1}{if 0}a{else}b{endif}{else}{if 1}c{endif}{endif}", "b"},
      // What does not count is read, and need not be known.
      {"{if 0}{no_such_thing/0}[nor_this]{else}x{endif}{1 ? 2 : no_such_thing}", "x2"},
      {"M104 S{first_layer_temperature[0] + (bed_temperature[0] > 50 ? 5 : 0)}", "M104 S220"}};
  for (const auto& [given, expected] : kCases) {
    const auto& line = given;
    CAPTURE(line);
    CHECK_EQ(filled(line), expected);
  }
}

TEST_CASE("a condition reaches over lines, and counts in comments") {
  const auto result = host::fill_placeholders(
      {"G28", "{if layer_height > 1}", "G1 Z5 ; up{else}", "G1 Z9", "; {if 1} G1 X1",
       "G1 X2{endif}", "{endif}", "G1 X3 ; [a comment] {of it} {1 +", "M84"},
      known, GcodeOrigin::kProfile);
  REQUIRE(result.ok());
  CHECK(result.value() == std::vector<std::string>{"G28", "G1 Z9", "G1 X2", "G1 X3", "M84"});
}

TEST_CASE("what can't be worked out is refused, with its place, not guessed") {
  const std::pair<const char*, const char*> kCases[] = {
      {"M104 S[no_such_thing]", "line 1, column 7: [no_such_thing]: it stands for nothing"},
      {"M104 S{no_such_thing[0]}", "no_such_thing stands for nothing"},
      {"{if max_layer_z > 1}G1", "column 1: {if max_layer_z > 1}: has no {endif}"},
      {"{endif}", "no {if}"},
      {"{else}", "no {if}"},
      {"{if 1}{else}{else}{endif}", "behind {else}"},
      {"M104 S{first_layer_temperature[2]}", "stands for nothing"},
      {"M104 S[first_layer_temperature", "not closed"},
      {"M104 S{first_layer_temperature[0]", "not closed"},
      {"G1 X{}", "'}' is not understood"},
      {"G1 X[]", "stands for nothing"},
      {"; {if no_such_thing}{endif}", "no_such_thing"},
      {"[bed_temperature_1]", "stands for nothing"},
      {"{local a = 5}", "not supported"},
      {"{1/0} {1%0}", "division by zero"},
      {"{\"a\" - 1}", "two numbers"},
      {"{bed_temperature[0.5]}", "index"},
      {"{bed_temperature[-1]}", "index"},
      {"{min(1)}", "no function min of 1"},
      {"{sin(1)}", "no function sin"},
      {"{1 2}", "a '}' is missing"},
      {"{\"a}", "'\"' is not closed"},
      {"{notes =~ /(/}", "not closed"},
      {"{notes =~ /a{2}/}", "not understood"},
      {"{1..2}", "no number"}};
  for (const auto& [given, word] : kCases) {
    const auto& line = given;
    CAPTURE(line);
    const std::string message = filled(line);
    CAPTURE(message);
    CHECK(message.starts_with("error: line 1, column "));
    CHECK_NE(message.find(word), std::string::npos);
  }
  const std::string deep(500, '(');
  CHECK_NE(filled("{" + deep + "1}").find("too deep"), std::string::npos);
  CHECK_NE(filled("{" + std::string(500, '-') + "1}").find("too deep"), std::string::npos);
  std::string nested;
  for (int i = 0; i < 100; ++i) nested += "{if 1}";
  CHECK_NE(filled(nested).find("too deep"), std::string::npos);
}

TEST_CASE("Cura's names, of which some name the extruder") {
  CHECK_EQ(filled("M109 S{first_layer_temperature, 0} [x]", GcodeOrigin::kCura), "M109 S215 [x]");
  CHECK_EQ(filled("M109 S{first_layer_temperature}", GcodeOrigin::kCura), "M109 S215");
  CHECK(refused("M109 S{no_such_thing}", GcodeOrigin::kCura));
}

TEST_CASE("the user's own lines may hold what the controller works out") {
  CHECK_EQ(filled("G1 Z{move.axes[2].max - 5}", GcodeOrigin::kOwn), "G1 Z{move.axes[2].max - 5}");
  CHECK_EQ(filled("M104 S{first_layer_temperature}", GcodeOrigin::kOwn), "M104 S215");
  CHECK(refused("M104 S[no_such_thing]", GcodeOrigin::kOwn));
  CHECK(refused("M104 S{no_such_thing}", GcodeOrigin::kOwn));
  CHECK(refused("{if layer_z > 1}", GcodeOrigin::kOwn));
  CHECK_EQ(filled("{if layer_height > 1}G1{else}G2{endif}", GcodeOrigin::kOwn), "G2");
}
