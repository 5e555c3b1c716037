// Reads the words of `rind show` for the cut that it draws.
#pragma once

#include <string>

#include "core/result.h"  // Result

namespace host {

// Where `show --section` cuts: "Y=12.5" is 12.5 mm behind the part's front, "X=50%" half-way
// between its left and its right side.
struct SectionPlace {
  char axis = 'Y';  // or 'X'
  double value = 0;
  bool percent = false;  // otherwise mm
};

// The square of the section that `show --zoom` draws, in mm: its middle (from the part's edge, and
// above the bed) and its side.
struct SectionZoom {
  double along = 0;
  double height = 0;
  double size = 0;
};

// Read "X=50%" and "4,10,6". Errors say how to write it.
[[nodiscard]] core::Result<SectionPlace> section_place(const std::string& text);
[[nodiscard]] core::Result<SectionZoom> section_zoom(const std::string& text);

}  // namespace host
