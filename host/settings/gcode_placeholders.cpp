#include "host/settings/gcode_placeholders.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "host/settings/settings_text.h"  // trimmed

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_name(std::string_view text) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_';
  };
  return !text.empty() && !is_digit(text.front()) && std::all_of(text.begin(), text.end(), fits);
}

// "{8000}" is a number.
bool is_number(std::string_view text) {
  return !text.empty() && is_digit(text.front()) &&
         std::all_of(text.begin(), text.end(), [](char c) { return is_digit(c) || c == '.'; });
}

// Index into a list of values; rind prints with the first tool.
std::optional<std::size_t> index_of(std::string_view text) {
  text = trimmed(text);
  if (text == "initial_tool" || text == "initial_extruder" || text == "current_extruder") return 0;
  std::size_t index = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return index;
}

// A placeholder's name and index.
struct Asked {
  std::string_view name;
  std::size_t index = 0;
};

// "name", "name[0]", "name_[initial_tool]"; nullopt for anything else.
std::optional<Asked> plain(std::string_view content) {
  content = trimmed(content);
  const std::size_t bracket = content.find('[');
  if (bracket == std::string_view::npos) {
    if (!is_name(content)) return std::nullopt;
    return Asked{content};
  }
  if (!content.ends_with(']')) return std::nullopt;
  const auto index = index_of(content.substr(bracket + 1, content.size() - bracket - 2));
  std::string_view name = trimmed(content.substr(0, bracket));
  if (name.ends_with('_')) name.remove_suffix(1);
  if (!index || !is_name(name)) return std::nullopt;
  return Asked{name, *index};
}

std::optional<std::string> value_of(const Asked& asked, const PlaceholderValue& value) {
  if (std::optional<std::string> known = value(asked.name, asked.index)) return known;
  // "first_layer_temperature_0", as old profiles have it.
  const std::size_t underscore = asked.name.rfind('_');
  if (underscore == std::string_view::npos || asked.index != 0) return std::nullopt;
  const auto index = index_of(asked.name.substr(underscore + 1));
  return index ? value(asked.name.substr(0, underscore), *index) : std::nullopt;
}

// Position where the bracket or brace at `at` is closed; npos if it is not.
std::size_t closing(std::string_view line, std::size_t at) {
  const char open = line[at], close = open == '[' ? ']' : '}';
  int depth = 0;
  for (; at < line.size(); ++at) {
    if (line[at] == open) ++depth;
    if (line[at] == close && --depth == 0) return at;
  }
  return std::string_view::npos;
}

bool is_condition(std::string_view content) {
  constexpr std::array<std::string_view, 6> kWords = {"if",    "elsif", "else",
                                                      "endif", "local", "global"};
  content = trimmed(content);
  const auto* const end =
      std::find_if(content.begin(), content.end(), [](char c) { return c < 'a' || c > 'z'; });
  const std::string_view word = content.substr(0, static_cast<std::size_t>(end - content.begin()));
  const bool ends =
      word.size() == content.size() || content[word.size()] == ' ' || content[word.size()] == '(';
  return ends && std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

// PrusaSlicer evaluates conditions even in comments.
bool holds_condition(std::string_view text) {
  for (std::size_t at = text.find('{'); at != std::string_view::npos; at = text.find('{', at + 1)) {
    if (is_condition(text.substr(at + 1))) return true;
  }
  return false;
}

Error unfilled(std::string_view placeholder, std::string_view cause) {
  constexpr std::size_t kShown = 60;
  std::string shown(placeholder.substr(0, kShown));
  if (placeholder.size() > kShown) shown += "…";
  return {ErrorCode::kBadSetting, fmt::format("{} {}", shown, cause)};
}

Result<std::string> filled(std::string_view line, const PlaceholderValue& value,
                           GcodeOrigin origin) {
  std::string text;
  for (std::size_t at = 0; at < line.size();) {
    if (line[at] != '[' && line[at] != '{') {
      text += line[at++];
      continue;
    }
    const std::size_t end = closing(line, at);
    if (end == std::string_view::npos) return unfilled(line.substr(at), "is not closed");
    const std::string_view whole = line.substr(at, end + 1 - at);
    const std::string_view content = whole.substr(1, whole.size() - 2);
    const bool may_be_controllers = origin == GcodeOrigin::kOwn && whole.front() == '{';
    at = end + 1;
    if (const std::string_view number = trimmed(content); is_number(number)) {
      text += number;
      continue;
    }
    const std::optional<Asked> asked = plain(content);
    if (!asked || is_condition(content)) {
      if (!may_be_controllers || is_condition(content)) {
        return unfilled(whole, "is more than a name: rind fills in plain placeholders only");
      }
      text += whole;
      continue;
    }
    const std::optional<std::string> known = value_of(*asked, value);
    if (!known) return unfilled(whole, "stands for nothing that is known here");
    text += *known;
  }
  return text;
}

}  // namespace

Result<std::vector<std::string>> fill_placeholders(const std::vector<std::string>& lines,
                                                   const PlaceholderValue& value,
                                                   GcodeOrigin origin) {
  std::vector<std::string> result;
  for (const std::string& line : lines) {
    const std::string_view sent = trimmed(std::string_view(line).substr(0, line.find(';')));
    if (origin == GcodeOrigin::kProfile && holds_condition(line) && !holds_condition(sent)) {
      return unfilled(trimmed(line), "is a condition in a comment, which counts in PrusaSlicer");
    }
    if (sent.empty()) continue;
    Result<std::string> text = filled(sent, value, origin);
    if (!text.ok()) return text.error();
    result.push_back(std::move(text).value());
  }
  return result;
}

}  // namespace host
