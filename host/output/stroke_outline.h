// A line of some width as an area: a rectangle for each piece, and disks where they meet.
#pragma once

#include <vector>

#include "host/output/raster_canvas.h"  // Pixel, PixelOutline

namespace host {

struct StrokeForm {
  double width = 1;
  bool round_ends = false;  // otherwise cut off straight
};

// Appends outlines that all wind the same way, so that they are one area together. A line of one
// point is a disk where ends are round, and nothing otherwise.
void append_stroke(const std::vector<Pixel>& points, bool closed, const StrokeForm& form,
                   std::vector<PixelOutline>& outlines);

// A disk as a polygon, within 1/30 of a pixel.
[[nodiscard]] PixelOutline disk(Pixel middle, double radius);

}  // namespace host
