// Paints the program's own drawings (layer_picture.h, section_picture.h) into pixels: a picture as
// PNG is its SVG, painted piece by piece as it is drawn. It knows what these drawings are made of:
// paths of straight lines, rectangles, circles, texts, groups, one clip. Anything else stops the
// program, so that no drawing loses a part silently.
//
// Letters are lines (stroke_letters.h). Lines join round; rectangles have sharp corners.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/output/raster_canvas.h"  // RasterCanvas, Paint
#include "host/output/svg_tags.h"       // SvgTag

namespace host {

// A larger page is scaled down: 16 MB of pixels, and twice as much for a moment when they are
// packed.
inline constexpr double kPaintedPixelsMax = 4e6;

class SvgPainter {
 public:
  SvgPainter();

  // The next piece of the drawing, whole tags. The first one begins the page.
  void paint(std::string_view svg);

  // The PNG file. REQUIRES: the page has begun.
  [[nodiscard]] std::string png() const;

  [[nodiscard]] const RgbaPicture& picture() const { return canvas_->picture(); }
  // How many pixels one of the drawing's takes.
  [[nodiscard]] double scale() const { return page_scale_; }

 private:
  // What a group passes on to what is in it.
  struct State {
    std::optional<Paint> fill, stroke;
    double stroke_width = 1;
    bool round_ends = false;
    double font_size = 14;
    bool bold = false;
    PixelBox clip;
    double scale_x = 1, scale_y = 1, move_x = 0, move_y = 0;
  };

  void begin_page(const SvgTag& tag);
  [[nodiscard]] State state_in(const SvgTag& tag) const;
  [[nodiscard]] static Pixel placed(Pixel point, const State& state);
  void paint_tag(const SvgTag& tag);
  void paint_text(const SvgTag& tag, const State& state);
  void paint_lines(const std::vector<SvgLine>& lines, const State& state);
  [[nodiscard]] std::vector<SvgLine> rectangle(const SvgTag& tag) const;

  std::optional<RasterCanvas> canvas_;
  double page_width_ = 0, page_height_ = 0, page_scale_ = 1;
  std::vector<State> states_;
  bool in_clip_ = false;
  PixelBox clip_;  // of the drawing's one clipPath
};

}  // namespace host
