// Letters as lines, for pictures of pixels: no font has to be installed. ASCII, and a few signs
// that pictures use; any other letter is an empty box.
#pragma once

#include <string_view>
#include <vector>

#include "host/output/raster_canvas.h"  // Pixel

namespace host {

// How far a text reaches to the right.
[[nodiscard]] double text_width(std::string_view utf8, double font_size);

// The lines of a text that begins at `at`, on its base line. Lines of one point are dots.
[[nodiscard]] std::vector<std::vector<Pixel>> text_lines(std::string_view utf8, Pixel at,
                                                         double font_size);

}  // namespace host
