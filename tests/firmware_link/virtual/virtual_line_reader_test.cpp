#include "firmware_link/virtual/virtual_line_reader.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using firmware_link::VirtualLineReader;

namespace {

std::vector<std::string> lines_of(const std::string& bytes, bool marlin) {
  VirtualLineReader reader(marlin);
  std::vector<std::string> lines;
  for (const char c : bytes) {
    if (reader.read(c)) lines.emplace_back(reader.take().text());
  }
  return lines;
}

}  // namespace

TEST_CASE("lines end with either end of line, and comments are left out") {
  CHECK(lines_of("G1 X1\nM105 ; now\r\n;only\nG4", true) ==
        std::vector<std::string>{"G1 X1", "M105 ", "", ""});
}

TEST_CASE("backslash and backspace mean something to Marlin alone") {
  CHECK(lines_of("M117 a\\;b\nG11\b X1\n", true) == std::vector<std::string>{"M117 a;b", "G1 X1"});
  CHECK(lines_of("M117 a\\;b\nG1\b\n", false) == std::vector<std::string>{"M117 a\\", "G1\b"});
}

TEST_CASE("what is over 95 characters is dropped, and a cleared line is gone") {
  CHECK(lines_of(std::string(200, 'x') + "\n", true)[0].size() == 95);
  VirtualLineReader reader(true);
  for (const char c : std::string("abc;")) CHECK_FALSE(reader.read(c));
  reader.clear();
  CHECK_FALSE(reader.read('d'));
  CHECK(reader.read('\n'));
  CHECK(reader.take().text() == "d");
}
