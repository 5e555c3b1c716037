// Thumbnails of the part in the comments of a G-code file, in the form of PrusaSlicer, which
// printers and their web interfaces look for:
//
//     ; thumbnail begin 300x300 24812     the length of the text between
//     ; iVBORw0KGgo…                      base64, 78 characters a line
//     ; thumbnail end
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"                   // Result
#include "host/output/thumbnail_format.h"  // ThumbnailFormat

namespace host {

class PartView;

struct Thumbnail {
  int width = 0;
  int height = 0;
  ThumbnailFormat format = ThumbnailFormat::kPng;
};

inline constexpr std::size_t kThumbnailsMax = 8;
inline constexpr int kThumbnailSideMin = 16, kThumbnailSideMax = 800;

// "16x16/QOI, 300x300": sizes in pixels, and a format for each that has another one than `format`.
// Empty: none. The error names the piece and what is expected.
[[nodiscard]] core::Result<std::vector<Thumbnail>> read_thumbnails(std::string_view text,
                                                                   ThumbnailFormat format);

// Appends the comments. Memory for one picture at a time. REQUIRES: the view isn't empty.
void append_thumbnails(const PartView& view, const std::vector<Thumbnail>& thumbnails,
                       std::string& gcode);

}  // namespace host
