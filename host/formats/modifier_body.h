// A body within which a part's file asks for other settings: a slicer's modifier, or an object that
// has settings of its own.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "host/formats/support_marks.h"  // FacetSpool

namespace host {

// Each is swept on its own.
inline constexpr std::size_t kModifiersMax = 32;

// Keys and values, in the slicer's own words.
using ModifierSettings = std::vector<std::pair<std::string, std::string>>;

struct ModifierBody {
  std::string name;  // for messages: "modifier 'Box'"
  ModifierSettings settings;
  FacetSpool facets{};  // as the part's own: placed by the file, snapped, in any order
};

}  // namespace host
