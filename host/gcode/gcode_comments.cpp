#include "host/gcode/gcode_comments.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <string>

#include "host/gcode/gcode_numbers.h"
#include "host/system/text.h"  // is_digit

namespace host {
namespace {

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

}  // namespace

bool starts_layer(std::string_view comment) {
  const std::string_view text = without_blanks(comment);
  if (text.starts_with("LAYER_CHANGE") || text.starts_with("CHANGE_LAYER")) return true;
  for (const std::string_view word : {"LAYER:", "layer "}) {
    if (text.starts_with(word) && text.size() > word.size() && is_digit(text[word.size()])) {
      return true;
    }
  }
  return false;
}

std::optional<double> seconds_in(std::string_view text) {
  double seconds = 0;
  bool any = false;
  std::size_t at = 0;
  while (at < text.size() && !is_digit(text[at])) ++at;
  while (at < text.size()) {
    const std::string rest(text.substr(at));
    char* end = nullptr;
    const double number = std::strtod(rest.c_str(), &end);
    at += static_cast<std::size_t>(end - rest.c_str());
    while (at < text.size() && text[at] == ' ') ++at;
    const char unit = at < text.size() ? text[at] : 's';
    const double factor = unit == 'd' ? 86'400 : unit == 'h' ? 3'600 : unit == 'm' ? 60 : 1;
    seconds += number * factor;
    any = true;
    while (at < text.size() && !is_digit(text[at])) ++at;
  }
  if (!any || !(seconds < 1e9)) return std::nullopt;
  return seconds;
}

std::optional<double> printing_time_in(std::string_view comment) {
  const std::string_view text = without_blanks(comment);
  constexpr std::array<std::string_view, 3> kWords = {"estimated printing time (normal mode)",
                                                      "estimated printing time", "TIME:"};
  for (const std::string_view word : kWords) {
    if (text.starts_with(word)) return seconds_in(text.substr(word.size()));
  }
  constexpr std::string_view kTotal = "total estimated time:";
  if (const std::size_t at = text.find(kTotal); at != std::string_view::npos) {
    return seconds_in(text.substr(at + kTotal.size()));
  }
  return std::nullopt;
}

std::optional<double> time_left_in(std::string_view line) {
  if (!line.starts_with("M73 ")) return std::nullopt;
  const std::optional<std::int64_t> minutes = GcodeNumbers(line.substr(4)).whole('R');
  if (!minutes || *minutes < 0 || *minutes > 1'000'000) return std::nullopt;
  return 60.0 * static_cast<double>(*minutes);
}

}  // namespace host
