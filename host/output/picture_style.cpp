#include "host/output/picture_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/check.h"
#include "core/walls/wall_style.h"

namespace host {

const KindStyle& style_of(core::RoadKind kind) {
  const auto found = std::find_if(kKindStyles.begin(), kKindStyles.end(),
                                  [kind](const KindStyle& style) { return style.kind == kind; });
  RIND_CHECK(found != kKindStyles.end());
  return *found;
}

const Colours& further_colours(const core::Settings& settings) {
  return core::window_decides(settings) ? kFurtherColours : kOwnColours;
}

double to_mm(std::int64_t units) { return static_cast<double>(units) / core::kUnitsPerMm; }

std::string wall_words(const core::Settings& settings) {
  if (settings.spiral_vase) {
    return fmt::format("spiral vase: one road of {:g} mm over a floor of {:g} mm",
                       settings.road_width.mm(), settings.wall_thickness.mm());
  }
  if (settings.style == core::BuildStyle::kRegular) return "dense everywhere (style regular)";
  if (settings.style == core::BuildStyle::kFast) return "style fast";
  const bool ball = settings.wall_shape == core::WallShape::kBall;
  if (ball) return fmt::format("wall {:g} mm thick, by a ball", settings.wall_thickness.mm());
  return fmt::format("wall {:g} mm deep and {} layers high, by a cylinder",
                     settings.wall_thickness.mm(), core::wall_layers(settings));
}

std::string made_dense(const core::Settings& settings) {
  const std::string narrow = "too narrow to be filled loosely, made dense";
  return settings.loose_roof == core::LooseRoof::kOff
             ? narrow
             : "made dense to hold the roof, or " + narrow.substr(0, narrow.find(','));
}

RegionWords region_words(const core::Settings& settings) {
  const std::string depth = fmt::format("{:g} mm", settings.wall_thickness.mm());
  const std::string reach = settings.wall_shape == core::WallShape::kBall
                                ? depth
                                : fmt::format("{} layers", core::wall_layers(settings));
  RegionWords words;
  words.own = fmt::format("region 1: within {} of the slice's own edge", depth);
  words.uncovered = fmt::format("region 2: a slice within {} above or below leaves it bare", reach);
  words.neighbours = fmt::format("region 3: a slice within {} has its edge too near", reach);
  words.loose = settings.spiral_vase ? "hollow" : "inside, filled loosely";
  words.further = settings.spiral_vase                            ? "one road, and the floor"
                  : settings.style == core::BuildStyle::kThinWall ? made_dense(settings)
                                                                  : "filled densely";
  return words;
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

void start_page(std::string& svg, double width, double height, double shown_height_max) {
  const double shown = std::min(1.0, shown_height_max / height);
  fmt::format_to(std::back_inserter(svg),
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{2:.0f}\" height=\"{3:.0f}\" "
                 "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"Inter, 'DejaVu Sans', Helvetica, "
                 "Arial, sans-serif\" font-size=\"14\" fill=\"#222\">\n"
                 "<rect width=\"100%\" height=\"100%\" fill=\"#fdfcfa\"/>\n",
                 width, height, std::max(1.0, width * shown), height * shown);
}

void end_page(std::string& svg) { svg += "</svg>\n"; }

void append_title(std::string& svg, const std::string& title, const std::string& subtitle) {
  fmt::format_to(std::back_inserter(svg),
                 "<text x=\"{0:.1f}\" y=\"42\" font-size=\"21\" font-weight=\"600\">{1}</text>"
                 "<text x=\"{0:.1f}\" y=\"65\" fill=\"#666\">{2}</text>\n",
                 kMarginPx, escaped(title), escaped(subtitle));
}

void append_text(std::string& svg, double x, double y, const std::string& text) {
  fmt::format_to(std::back_inserter(svg), "<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x, y,
                 escaped(text));
}

void append_legend_row(std::string& svg, double x, double y, const Colours& colours,
                       const std::string& text) {
  fmt::format_to(std::back_inserter(svg),
                 "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"30\" height=\"13\" rx=\"6.5\" "
                 "fill=\"{}\" stroke=\"{}\" stroke-width=\"2\"/>",
                 x + 1, y - 11, colours.body, colours.edge);
  append_text(svg, x + 42, y, text);
}

double scale_bar_mm(double px_per_mm, double most_px) {
  const double most = most_px / px_per_mm;
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0, 1.0}) {
    if (step * decade <= most) return step * decade;
  }
  return decade;
}

void append_scale_bar(std::string& svg, double x, double y, double px_per_mm, double most_px) {
  const double mm = scale_bar_mm(px_per_mm, most_px);
  fmt::format_to(std::back_inserter(svg),
                 "<path d=\"M{0:.1f} {1:.1f}v8v-4h{2:.1f}v4v-8\" fill=\"none\" stroke=\"#333\" "
                 "stroke-width=\"1.6\"/>",
                 x + 1, y - 9, mm * px_per_mm);
  append_text(svg, x + mm * px_per_mm + 13, y, fmt::format("{:g} mm", mm));
}

}  // namespace host
