// Areas painted into pixels, with smooth edges. A point is inside where an outline winds round it
// (nonzero rule). Each row of pixels is cut by kRowLines lines, whose pieces inside are measured:
// an area is right to 1/kRowLines of a pixel's height, and exact across.
#pragma once

#include <cstdint>
#include <vector>

#include "host/output/rgba_picture.h"  // RgbaPicture

namespace host {

inline constexpr int kRowLines = 5;

struct Pixel {
  double x = 0;  // from the left
  double y = 0;  // from the top
};

// Closed; the last point joins the first.
using PixelOutline = std::vector<Pixel>;

struct Paint {
  std::uint8_t red = 0, green = 0, blue = 0;
  double opacity = 1;
};

// What may be painted. Empty: x0 > x1.
struct PixelBox {
  double x0 = -1e9, y0 = -1e9, x1 = 1e9, y1 = 1e9;
};

class RasterCanvas {
 public:
  // REQUIRES: both sides are >= 1. COSTS: 4 bytes a pixel.
  RasterCanvas(int width, int height);

  [[nodiscard]] const RgbaPicture& picture() const { return picture_; }

  // COSTS: O(points log points), and kRowLines times the rows that they span.
  void fill(const std::vector<PixelOutline>& outlines, const Paint& paint, const PixelBox& clip);

 private:
  void blend_row(int row, const Paint& paint);

  RgbaPicture picture_;
  std::vector<float> cover_;  // of the row at hand, by pixel
};

}  // namespace host
