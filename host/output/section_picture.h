// Draws a vertical cut through a part as SVG, layer by layer. It holds only the window and one row,
// whatever the part's height.
//
//     ┌ title ──────────────────────────────────────┐
//     │  the wall's regions,     │  roads as beads,  │   one scale for both; roads only where a
//     │  the inside, balls of    │  cut across       │   layer is kBeadRowPx tall or more
//     │  the wall's thickness    │                   │
//     │  legend, scale, measurements                 │
//     └──────────────────────────────────────────────┘
//
// Rows that look the same are drawn as one, so that the picture of an upright part stays small.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry.h"               // Box
#include "core/roads/road.h"             // Road
#include "core/sections/layer_window.h"  // LayerWindow
#include "core/sections/section.h"       // SectionLine
#include "core/sections/wall_gauge.h"    // ThinnestWall
#include "core/settings.h"               // Settings
#include "core/units.h"                  // Length
#include "host/output/picture_style.h"   // Colours

namespace host {

inline constexpr double kBeadRowPx = 3;

class SectionPicture {
 public:
  // A view of the cut: an interval along the line, and heights above the bed.
  struct View {
    core::Interval along;
    core::Length bottom, top;
  };

  struct Options {
    std::string title;     // the part's name
    std::string subtitle;  // where it is cut
    core::SectionLine line;
    core::Box box;        // of the part
    core::Length height;  // of the part
    // The part of the cut that is drawn; nullopt: all of it.
    std::optional<View> view;
    core::Settings settings;
  };

  explicit SectionPicture(Options options);

  // Whether the scale is large enough for roads; if not, roads() is not called.
  [[nodiscard]] bool shows_roads() const { return panels_.size() > 1; }

  // Each returns the next piece of the picture's text: start() once, roads() and layer() for every
  // layer from the bed up, end() once.
  [[nodiscard]] std::string start();
  // REQUIRES: shows_roads(). `bottom` and `height` are the layer's.
  [[nodiscard]] std::string roads(const core::Slice& slice, const std::vector<core::Road>& roads);
  // Draws window.layer(). COSTS: as wall_section() and thinnest_wall().
  [[nodiscard]] std::string layer(const core::LayerWindow& window);
  [[nodiscard]] std::string end();

  // The thinnest wall measured so far; nullopt if the cut has met no loose region.
  [[nodiscard]] const std::optional<core::ThinnestWall>& thinnest() const { return thinnest_; }
  // Areas of the cut, in mm².
  [[nodiscard]] double solid_mm2() const { return solid_mm2_; }
  [[nodiscard]] double loose_mm2() const { return loose_mm2_; }

 private:
  static constexpr std::size_t kTints = 5;
  // Left end and width in px, for each tint.
  using RowPieces = std::array<std::vector<std::pair<double, double>>, kTints>;

  struct Panel {
    double left = 0, top = 0;  // of the part's box, in px
  };

  struct Ball {
    double x = 0, y = 0;
  };

  // kStacked: the panels one above the other; kPaired: side by side, the legend below; kTall: side
  // by side, the legend beside them.
  enum class Layout { kStacked, kPaired, kTall };

  [[nodiscard]] const Colours& colours_of(std::size_t tint) const;
  [[nodiscard]] bool shows_balls() const;
  void lay_out();
  void place_panels(double width, bool beads);
  [[nodiscard]] double panel_height_px() const;
  [[nodiscard]] bool in_view(const core::Slice& slice) const;
  [[nodiscard]] core::Intervals in_view(const core::Intervals& intervals) const;
  [[nodiscard]] bool in_view(const Ball& ball) const;
  [[nodiscard]] double along_px(std::int64_t units) const;
  [[nodiscard]] double height_px(core::Length height) const;
  void flush_row(std::string& svg);
  void note_balls(const core::Slice& slice, const core::Intervals& loose);
  void append_measures(std::string& svg);
  void append_legend(std::string& svg);

  Options options_;
  Layout layout_ = Layout::kStacked;
  double px_per_mm_ = 1;
  double seam_px_ = 0;
  double page_width_ = 0, page_height_ = 0;
  double legend_left_ = 0, legend_top_ = 0;
  double bead_legend_left_ = 0, bead_legend_top_ = 0;
  View view_;
  std::vector<Panel> panels_;

  // Rows that look the same and are not written yet.
  RowPieces row_;
  core::Length row_bottom_, row_top_;

  std::optional<core::ThinnestWall> thinnest_;
  core::Length highest_loose_;            // the middle of that layer
  std::int64_t highest_loose_along_ = 0;  // the middle of its widest interval
  std::vector<Ball> balls_;               // two at each of kBallHeights heights, and the highest
  std::size_t next_ball_ = 0;
  double solid_mm2_ = 0, loose_mm2_ = 0;
  std::array<bool, kTints> tint_seen_{};
  std::array<bool, core::kRoadKindCount> kind_seen_{};
};

}  // namespace host
