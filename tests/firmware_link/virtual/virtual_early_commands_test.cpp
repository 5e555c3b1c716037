#include "firmware_link/virtual/virtual_early_commands.h"

#include <doctest/doctest.h>

#include <string>

using firmware_link::VirtualEarlyCommands;
using Act = VirtualEarlyCommands::Act;

namespace {

Act read(const std::string& line) {
  VirtualEarlyCommands early;
  Act act = Act::kNone;
  for (const char c : line) act = early.read(c);
  return act;
}

}  // namespace

TEST_CASE("M112 and M108 act as their lines end, nothing longer or shorter does") {
  CHECK(read("M112\n") == Act::kStop);
  CHECK(read("  M112\r") == Act::kStop);
  CHECK(read("garbage\nM108\n") == Act::kEndWait);
  CHECK(read("M1123\n") == Act::kNone);
  CHECK(read("M112 \n") == Act::kNone);
  CHECK(read("M11\n") == Act::kNone);
  CHECK(read("M112") == Act::kNone);
}
