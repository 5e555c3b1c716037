// The two kinds of STL file, behind stl.h.
#pragma once

#include <memory>
#include <string_view>

#include "host/files/input_file.h"  // InputFile
#include "host/formats/stl.h"       // StlReader

namespace host {

// The file is as long as a binary STL with the count at its place, whatever its head says. `begin`:
// its first window.
[[nodiscard]] bool is_binary_stl(const InputFile& file, std::string_view begin);
[[nodiscard]] core::Result<std::unique_ptr<StlReader>> open_binary_stl(InputFile file);
[[nodiscard]] core::Result<std::unique_ptr<StlReader>> open_text_stl(InputFile file);

// What text in a file's first window looks like.
enum class StlText {
  kNone,       // bytes that text doesn't have
  kStl,        // solid … facet, solid … endsolid, or cut off before that can be told
  kNotFacets,  // begins with "solid", and goes on otherwise
  kOther,      // some other text
};
[[nodiscard]] StlText text_kind(std::string_view window);

}  // namespace host
