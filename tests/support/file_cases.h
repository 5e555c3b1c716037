// Files as programs and people make them, each with the expected result: its volume and number of
// layers of 0.2 mm, or a refusal, and words that the messages must contain.
#pragma once

#include <string>
#include <vector>

#include "tools/parts/part_maker.h"  // Part

namespace test {

struct FileCase {
  std::string name;
  std::string bytes;
  double volume_mm3 = 0;  // 0: it is refused
  int layers = 0;
  std::vector<std::string> says;
};

// 20 × 20 × 10 mm: 4000 mm³ in 50 layers.
[[nodiscard]] parts::Part case_box();
// A counter-clockwise polygon that is convex, or visible as a whole from its first corner.
[[nodiscard]] parts::Part prism(const std::vector<parts::Corner>& polygon, double height);
// The same with every facet seen from behind.
[[nodiscard]] parts::Part inside_out(parts::Part part);

[[nodiscard]] std::vector<FileCase> obj_cases();
[[nodiscard]] std::vector<FileCase> amf_cases();
[[nodiscard]] std::vector<FileCase> stl_cases();         // ways of writing
[[nodiscard]] std::vector<FileCase> mesh_cases();        // shapes
[[nodiscard]] std::vector<FileCase> inside_out_cases();  // shapes that are turned over
[[nodiscard]] std::vector<FileCase> threemf_cases();
[[nodiscard]] std::vector<FileCase> threemf_role_cases();  // negative parts, modifiers
[[nodiscard]] std::vector<FileCase> zip_cases();

}  // namespace test
