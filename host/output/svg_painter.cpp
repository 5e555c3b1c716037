#include "host/output/svg_painter.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/check.h"                  // RIND_CHECK
#include "host/output/png_writer.h"      // png_of
#include "host/output/stroke_letters.h"  // text_lines
#include "host/output/stroke_outline.h"  // append_stroke

namespace host {
namespace {

constexpr double kLetterStroke = 0.085;  // of the font's size
constexpr double kBoldStroke = 0.125;

std::string_view text_in(const SvgTag& tag, std::string_view name) {
  const auto found = tag.attributes.find(name);
  return found == tag.attributes.end() ? std::string_view() : found->second;
}

double number_in(const SvgTag& tag, std::string_view name, double otherwise = 0) {
  std::string_view text = text_in(tag, name);
  return text.empty() ? otherwise : take_number(text);
}

// "none", "#fff", "#3a2c14".
std::optional<Paint> paint_of(std::string_view text) {
  if (text == "none") return std::nullopt;
  RIND_CHECK(text.front() == '#' && (text.size() == 4 || text.size() == 7));
  const std::size_t figures = (text.size() - 1) / 3;
  const auto part = [&](std::size_t i) {
    int value = 0;
    const char* begin = text.data() + 1 + i * figures;
    (void)std::from_chars(begin, begin + figures, value, 16);
    return static_cast<std::uint8_t>(figures == 1 ? 17 * value : value);
  };
  return Paint{part(0), part(1), part(2), 1};
}

SvgLine circle_of(const SvgTag& tag, double scale) {
  // As round as it will be painted.
  const Pixel middle{number_in(tag, "cx"), number_in(tag, "cy")};
  const double radius = number_in(tag, "r");
  SvgLine line{disk({0, 0}, radius * scale), true};
  for (Pixel& point : line.points) point = {middle.x + point.x / scale, middle.y + point.y / scale};
  return line;
}

// What a tag may have, besides its shape.
constexpr std::array<std::string_view, 24> kKnown = {
    "xmlns", "width",     "height",      "viewBox",     "font-family",    "font-size",
    "fill",  "x",         "y",           "rx",          "stroke",         "stroke-width",
    "d",     "transform", "text-anchor", "font-weight", "fill-opacity",   "cx",
    "cy",    "r",         "id",          "clip-path",   "stroke-linecap", "stroke-linejoin"};

}  // namespace

SvgPainter::SvgPainter() = default;

void SvgPainter::begin_page(const SvgTag& tag) {
  std::string_view box = text_in(tag, "viewBox");
  (void)take_number(box), (void)take_number(box);
  page_width_ = take_number(box);
  page_height_ = take_number(box);
  const double shown = number_in(tag, "width") / page_width_;
  const double most = std::sqrt(kPaintedPixelsMax / (page_width_ * page_height_));
  page_scale_ = std::min(shown, most);
  const auto pixels = [this](double side) {
    return std::max(1, static_cast<int>(std::floor(side * page_scale_ + 1e-6)));
  };
  canvas_.emplace(pixels(page_width_), pixels(page_height_));
  State state;
  state.scale_x = state.scale_y = page_scale_;
  states_.push_back(state);
}

Pixel SvgPainter::placed(Pixel point, const State& state) {
  return {state.move_x + state.scale_x * point.x, state.move_y + state.scale_y * point.y};
}

SvgPainter::State SvgPainter::state_in(const SvgTag& tag) const {
  State state = states_.back();
  for (const auto& [name, value] : tag.attributes) {
    RIND_CHECK(std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end());
    std::string_view text = value;
    if (name == "fill") state.fill = paint_of(value);
    if (name == "stroke") state.stroke = paint_of(value);
    if (name == "stroke-width") state.stroke_width = take_number(text);
    if (name == "stroke-linecap") state.round_ends = value == "round";
    if (name == "font-size") state.font_size = take_number(text);
    if (name == "font-weight") state.bold = true;
    if (name == "clip-path") state.clip = clip_;
  }
  if (state.fill) state.fill->opacity = number_in(tag, "fill-opacity", state.fill->opacity);
  std::string_view transform = text_in(tag, "transform");
  while (!transform.empty()) {
    const bool scales = transform.starts_with("scale(");
    RIND_CHECK(scales || transform.starts_with("translate("));
    transform.remove_prefix(transform.find('(') + 1);
    const double x = take_number(transform), y = take_number(transform);
    if (scales) state.scale_x *= x, state.scale_y *= y;
    if (!scales) state.move_x += state.scale_x * x, state.move_y += state.scale_y * y;
    transform.remove_prefix(transform.find(')') + 1);
    while (transform.starts_with(' ')) transform.remove_prefix(1);
  }
  return state;
}

std::vector<SvgLine> SvgPainter::rectangle(const SvgTag& tag) const {
  const auto side = [&](std::string_view name, double page) {
    return text_in(tag, name) == "100%" ? page : number_in(tag, name);
  };
  const double x = number_in(tag, "x"), y = number_in(tag, "y");
  const double right = x + side("width", page_width_), bottom = y + side("height", page_height_);
  return {{{{x, y}, {right, y}, {right, bottom}, {x, bottom}}, true}};
}

void SvgPainter::paint_lines(const std::vector<SvgLine>& lines, const State& state) {
  std::vector<PixelOutline> areas;
  for (const SvgLine& line : lines) {
    areas.emplace_back();
    for (const Pixel point : line.points) areas.back().push_back(placed(point, state));
  }
  if (state.fill) canvas_->fill(areas, *state.fill, state.clip);
  if (!state.stroke) return;
  const StrokeForm form{state.stroke_width * std::abs(state.scale_x), state.round_ends};
  std::vector<PixelOutline> strokes;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    append_stroke(areas[i], lines[i].closed, form, strokes);
  }
  canvas_->fill(strokes, *state.stroke, state.clip);
}

void SvgPainter::paint_text(const SvgTag& tag, const State& state) {
  const std::string text = unescaped(tag.text);
  const double wide = text_width(text, state.font_size);
  const std::string_view anchor = text_in(tag, "text-anchor");
  const double back = anchor == "end" ? wide : anchor == "middle" ? wide / 2 : 0;
  State letters = state;
  letters.stroke = state.fill;
  letters.fill.reset();
  letters.round_ends = true;
  letters.stroke_width = state.font_size * (state.bold ? kBoldStroke : kLetterStroke);
  std::vector<SvgLine> lines;
  for (std::vector<Pixel>& line :
       text_lines(text, {number_in(tag, "x") - back, number_in(tag, "y")}, state.font_size)) {
    lines.push_back({std::move(line), false});
  }
  paint_lines(lines, letters);
}

void SvgPainter::paint_tag(const SvgTag& tag) {
  const std::string_view name = tag.name;
  if (name == "/text") return;
  if (name == "/clipPath") {
    in_clip_ = false;
    return;
  }
  if (name == "/g" || name == "/svg") return states_.pop_back();
  const State state = state_in(tag);
  if (name == "svg" || name == "g") return states_.push_back(state);
  if (name == "clipPath") {
    in_clip_ = true;
    return;
  }
  if (name == "rect" && in_clip_) {
    const std::vector<SvgLine> lines = rectangle(tag);
    const Pixel from = placed(lines[0].points[0], state), to = placed(lines[0].points[2], state);
    clip_ = {from.x, from.y, to.x, to.y};
    return;
  }
  if (name == "text") return paint_text(tag, state);
  if (name == "rect") return paint_lines(rectangle(tag), state);
  if (name == "circle") return paint_lines({circle_of(tag, std::abs(state.scale_x))}, state);
  RIND_CHECK(name == "path");
  paint_lines(svg_lines(text_in(tag, "d")), state);
}

void SvgPainter::paint(std::string_view svg) {
  for (const SvgTag& tag : svg_tags(svg)) {
    if (!canvas_) {
      RIND_CHECK(tag.name == "svg");
      begin_page(tag);
    }
    paint_tag(tag);
  }
}

std::string SvgPainter::png() const {
  RIND_CHECK(canvas_.has_value());
  return png_of(canvas_->picture(), kPictureWords);
}

}  // namespace host
