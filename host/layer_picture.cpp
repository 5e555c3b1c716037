#include "host/layer_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/check.h"

namespace host {
namespace {

constexpr double kPanelPx = 640;  // longest side of a panel
constexpr double kMarginPx = 36;
constexpr double kTitlePx = 84;
constexpr double kLegendRowPx = 26;

constexpr const char* kWallColour = "#e9b872";
constexpr const char* kInsideColour = "#d9e7ec";

struct KindStyle {
  core::RoadKind kind;
  const char* name;
  const char* edge;  // the bead's shaded sides
  const char* body;
};

// In the order of the legend. Warm: dense; cool: loose.
constexpr std::array<KindStyle, 6> kStyles = {{
    {core::RoadKind::kOuterPerimeter, "outer perimeter", "#7d2a17", "#c8502f"},
    {core::RoadKind::kPerimeter, "perimeter", "#a3541f", "#e58a45"},
    {core::RoadKind::kSolid, "solid fill", "#b27d22", "#f0bd5c"},
    {core::RoadKind::kRest, "narrow rest", "#56306f", "#9a6bb8"},
    {core::RoadKind::kLoose, "loose fill", "#2c5d72", "#5f9bb3"},
    {core::RoadKind::kSkirt, "skirt", "#8d8d8d", "#bdbdbd"},
}};

const KindStyle& style_of(core::RoadKind kind) {
  const auto found = std::find_if(kStyles.begin(), kStyles.end(),
                                  [kind](const KindStyle& style) { return style.kind == kind; });
  RIND_CHECK(found != kStyles.end());
  return *found;
}

using Text = std::back_insert_iterator<std::string>;

// Where things lie on the page, in pixels; the part itself is drawn in mm and scaled.
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
    return kTitlePx + (stacked ? panel * (panel_height + 4.5 * kLegendRowPx) : 0);
  }
  [[nodiscard]] double page_width() const {
    return stacked ? panel_width + 2 * kMarginPx : 2 * panel_width + 3 * kMarginPx;
  }
  [[nodiscard]] double page_height() const {
    return top(1) + panel_height + std::max(4, legend_rows + 1) * kLegendRowPx + kMarginPx / 2;
  }
};

double to_mm(std::int64_t units) { return static_cast<double>(units) / core::kUnitsPerMm; }

Frame frame_of(const LayerPicture& picture) {
  Frame frame;
  core::Box box = picture.layer->layer.slice.region.box();
  std::int64_t width_most = 0;
  for (const core::Road& road : *picture.roads) {
    for (const core::Point point : road.points) box.add(point);
    width_most = std::max(width_most, road.width.units());
  }
  if (box.empty()) box = {{0, 0}, {100'000, 100'000}};
  const auto border = static_cast<std::int32_t>(width_most);
  frame.box = {{box.min.x - border, box.min.y - border}, {box.max.x + border, box.max.y + border}};

  const double width_mm = std::max(0.1, to_mm(std::int64_t{frame.box.max.x} - frame.box.min.x));
  const double height_mm = std::max(0.1, to_mm(std::int64_t{frame.box.max.y} - frame.box.min.y));
  frame.stacked = width_mm > 1.5 * height_mm;
  const double panel_px = frame.stacked ? 1.5 * kPanelPx : kPanelPx;
  frame.px_per_mm = panel_px / std::max(width_mm, height_mm);
  for (const KindStyle& style : kStyles) {
    const bool there = std::any_of(picture.roads->begin(), picture.roads->end(),
                                   [&](const core::Road& road) { return road.kind == style.kind; });
    frame.legend_rows += there ? 1 : 0;
  }
  frame.panel_width = std::max(320.0, width_mm * frame.px_per_mm);
  frame.panel_height = height_mm * frame.px_per_mm;
  return frame;
}

// The largest of 1, 2, 5, 10 … mm that takes at most a third of the panel.
double scale_bar_mm(const Frame& frame) {
  const double most = frame.panel_width / frame.px_per_mm / 3;
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0, 1.0}) {
    if (step * decade <= most) return step * decade;
  }
  return decade;
}

void append_points(Text out, const std::vector<core::Point>& points, bool closed) {
  char letter = 'M';
  for (const core::Point point : points) {
    fmt::format_to(out, "{}{:.6g} {:.6g}", letter, to_mm(point.x), to_mm(point.y));
    letter = 'L';
  }
  if (closed) fmt::format_to(out, "Z");
}

void append_region(Text out, const core::Region& region, const char* attributes) {
  if (region.empty()) return;
  fmt::format_to(out, "<path {} d=\"", attributes);
  for (const core::Ring& ring : region.rings()) append_points(out, ring, true);
  fmt::format_to(out, "\"/>\n");
}

// A bead: its shaded sides over the full width, then its lighter back.
void append_road(Text out, const core::Road& road) {
  const KindStyle& style = style_of(road.kind);
  std::string path;
  append_points(std::back_inserter(path), road.points, road.closed);
  fmt::format_to(out,
                 "<path d=\"{0}\" stroke=\"{1}\" stroke-width=\"{2:.4g}\"/>"
                 "<path d=\"{0}\" stroke=\"{3}\" stroke-width=\"{4:.4g}\"/>\n",
                 path, style.edge, road.width.mm(), style.body, road.width.mm() * 0.74);
}

void begin_panel(Text out, const Frame& frame, int panel) {
  // The part's y points up, the page's down.
  const double slack =
      frame.panel_width - to_mm(std::int64_t{frame.box.max.x} - frame.box.min.x) * frame.px_per_mm;
  fmt::format_to(
      out,
      "<g transform=\"translate({:.2f} {:.2f}) scale({:.6g} {:.6g}) translate({:.6g} {:.6g})\">\n",
      frame.left(panel) + slack / 2, frame.top(panel) + frame.panel_height, frame.px_per_mm,
      -frame.px_per_mm, -to_mm(frame.box.min.x), -to_mm(frame.box.min.y));
}

void append_row(Text out, double x, double y, const char* edge, const char* body,
                const std::string& text) {
  fmt::format_to(out,
                 "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"30\" height=\"13\" rx=\"6.5\" "
                 "fill=\"{}\" stroke=\"{}\" stroke-width=\"2\"/>"
                 "<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                 x + 1, y - 11, body, edge, x + 42, y, text);
}

void append_scale_bar(Text out, const Frame& frame, double y) {
  const double mm = scale_bar_mm(frame);
  const double x = frame.left(0) + 1;
  fmt::format_to(out,
                 "<path d=\"M{0:.1f} {1:.1f}v8v-4h{2:.1f}v4v-8\" fill=\"none\" stroke=\"#333\" "
                 "stroke-width=\"1.6\"/><text x=\"{3:.1f}\" y=\"{4:.1f}\">{5:g} mm</text>\n",
                 x, y - 9, mm * frame.px_per_mm, x + mm * frame.px_per_mm + 12, y, mm);
}

void append_region_legend(Text out, const LayerPicture& picture, const Frame& frame) {
  const core::SplitLayer& layer = *picture.layer;
  const double whole = std::max(1e-9, layer.layer.slice.region.area_mm2());
  const double solid = layer.solid.area_mm2(), loose = layer.loose.area_mm2();
  double y = frame.top(0) + frame.panel_height + kLegendRowPx * 1.4;
  append_row(
      out, frame.left(0), y, "#b98a45", kWallColour,
      fmt::format("wall, filled densely: {:.1f} mm² ({:.0f} %)", solid, 100 * solid / whole));
  y += kLegendRowPx;
  append_row(
      out, frame.left(0), y, "#9dbac4", kInsideColour,
      fmt::format("inside, filled loosely: {:.1f} mm² ({:.0f} %)", loose, 100 * loose / whole));
  append_scale_bar(out, frame, y + 1.5 * kLegendRowPx);
}

double length_mm(const core::Road& road) {
  double sum = 0;
  const std::size_t count = road.points.size();
  for (std::size_t i = 0; i + (road.closed ? 0 : 1) < count; ++i) {
    const core::Point a = road.points[i], b = road.points[(i + 1) % count];
    sum += std::hypot(to_mm(std::int64_t{a.x} - b.x), to_mm(std::int64_t{a.y} - b.y));
  }
  return sum;
}

void append_road_legend(Text out, const LayerPicture& picture, const Frame& frame) {
  double y = frame.top(1) + frame.panel_height + kLegendRowPx * 1.4;
  for (const KindStyle& style : kStyles) {
    std::int64_t narrowest = INT64_MAX, widest = 0;
    double length = 0;
    for (const core::Road& road : *picture.roads) {
      if (road.kind != style.kind) continue;
      narrowest = std::min(narrowest, road.width.units());
      widest = std::max(widest, road.width.units());
      length += length_mm(road);
    }
    if (widest == 0) continue;
    const std::string width =
        narrowest == widest ? fmt::format("{:.2f} mm", to_mm(widest))
                            : fmt::format("{:.2f} to {:.2f} mm", to_mm(narrowest), to_mm(widest));
    append_row(out, frame.left(1), y, style.edge, style.body,
               fmt::format("{}, {} wide, {}", style.name, width,
                           length < 1'000 ? fmt::format("{:.0f} mm", length)
                                          : fmt::format("{:.2f} m", length / 1'000)));
    y += kLegendRowPx;
  }
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
  }
  return out;
}

void append_title(Text out, const LayerPicture& picture, const Frame& frame) {
  const core::Slice& slice = picture.layer->layer.slice;
  fmt::format_to(
      out,
      "<text x=\"{0:.1f}\" y=\"42\" font-size=\"21\" font-weight=\"600\">{1}</text>"
      "<text x=\"{0:.1f}\" y=\"65\" fill=\"#666\">layer {2}, {3:g} to {4:g} mm above the "
      "bed</text>\n",
      frame.left(0), escaped(picture.title), slice.index + 1, slice.bottom.mm(), slice.top().mm());
}

}  // namespace

std::string draw_layer(const LayerPicture& picture) {
  RIND_CHECK(picture.layer != nullptr);
  RIND_CHECK(picture.roads != nullptr);
  const Frame frame = frame_of(picture);
  std::string svg;
  const Text out = std::back_inserter(svg);
  fmt::format_to(out,
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
                 "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"Inter, 'DejaVu Sans', Helvetica, "
                 "Arial, sans-serif\" font-size=\"14\" fill=\"#222\">\n"
                 "<rect width=\"100%\" height=\"100%\" fill=\"#fdfcfa\"/>\n",
                 frame.page_width(), frame.page_height());
  append_title(out, picture, frame);

  const double hairline = 1.2 / frame.px_per_mm;
  begin_panel(out, frame, 0);
  const core::SplitLayer& layer = *picture.layer;
  append_region(out, layer.loose, fmt::format("fill=\"{}\"", kInsideColour).c_str());
  append_region(out, layer.solid, fmt::format("fill=\"{}\"", kWallColour).c_str());
  append_region(
      out, layer.loose,
      fmt::format("fill=\"none\" stroke=\"#8fb0bb\" stroke-width=\"{:.4g}\"", hairline).c_str());
  append_region(out, layer.layer.slice.region,
                fmt::format("fill=\"none\" stroke=\"#4a3513\" stroke-width=\"{:.4g}\" "
                            "stroke-linejoin=\"round\"",
                            1.3 * hairline)
                    .c_str());
  fmt::format_to(out, "</g>\n");

  begin_panel(out, frame, 1);
  append_region(out, layer.layer.slice.region, "fill=\"#f1eee8\"");
  fmt::format_to(out, "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
  for (const core::Road& road : *picture.roads) append_road(out, road);
  fmt::format_to(out, "</g></g>\n");

  append_region_legend(out, picture, frame);
  append_road_legend(out, picture, frame);
  fmt::format_to(out, "</svg>\n");
  return svg;
}

}  // namespace host
