#include "host/formats/svg_path.h"

#include <optional>

#include "host/formats/number_text.h"   // parse_real
#include "host/formats/text_scanner.h"  // is_blank, shown

namespace host {
namespace {

bool is_gap(char c) { return is_blank(static_cast<unsigned char>(c)) || c == ','; }
bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

void skip_gap(std::string_view& text) {
  while (!text.empty() && is_gap(text.front())) text.remove_prefix(1);
}

// A number, up to a gap, the next command, or a sign that starts the next number.
std::optional<double> take_number(std::string_view& text) {
  skip_gap(text);
  std::size_t end = 0;
  for (; end < text.size() && !is_gap(text[end]); ++end) {
    const char c = text[end];
    const bool exponent = c == 'e' || c == 'E';
    if (is_letter(c) && !exponent) break;
    const bool sign = c == '-' || c == '+';
    if (sign && end > 0 && text[end - 1] != 'e' && text[end - 1] != 'E') break;
  }
  const std::optional<double> number = parse_real(text.substr(0, end));
  if (number) text.remove_prefix(end);
  return number;
}

std::string no_number(std::string_view text) {
  return "'" + shown(text) + "' where a coordinate should be; export the file again";
}

double model_y(double y, const SvgAxis& axis) { return axis.mirrored ? axis.height_mm - y : y; }

}  // namespace

std::string add_svg_points(std::string_view points, const SvgAxis& axis, Turn turn,
                           ContourGatherer& into) {
  if (std::string cause = into.start(); !cause.empty()) return cause;
  for (skip_gap(points); !points.empty(); skip_gap(points)) {
    const std::optional<double> x = take_number(points);
    const std::optional<double> y = x ? take_number(points) : std::nullopt;
    if (!y) return no_number(points);
    if (std::string cause = into.add(*x, model_y(*y, axis)); !cause.empty()) return cause;
  }
  into.end(turn);
  return {};
}

std::string add_svg_path(std::string_view data, const SvgAxis& axis, ContourGatherer& into) {
  double x = 0, y = 0, start_x = 0, start_y = 0;
  bool open = false, relative = false, may_move = false;
  for (skip_gap(data); !data.empty(); skip_gap(data)) {
    const char c = data.front();
    const bool moves = c == 'M' || c == 'm';
    if (moves || c == 'Z' || c == 'z') {
      if (open) into.end();
      open = false;
      if (!moves) x = start_x, y = start_y;
    }
    if (is_letter(c)) {
      if (!moves && c != 'Z' && c != 'z' && c != 'L' && c != 'l') {
        return std::string("path command '") + c + "' is no straight line; convert curves to lines";
      }
      data.remove_prefix(1);
      may_move = moves;
      if (c != 'Z' && c != 'z') relative = c == 'm' || c == 'l';
      continue;
    }
    const std::optional<double> dx = take_number(data);
    const std::optional<double> dy = dx ? take_number(data) : std::nullopt;
    if (!dy) return no_number(data);
    x = relative ? x + *dx : *dx;
    y = relative ? y + *dy : *dy;
    std::string cause = open ? std::string() : into.start();
    if (!open && may_move) start_x = x, start_y = y;
    open = true;
    if (cause.empty()) cause = into.add(x, model_y(y, axis));
    if (!cause.empty()) return cause;
  }
  if (open) into.end();
  return {};
}

}  // namespace host
