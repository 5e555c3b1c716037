// PNG files (RFC 2083): eight bits a channel, with opacity.
#pragma once

#include <string>

#include "host/output/rgba_picture.h"  // RgbaPicture

namespace host {

// The file's bytes. REQUIRES: both sides are >= 1 pixel. COSTS: the picture once more, and zlib's
// own 300 kB, both for the moment.
[[nodiscard]] std::string png_of(const RgbaPicture& picture);

}  // namespace host
