#include "firmware_link/wire/command.h"

#include <doctest/doctest.h>

#include <string>

using namespace firmware_link;

namespace {

// The text that is sent, or "" when the line is refused.
std::string sent(const std::string& line) {
  const auto made = verbatim_from(line);
  const Verbatim* verbatim = std::get_if<Verbatim>(&made);
  return verbatim == nullptr ? std::string() : std::string(verbatim->text());
}

std::string refusal(const std::string& line) {
  const auto made = verbatim_from(line);
  const std::string* why = std::get_if<std::string>(&made);
  return why == nullptr ? std::string() : *why;
}

}  // namespace

TEST_CASE("a user's line is made fit to be sent") {
  CHECK(sent("G28") == "G28");
  CHECK(sent("  g28 x0 ; home\r\n") == "G28 X0");
  CHECK(sent("G1 (fast) X5") == "G1  X5");
  CHECK(sent("m117 Hello (World)") == "M117 Hello (World)");
  CHECK(sent("M118 E1 printing") == "M118 E1 printing");
  CHECK(sent("bed_mesh_profile LOAD=default") == "bed_mesh_profile LOAD=default");
  CHECK(sent("M104\tS200") == "M104 S200");
  CHECK(sent("T0") == "T0");
  CHECK(sent("Tx") == "Tx");
  CHECK(sent("G29.1 x") == "G29.1 X");
}

TEST_CASE("what holds nothing to send is known") {
  for (const char* line : {"", "   ", ";x", " ; y", "(all of it)", "\t\r\n", "// x", "@BEDLEVEL"}) {
    CAPTURE(line);
    CHECK(blank_or_comment(line));
    CHECK_FALSE(refusal(line).empty());
  }
  CHECK_FALSE(blank_or_comment("G28 ; home"));
}

TEST_CASE("what would break the conversation is refused, with a reason") {
  for (const char* line :
       {"M110 N0", "m110", "M117 see M110 there", "N5 G28", "G28*33", "M112", "M410", "M28 a.gco",
        "M29", "M999", "M118 ok", "M118 Resend: 5", "M118 start", "M118 //action:cancel",
        "M118 Error:Printer halted", "M117 caf\xc3\xa9", "=5", "[x]", "%"}) {
    CAPTURE(line);
    CHECK_FALSE(refusal(line).empty());
  }
  CHECK(refusal("M117 " + std::string(76, 'x')).empty());
  CHECK(refusal("M117 " + std::string(77, 'x')) ==
        "it has 82 characters, more than the 81 that a controller's line can hold");
  // A comment doesn't count.
  CHECK(sent("G28 ;" + std::string(500, 'x')) == "G28");
}
