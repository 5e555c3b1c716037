// The two kinds of STL file, behind stl.h.
#pragma once

#include <memory>
#include <string_view>

#include "host/files/input_file.h"  // InputFile
#include "host/formats/stl.h"       // StlReader

namespace host {

// True if the file's size is that of a binary STL with its count of facets, whatever the header
// says. `start`: its first window.
[[nodiscard]] bool is_binary_stl(const InputFile& file, std::string_view start);
[[nodiscard]] core::Result<std::unique_ptr<StlReader>> open_binary_stl(InputFile file);
[[nodiscard]] core::Result<std::unique_ptr<StlReader>> open_text_stl(InputFile file);

// The kind of text in a file's first window.
enum class StlText {
  kNone,       // no text
  kStl,        // solid … facet, solid … endsolid, or cut off before that can be decided
  kNotFacets,  // starts with "solid"; something else follows
  kOther,      // some other text
};
[[nodiscard]] StlText text_kind(std::string_view window);

}  // namespace host
