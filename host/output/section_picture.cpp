#include "host/output/section_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "core/sections/wall_regions.h"
#include "core/walls/wall_style.h"

namespace host {
namespace {

constexpr double kWidePx = 840;        // a wide part's longer side
constexpr double kWideHeightPx = 560;  // and at most its height
constexpr double kPairWidthPx = 440;   // of each, where two squarish ones stand side by side
constexpr double kPairHeightPx = 480;
constexpr double kTallHeightPx = 900;
constexpr double kTallWidthPx = 460;
// A needle-like part is drawn this wide, unless its rows would then be taller than this. Its page
// is as tall as needed.
constexpr double kNeedlePx = 110;
constexpr double kNeedleRowPx = 2;
constexpr double kPadPx = 66;      // beside the part: room for a measure
constexpr double kPadTopPx = 30;   // over it
constexpr double kLetterPx = 7.5;  // of the subtitle, about
constexpr double kSideLegendPx = 490;
constexpr double kPageHeightMaxPx = 16'000;  // as shown; the drawing's own height may be larger
constexpr double kBallPxMin = 4;
constexpr std::size_t kBallHeights = 6;
// Rows that are not whole pixels overlap the next row by this much, so that no gap shows.
constexpr double kSeamPx = 1;

constexpr std::array<std::size_t, 5> kLegendOrder = {1, 2, 3, 4, 0};

double rounded_px(double px) { return std::round(px * 100) / 100; }

void append_bed(std::string& svg, double left, double width, double y) {
  const auto out = std::back_inserter(svg);
  fmt::format_to(out,
                 "<path d=\"M{0} {1}h{2}\" stroke=\"#6b6459\" stroke-width=\"1.4\"/>"
                 "<path d=\"",
                 left, y + 0.7, width);
  for (int i = 0; 7 + 9 * i <= width; ++i) {
    fmt::format_to(out, "M{:.1f} {:.1f}l-6 7", left + 7 + 9 * i, y + 1.4);
  }
  fmt::format_to(out, "\" stroke=\"#a59d90\" stroke-width=\"1\"/>\n");
}

}  // namespace

SectionPicture::SectionPicture(Options options) : options_(std::move(options)) { lay_out(); }

const Colours& SectionPicture::colours_of(std::size_t tint) const {
  const std::array<const Colours*, kTints> colours = {&kLooseColours, &kOwnColours,
                                                      &kUncoveredColours, &kNeighbourColours,
                                                      &further_colours(options_.settings)};
  return *colours[tint];
}

// No balls if the window does not decide, nor if they would be specks.
bool SectionPicture::shows_balls() const {
  return core::window_decides(options_.settings) &&
         options_.settings.wall_thickness.mm() * px_per_mm_ >= kBallPxMin;
}

void SectionPicture::lay_out() {
  const core::Box& box = options_.box;
  const bool along_x = options_.line.across == core::SectionLine::Across::kY;
  view_ = {{along_x ? box.min.x : box.min.y, along_x ? box.max.x : box.max.y}, {}, options_.height};
  if (options_.view) view_ = *options_.view;
  const double width_mm = std::max(0.01, to_mm(view_.along.to - view_.along.from));
  const double height_mm = std::max(0.01, (view_.top - view_.bottom).mm());
  const double row_mm = options_.settings.layer_height.mm();
  const auto scale = [&](double width_px, double height_px) {
    return std::min(width_px / width_mm, height_px / height_mm);
  };
  layout_ = width_mm >= 0.8 * height_mm ? Layout::kStacked : Layout::kTall;
  px_per_mm_ = layout_ == Layout::kStacked ? scale(kWidePx, kWideHeightPx)
                                           : scale(kTallWidthPx, kTallHeightPx);
  const double paired = scale(kPairWidthPx, kPairHeightPx);
  if (layout_ == Layout::kStacked && width_mm < 1.5 * height_mm && paired * row_mm >= kBeadRowPx) {
    layout_ = Layout::kPaired;
    px_per_mm_ = paired;
  }
  px_per_mm_ = std::max(px_per_mm_, std::min(kNeedlePx / width_mm, kNeedleRowPx / row_mm));
  // A whole number of pixels for a row, if that is near enough: edges are sharp then.
  seam_px_ = kSeamPx;
  const double row_px = row_mm * px_per_mm_;
  if (row_px >= 2 && !core::has_unequal_layers(options_.settings)) {
    px_per_mm_ *= std::floor(row_px) / row_px;
    seam_px_ = 0;
  }
  place_panels(std::ceil(width_mm * px_per_mm_), std::floor(row_px) >= kBeadRowPx);
  page_width_ = std::max(page_width_,
                         2 * kMarginPx + kLetterPx * static_cast<double>(options_.subtitle.size()));
}

void SectionPicture::place_panels(double width, bool beads) {
  const double height = panel_height_px();
  const double top = kTitlePx + kPadTopPx;
  const double beneath = top + height + 2 * kLegendRowPx;
  legend_left_ = bead_legend_left_ = kMarginPx;
  legend_top_ = beneath;
  bead_legend_top_ = beneath + 5.5 * kLegendRowPx;
  if (layout_ == Layout::kStacked) {
    page_width_ = kWidePx + 2 * kPadPx;
    const double inset = std::floor((page_width_ - width) / 2);
    panels_.push_back({inset, top});
    if (beads) panels_.push_back({inset, bead_legend_top_});
    page_height_ = bead_legend_top_ - kLegendRowPx;
    if (!beads) return;
    bead_legend_top_ += height + 2 * kLegendRowPx;
    page_height_ = bead_legend_top_ + 3.2 * kLegendRowPx;
  } else if (layout_ == Layout::kPaired) {
    page_width_ = std::max(2 * width + 3 * kPadPx, 2 * kSideLegendPx);
    const double gap = std::floor((page_width_ - 2 * width) / 3);
    panels_.push_back({gap, top});
    panels_.push_back({2 * gap + width, top});
    page_height_ = bead_legend_top_ + 3.2 * kLegendRowPx;
  } else {
    panels_.push_back({kPadPx, top});
    if (beads) panels_.push_back({2 * kPadPx + width, top});
    legend_left_ = bead_legend_left_ = panels_.back().left + width + kPadPx;
    legend_top_ = top + kLegendRowPx / 2;
    bead_legend_top_ = legend_top_ + 11 * kLegendRowPx;
    page_width_ = legend_left_ + kSideLegendPx;
    page_height_ = std::max(beneath, legend_top_ + (beads ? 16 : 11) * kLegendRowPx);
  }
}

double SectionPicture::panel_height_px() const {
  return std::ceil((view_.top - view_.bottom).mm() * px_per_mm_);
}

double SectionPicture::along_px(std::int64_t units) const {
  return panels_[0].left + to_mm(units - view_.along.from) * px_per_mm_;
}

double SectionPicture::height_px(core::Length height) const {
  return panels_[0].top + panel_height_px() - (height - view_.bottom).mm() * px_per_mm_;
}

// A layer is in view if more than half of its height is.
bool SectionPicture::in_view(const core::Slice& slice) const {
  const core::Length middle = slice.bottom + core::Length::from_units(slice.height.units() / 2);
  return view_.bottom <= middle && middle <= view_.top;
}

core::Intervals SectionPicture::in_view(const core::Intervals& intervals) const {
  return core::intersect(intervals, {view_.along});
}

bool SectionPicture::in_view(const Ball& ball) const {
  const double left = along_px(view_.along.from), right = along_px(view_.along.to);
  const double top = height_px(view_.top), bottom = height_px(view_.bottom);
  return left <= ball.x && ball.x <= right && top <= ball.y && ball.y <= bottom;
}

std::string SectionPicture::start() {
  std::string svg;
  start_page(svg, page_width_, page_height_, kPageHeightMaxPx);
  append_title(svg, options_.title, options_.subtitle);
  const double width = to_mm(view_.along.to - view_.along.from) * px_per_mm_;
  for (const Panel& panel : panels_) {
    const double bed = panel.top + panel_height_px();
    if (view_.bottom == core::Length()) {
      append_bed(svg, panel.left - kPadPx / 2, width + kPadPx, bed);
    }
    if (!options_.view) continue;
    fmt::format_to(std::back_inserter(svg),
                   "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
                   "fill=\"#fff\" stroke=\"#d8d0c2\" stroke-width=\"3\"/>\n",
                   panel.left, panel.top, width, bed - panel.top);
  }
  // Measures may reach out of a view; they must not cover the legend.
  if (options_.view) {
    fmt::format_to(std::back_inserter(svg),
                   "<clipPath id=\"view\"><rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" "
                   "height=\"{:.2f}\"/></clipPath>\n",
                   panels_[0].left, panels_[0].top, width, panel_height_px());
  }
  return svg;
}

std::string SectionPicture::roads(const core::Slice& slice, const std::vector<core::Road>& roads) {
  if (!in_view(slice)) return {};
  const double dx = panels_[1].left - panels_[0].left, dy = panels_[1].top - panels_[0].top;
  const double thickness = slice.height.mm() * px_per_mm_;
  const double y = rounded_px((height_px(slice.bottom) + height_px(slice.top())) / 2 + dy);
  std::array<std::string, core::kRoadKindCount> paths;
  for (const core::Road& road : roads) {
    if (road.kind == core::RoadKind::kSkirt) continue;
    const auto kind = static_cast<std::size_t>(road.kind);
    for (const core::Interval& met : in_view(core::section_of(road, options_.line))) {
      // A line with round ends, as thick as the layer, is a bead's cross-section.
      const double from = along_px(met.from) + dx + thickness / 2;
      const double to = std::max(along_px(met.to) + dx - thickness / 2, from + 0.01);
      fmt::format_to(std::back_inserter(paths[kind]), "M{} {}H{}", rounded_px(from), y,
                     rounded_px(to));
      kind_seen_[kind] = true;
    }
  }
  std::string svg;
  for (const KindStyle& style : kKindStyles) {
    const std::string& path = paths[static_cast<std::size_t>(style.kind)];
    if (path.empty()) continue;
    fmt::format_to(std::back_inserter(svg),
                   "<path d=\"{0}\" stroke=\"{1}\" stroke-width=\"{2:.4g}\" fill=\"none\" "
                   "stroke-linecap=\"round\"/>"
                   "<path d=\"{0}\" stroke=\"{3}\" stroke-width=\"{4:.4g}\" fill=\"none\" "
                   "stroke-linecap=\"round\"/>\n",
                   path, style.colours.edge, thickness, style.colours.body, thickness * 0.74);
  }
  return svg;
}

std::string SectionPicture::layer(const core::LayerWindow& window) {
  const core::WallSection section = core::wall_section(window, options_.line);
  const core::Slice& slice = window.layer().slice;
  const std::array<const core::Intervals*, kTints> tints = {
      &section.loose, &section.own, &section.uncovered, &section.neighbours, &section.further};
  RowPieces row;
  for (std::size_t tint = 0; in_view(slice) && tint < kTints; ++tint) {
    for (const core::Interval& piece : in_view(*tints[tint])) {
      const double from = rounded_px(along_px(piece.from));
      row[tint].emplace_back(from, rounded_px(along_px(piece.to)) - from);
      tint_seen_[tint] = true;
    }
  }
  std::string svg;
  if (row != row_ || slice.bottom != row_top_) {
    flush_row(svg);
    row_ = std::move(row);
    row_bottom_ = slice.bottom;
  }
  row_top_ = slice.top();

  const double loose_mm = core::total_length(section.loose).mm();
  loose_mm2_ += loose_mm * slice.height.mm();
  solid_mm2_ += (core::total_length(section.slice).mm() - loose_mm) * slice.height.mm();
  if (!section.loose.empty()) {
    const auto widest = std::max_element(section.loose.begin(), section.loose.end(),
                                         [](const core::Interval& a, const core::Interval& b) {
                                           return a.to - a.from < b.to - b.from;
                                         });
    highest_loose_ = slice.bottom + core::Length::from_units(slice.height.units() / 2);
    highest_loose_along_ = widest->from + (widest->to - widest->from) / 2;
  }
  if (options_.settings.spiral_vase) return svg;  // open at the top
  const std::optional<core::ThinnestWall> place = core::thinnest_wall(window, options_.line);
  if (place && (!thinnest_ || place->thickness_mm < thinnest_->thickness_mm)) thinnest_ = place;
  if (in_view(slice)) note_balls(slice, in_view(section.loose));
  return svg;
}

void SectionPicture::flush_row(std::string& svg) {
  const double top = rounded_px(height_px(row_top_) - seam_px_);
  const double tall = rounded_px(height_px(row_bottom_) - top);
  for (std::size_t tint = 0; tint < kTints; ++tint) {
    if (row_[tint].empty()) continue;
    fmt::format_to(std::back_inserter(svg), "<path fill=\"{}\" d=\"", colours_of(tint).body);
    for (const auto& [from, width] : row_[tint]) {
      fmt::format_to(std::back_inserter(svg), "M{} {}h{}v{}h-{}z", from, top, rounded_px(width),
                     tall, rounded_px(width));
    }
    svg += "\"/>\n";
  }
}

// Notes the balls to draw: at both outer ends of the inside, at a few heights.
void SectionPicture::note_balls(const core::Slice& slice, const core::Intervals& loose) {
  if (loose.empty()) return;
  const core::Length middle = slice.bottom + core::Length::from_units(slice.height.units() / 2);
  const core::Length tall = view_.top - view_.bottom;
  const auto due = [&] {
    const auto share = static_cast<double>(next_ball_) / static_cast<double>(kBallHeights);
    return next_ball_ < kBallHeights && (middle - view_.bottom).mm() >= share * tall.mm();
  };
  if (!due()) return;
  while (due()) ++next_ball_;
  // Not where the view ends within the inside.
  if (loose.front().from > view_.along.from) {
    balls_.push_back({along_px(loose.front().from), height_px(middle)});
  }
  if (loose.back().to < view_.along.to) {
    balls_.push_back({along_px(loose.back().to), height_px(middle)});
  }
}

void SectionPicture::append_measures(std::string& svg) {
  const auto out = std::back_inserter(svg);
  const core::Settings& settings = options_.settings;
  const double radius = settings.wall_thickness.mm() * px_per_mm_;
  if (shows_balls()) {
    const Ball highest{along_px(highest_loose_along_), height_px(highest_loose_)};
    if (highest_loose_ > core::Length() && in_view(highest)) balls_.push_back(highest);
    fmt::format_to(out,
                   "<g fill=\"#fff\" fill-opacity=\".18\" stroke=\"#3a2c14\" "
                   "stroke-width=\"1.1\"{}>\n",
                   options_.view ? " clip-path=\"url(#view)\"" : "");
    const double reach = (core::wall_layers(settings) + 0.5) * settings.layer_height.mm();
    for (const Ball& ball : balls_) {
      if (settings.wall_shape == core::WallShape::kBall) {
        fmt::format_to(out, "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>", ball.x, ball.y,
                       radius);
      } else {
        fmt::format_to(out, "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"/>",
                       ball.x - radius, ball.y - reach * px_per_mm_, 2 * radius,
                       2 * reach * px_per_mm_);
      }
      fmt::format_to(out, "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"1\" fill=\"#3a2c14\"/>\n",
                     ball.x, ball.y);
    }
    svg += "</g>\n";
  }
  if (!thinnest_) return;
  if (!in_view({along_px(thinnest_->loose_along.units()), height_px(thinnest_->loose_height)}))
    return;
  const double x0 = along_px(thinnest_->loose_along.units()),
               y0 = height_px(thinnest_->loose_height);
  const double x1 = along_px(thinnest_->outside_along.units()),
               y1 = height_px(thinnest_->outside_height);
  const double length = std::max(0.01, std::hypot(x1 - x0, y1 - y0));
  const double ux = (x1 - x0) / length, uy = (y1 - y0) / length;
  fmt::format_to(out,
                 "<path d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}m{:.2f} {:.2f}l{:.2f} {:.2f}\" "
                 "stroke=\"#b00020\" stroke-width=\"2\" fill=\"none\"/>"
                 "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"2.4\" fill=\"#b00020\"/>",
                 x0, y0, x1, y1, -4 * uy, 4 * ux, 8 * uy, -8 * ux, x0, y0);
  const char* anchor = ux > 0.35 ? "start" : ux < -0.35 ? "end" : "middle";
  fmt::format_to(out,
                 "<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\" font-size=\"12\" "
                 "fill=\"#b00020\" font-weight=\"600\">{:.2f}</text>\n",
                 x1 + 7 * ux, y1 + 4 + (uy > 0 ? 16 : 8) * uy, anchor, thinnest_->thickness_mm);
}

void SectionPicture::append_legend(std::string& svg) {
  const RegionWords words = region_words(options_.settings);
  const std::array<std::string, kTints> texts = {words.loose, words.own, words.uncovered,
                                                 words.neighbours, words.further};
  double y = legend_top_;
  for (const std::size_t tint : kLegendOrder) {
    if (!tint_seen_[tint]) continue;
    append_legend_row(svg, legend_left_, y, colours_of(tint), texts[tint]);
    y += kLegendRowPx;
  }
  const bool wide = layout_ != Layout::kTall;
  const double x = wide ? legend_left_ + kSideLegendPx : legend_left_;
  y = wide ? legend_top_ : y + kLegendRowPx / 2;
  append_scale_bar(svg, x, y, px_per_mm_, 150);
  y += kLegendRowPx;
  const double whole = std::max(1e-9, solid_mm2_ + loose_mm2_);
  append_text(svg, x, y,
              fmt::format("{}wall {:.1f} mm² ({:.0f} %), inside {:.1f} mm² ({:.0f} %)",
                          options_.view ? "whole cut: " : "", solid_mm2_, 100 * solid_mm2_ / whole,
                          loose_mm2_, 100 * loose_mm2_ / whole));
  y += kLegendRowPx;
  if (!balls_.empty() && shows_balls()) {
    const bool ball = options_.settings.wall_shape == core::WallShape::kBall;
    append_text(svg, x, y,
                fmt::format("{}, {:g} mm in radius, rolled along the inside's edge",
                            ball ? "balls" : "cylinders", options_.settings.wall_thickness.mm()));
    y += kLegendRowPx;
  }
  if (thinnest_) {
    append_text(svg, x, y,
                fmt::format("thinnest wall in the whole cut: {:.3f} mm", thinnest_->thickness_mm));
  }
  if (!shows_roads()) return;
  std::size_t row = 0;
  for (const KindStyle& style : kKindStyles) {
    if (!kind_seen_[static_cast<std::size_t>(style.kind)]) continue;
    const std::size_t before = row / 3;  // columns
    const double column = wide ? static_cast<double>(before) * 215 : 0;
    const double down = static_cast<double>(wide ? row % 3 : row);
    append_legend_row(svg, bead_legend_left_ + column, bead_legend_top_ + down * kLegendRowPx,
                      style.colours, style.name);
    ++row;
  }
}

std::string SectionPicture::end() {
  std::string svg;
  flush_row(svg);
  // The part's top, which the windows below don't reach.
  const double over_mm = (options_.height - highest_loose_).mm();
  if (thinnest_ && over_mm < thinnest_->thickness_mm) {
    const core::Length along = core::Length::from_units(highest_loose_along_);
    thinnest_ = core::ThinnestWall{over_mm, along, highest_loose_, along, options_.height};
  }
  append_measures(svg);
  append_legend(svg);
  end_page(svg);
  return svg;
}

}  // namespace host
