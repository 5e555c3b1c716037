#include "host/output/layer_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/check.h"
#include "core/motions/width_stretches.h"  // width_stretches
#include "core/regions/polyline.h"         // length_mm
#include "core/sections/wall_regions.h"
#include "host/output/picture_style.h"

namespace host {
namespace {

constexpr double kPanelPx = 640;  // longest side of a panel
constexpr int kAreaRows = 7;      // of the left panel's legend, at most

using Text = std::back_insert_iterator<std::string>;

// Of each road, in printing order.
using Stretches = std::vector<std::vector<core::WidthStretch>>;

Stretches stretches_of(const LayerPicture& picture) {
  Stretches all;
  all.reserve(picture.roads->size());
  for (const core::Road& road : *picture.roads) {
    all.push_back(core::width_stretches(road, picture.window->layer().slice.height * road.layers));
  }
  return all;
}

// Positions on the page, in pixels; the part itself is drawn in mm and scaled.
struct Frame {
  core::Box box;  // of everything drawn
  double px_per_mm = 1;
  double panel_width = 0;
  double panel_height = 0;
  bool stacked = false;  // a wide part: panels one above the other
  int legend_rows = 0;   // kinds of road

  [[nodiscard]] double left(int panel) const {
    return kMarginPx + (stacked ? 0 : panel * (panel_width + kMarginPx));
  }
  [[nodiscard]] double top(int panel) const {
    return kTitlePx + (stacked ? panel * (panel_height + (kAreaRows + 1.5) * kLegendRowPx) : 0);
  }
  [[nodiscard]] double page_width() const {
    return stacked ? panel_width + 2 * kMarginPx : 2 * panel_width + 3 * kMarginPx;
  }
  [[nodiscard]] double page_height() const {
    const int rows = std::max(stacked ? 0 : kAreaRows, legend_rows);
    return top(1) + panel_height + (rows + 1) * kLegendRowPx;
  }
};

Frame frame_of(const LayerPicture& picture, const Stretches& roads) {
  Frame frame;
  core::Box box = picture.window->layer().slice.region.box();
  std::int64_t width_most = 0;
  for (const core::Road& road : *picture.roads) {
    for (const core::Point point : road.points) box.add(point);
    width_most = std::max(width_most, widest(road).units());
  }
  if (box.empty()) box = {{0, 0}, {100'000, 100'000}};
  const auto border = static_cast<std::int32_t>(width_most);
  frame.box = {{box.min.x - border, box.min.y - border}, {box.max.x + border, box.max.y + border}};

  const double width_mm = std::max(0.1, to_mm(std::int64_t{frame.box.max.x} - frame.box.min.x));
  const double height_mm = std::max(0.1, to_mm(std::int64_t{frame.box.max.y} - frame.box.min.y));
  frame.stacked = width_mm > 1.5 * height_mm;
  const double panel_px = frame.stacked ? 1.5 * kPanelPx : kPanelPx;
  frame.px_per_mm = panel_px / std::max(width_mm, height_mm);
  for (const KindStyle& style : kKindStyles) {
    const bool there = std::any_of(roads.begin(), roads.end(), [&](const auto& road) {
      return std::any_of(road.begin(), road.end(),
                         [&](const core::WidthStretch& s) { return s.kind == style.kind; });
    });
    frame.legend_rows += there ? 1 : 0;
  }
  frame.panel_width = std::max(kPanelPx, width_mm * frame.px_per_mm);
  frame.panel_height = height_mm * frame.px_per_mm;
  return frame;
}

void append_points(Text out, const std::vector<core::Point>& points, bool closed) {
  char letter = 'M';
  for (const core::Point point : points) {
    fmt::format_to(out, "{}{:.6g} {:.6g}", letter, to_mm(point.x), to_mm(point.y));
    letter = 'L';
  }
  if (closed) fmt::format_to(out, "Z");
}

void append_region(Text out, const core::Region& region, const std::string& attributes) {
  if (region.empty()) return;
  fmt::format_to(out, "<path {} d=\"", attributes);
  for (const core::Ring& ring : region.rings()) append_points(out, ring, true);
  fmt::format_to(out, "\"/>\n");
}

// A bead: its shaded sides over the full width, then its lighter back.
void append_road(Text out, const std::vector<core::WidthStretch>& road) {
  const auto append = [&](const char* Colours::*colour, double share) {
    for (const core::WidthStretch& stretch : road) {
      fmt::format_to(out, "<path d=\"");
      append_points(out, stretch.points, stretch.closed);
      fmt::format_to(out, "\" stroke=\"{}\" stroke-width=\"{:.4g}\"/>",
                     style_of(stretch.kind).colours.*colour, stretch.width.mm() * share);
    }
  };
  append(&Colours::edge, 1);
  append(&Colours::body, 0.74);
  fmt::format_to(out, "\n");
}

void start_panel(Text out, const Frame& frame, int panel) {
  // The part's y axis points up, the page's down.
  const double slack =
      frame.panel_width - to_mm(std::int64_t{frame.box.max.x} - frame.box.min.x) * frame.px_per_mm;
  fmt::format_to(
      out,
      "<g transform=\"translate({:.2f} {:.2f}) scale({:.6g} {:.6g}) translate({:.6g} {:.6g})\">\n",
      frame.left(panel) + slack / 2, frame.top(panel) + frame.panel_height, frame.px_per_mm,
      -frame.px_per_mm, -to_mm(frame.box.min.x), -to_mm(frame.box.min.y));
}

struct Area {
  const core::Region* region;
  const Colours* colours;
  std::string words;
};

// In the order of the legend.
std::vector<Area> areas_of(const core::WallRegions& regions, const core::SplitLayer& layer,
                           const core::Settings& settings) {
  const RegionWords words = region_words(settings);
  return {{&regions.own, &kOwnColours, words.own},
          {&regions.uncovered, &kUncoveredColours, words.uncovered},
          {&regions.neighbours, &kNeighbourColours, words.neighbours},
          {&regions.further, &further_colours(settings), words.further},
          {&layer.loose, &kLooseColours, words.loose}};
}

void append_area_legend(std::string& svg, const std::vector<Area>& areas,
                        const core::SplitLayer& layer, const Frame& frame) {
  const double x = frame.left(0);
  double y = frame.top(0) + frame.panel_height + kLegendRowPx * 1.4;
  for (const Area& area : areas) {
    if (area.region->empty()) continue;
    append_legend_row(svg, x, y, *area.colours,
                      fmt::format("{}: {:.1f} mm²", area.words, area.region->area_mm2()));
    y += kLegendRowPx;
  }
  const double whole = std::max(1e-9, layer.slice.region.area_mm2());
  const double solid = layer.solid.area_mm2(), loose = layer.loose.area_mm2();
  append_text(svg, x, y,
              fmt::format("wall {:.1f} mm² ({:.0f} %), inside {:.1f} mm² ({:.0f} %)", solid,
                          100 * solid / whole, loose, 100 * loose / whole));
  append_scale_bar(svg, x, y + kLegendRowPx, frame.px_per_mm, frame.panel_width / 3);
}

void append_road_legend(std::string& svg, const Stretches& roads, const Frame& frame) {
  double y = frame.top(1) + frame.panel_height + kLegendRowPx * 1.4;
  for (const KindStyle& style : kKindStyles) {
    std::int64_t narrowest = INT64_MAX, widest = 0;
    double length = 0;
    for (const std::vector<core::WidthStretch>& road : roads) {
      for (const core::WidthStretch& stretch : road) {
        if (stretch.kind != style.kind) continue;
        narrowest = std::min(narrowest, stretch.width.units());
        widest = std::max(widest, stretch.width.units());
        length += core::length_mm(stretch.points, stretch.closed);
      }
    }
    if (widest == 0) continue;
    const std::string width =
        narrowest == widest ? fmt::format("{:.2f} mm", to_mm(widest))
                            : fmt::format("{:.2f} to {:.2f} mm", to_mm(narrowest), to_mm(widest));
    append_legend_row(svg, frame.left(1), y, style.colours,
                      fmt::format("{}, {} wide, {}", style.name, width,
                                  length < 1'000 ? fmt::format("{:.0f} mm", length)
                                                 : fmt::format("{:.2f} m", length / 1'000)));
    y += kLegendRowPx;
  }
}

}  // namespace

std::string layer_words(const core::Slice& slice, const std::string& what) {
  return fmt::format("layer {}, {:g} to {:g} mm above the bed; {}", slice.index + 1,
                     slice.bottom.mm(), slice.top().mm(), what);
}

std::string draw_layer(const LayerPicture& picture) {
  RIND_CHECK(picture.window != nullptr);
  RIND_CHECK(picture.roads != nullptr);
  const core::SplitLayer& layer = picture.window->layer();
  const core::Slice& slice = layer.slice;
  const core::Settings& settings = picture.window->settings();
  const core::WallRegions regions = core::wall_regions(*picture.window);
  const std::vector<Area> areas = areas_of(regions, layer, settings);
  const Stretches roads = stretches_of(picture);
  const Frame frame = frame_of(picture, roads);
  std::string svg;
  const Text out = std::back_inserter(svg);
  start_page(svg, frame.page_width(), frame.page_height());
  append_title(svg, picture.title, picture.subtitle);

  const double hairline = 1.2 / frame.px_per_mm;
  start_panel(out, frame, 0);
  for (const Area& area : areas) {
    // A stroke in its own colour, so that no gap shows between neighbours.
    append_region(out, *area.region,
                  fmt::format("fill=\"{0}\" stroke=\"{0}\" stroke-width=\"{1:.4g}\"",
                              area.colours->body, 0.3 * hairline));
  }
  append_region(out, layer.loose,
                fmt::format("fill=\"none\" stroke=\"#7fa3b0\" stroke-width=\"{:.4g}\"", hairline));
  append_region(out, slice.region,
                fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{:.4g}\" "
                            "stroke-linejoin=\"round\"",
                            kInkColour, 1.3 * hairline));
  svg += "</g>\n";

  start_panel(out, frame, 1);
  append_region(out, slice.region, "fill=\"#f1eee8\"");
  svg += "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  for (const std::vector<core::WidthStretch>& road : roads) append_road(out, road);
  svg += "</g></g>\n";

  append_area_legend(svg, areas, layer, frame);
  append_road_legend(svg, roads, frame);
  end_page(svg);
  return svg;
}

}  // namespace host
