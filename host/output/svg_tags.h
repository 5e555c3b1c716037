// The tags and numbers of the pictures that this program draws. No reader of any SVG: layers of
// foreign files are read in formats/.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "host/output/raster_canvas.h"  // Pixel

namespace host {

struct SvgTag {
  std::string_view name;  // "path"; "/g" where it ends
  std::map<std::string_view, std::string_view> attributes;
  bool closed = false;    // ends by itself
  std::string_view text;  // behind it, up to the next tag
};

// All tags of a piece of a drawing. REQUIRES: it holds whole tags.
[[nodiscard]] std::vector<SvgTag> svg_tags(std::string_view svg);

// The first number, which is taken off with what separates it. REQUIRES: there is one.
[[nodiscard]] double take_number(std::string_view& text);
[[nodiscard]] bool has_number(std::string_view text);

struct SvgLine {
  std::vector<Pixel> points;
  bool closed = false;
};

// "M1 2h3v-4zM…": straight lines, absolute or relative.
[[nodiscard]] std::vector<SvgLine> svg_lines(std::string_view data);

// Without "&amp;" and the like.
[[nodiscard]] std::string unescaped(std::string_view text);

}  // namespace host
