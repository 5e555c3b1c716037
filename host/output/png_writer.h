// PNG files (RFC 2083): eight bits a channel, with opacity.
#pragma once

#include <string>
#include <string_view>

#include "host/output/rgba_picture.h"  // RgbaPicture

namespace host {

// The words of pictures that `rind show` writes: it replaces no other PNG.
inline constexpr std::string_view kPictureWords = "rind show";

// The file's bytes; `software` names its maker in them, near their start. REQUIRES: both sides are
// >= 1 pixel. COSTS: the picture once more, and zlib's own 300 kB, both for the moment.
[[nodiscard]] std::string png_of(const RgbaPicture& picture, std::string_view software = {});

}  // namespace host
