// QOI files (qoiformat.org): pixels as differences, repeats and places in a table of 64 colours.
// Printers with little memory decode them as they come.
#pragma once

#include <string>

#include "host/output/rgba_picture.h"  // RgbaPicture

namespace host {

// The file's bytes: 22, and at most 5 a pixel. REQUIRES: both sides are >= 1 pixel.
[[nodiscard]] std::string qoi_of(const RgbaPicture& picture);

}  // namespace host
