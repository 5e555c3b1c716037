// 3MF files in which bodies and painted facets mark where supports are to be, as slicers write
// them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tools/parts/part_maker.h"  // Part

namespace test {

// Keys and values in the slicer's words.
using BodySettings = std::vector<std::pair<std::string, std::string>>;

struct MarkedBody {
  parts::Part part;
  std::string type;  // "ModelPart", "SupportEnforcer"; in OrcaSlicer's words "normal_part" …
  // What is painted on its facet of that number, for supports; empty: nothing.
  std::function<std::string(std::int64_t)> paint{};
  BodySettings settings{};  // of a modifier
};

// One object, whose triangles belong to volumes; with an item for each transform.
[[nodiscard]] std::string prusa_threemf(const std::vector<MarkedBody>& bodies,
                                        const std::vector<std::string>& transforms = {""},
                                        const BodySettings& of_object = {});

// Objects with names, each with an item.
struct NamedItem {
  std::string name;
  parts::Part part;
  std::string transform;  // "1 0 0 0 1 0 0 0 1 30 0 0"; may be empty
};
[[nodiscard]] std::string named_threemf(const std::vector<NamedItem>& items);

// An object for each body, which are components of another.
[[nodiscard]] std::string orca_threemf(const std::vector<MarkedBody>& bodies,
                                       const BodySettings& of_object = {});

}  // namespace test
