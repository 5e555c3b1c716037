// Lines that a session sends by itself, besides the commands that it was given.
#pragma once

#include <string>

namespace test {

inline bool is_own_line(const std::string& text) {
  const std::string word = text.substr(0, text.find(' '));
  return word == "M110" || word == "M115" || word == "M155" || word == "M105" || word == "M114" ||
         word == "STATUS" || word == "M211" || text == "G92 E0";
}

}  // namespace test
