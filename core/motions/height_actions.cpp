#include "core/motions/height_actions.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/check.h"  // RIND_CHECK

namespace core {
namespace {

constexpr const char* kExpected =
    "expected a height in mm, then pause, nozzle_celsius NUMBER, gcode LINE or a command such as "
    "M600";

constexpr int kHeightDecimals = 4;   // units
constexpr int kCelsiusDecimals = 1;  // what is sent
constexpr std::int64_t kCelsiusTenthsMax = 5'000;
constexpr std::int64_t kHeightUnitsMax = std::int64_t{1'000'000} * std::int64_t{10'000};

Error bad(std::string message) { return {ErrorCode::kBadSetting, std::move(message)}; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// The text up to the first blank, which is taken off.
std::string_view take_word(std::string_view& text) {
  text = without_blanks(text);
  const auto* const end = std::find_if(text.begin(), text.end(), is_blank);
  const std::string_view word = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text = without_blanks(text.substr(word.size()));
  return word;
}

// "12.4" with two decimals: 1240. Nothing: no such number, or one above the largest.
std::optional<std::int64_t> decimal(std::string_view text, int decimals, std::int64_t largest) {
  std::int64_t value = 0;
  int behind_point = -1;  // digits behind the point; -1: it was not met
  bool any = false;
  for (const char c : text) {
    if (c == '.' && behind_point < 0) {
      behind_point = 0;
      continue;
    }
    if (!is_digit(c)) return std::nullopt;
    any = true;
    if (behind_point >= 0 && ++behind_point > decimals) {
      if (c != '0') return std::nullopt;
      continue;
    }
    value = value * 10 + (c - '0');
    if (value > largest) return std::nullopt;
  }
  for (int i = std::max(behind_point, 0); i < decimals; ++i) value *= 10;
  if (!any || value > largest) return std::nullopt;
  return value;
}

}  // namespace

Result<HeightAction> read_height_action(std::string_view text) {
  const std::string_view height = take_word(text);
  const std::optional<std::int64_t> units = decimal(height, kHeightDecimals, kHeightUnitsMax);
  if (!units || *units <= 0) {
    return bad("\"" + std::string(height) + "\" is no height above 0: " + kExpected);
  }
  HeightAction action;
  action.height = Length::from_units(*units);
  std::string_view rest = text;
  const std::string_view word = take_word(rest);
  if (word == "pause" && rest.empty()) return action;
  if (word == "nozzle_celsius") {
    const std::optional<std::int64_t> tenths = decimal(rest, kCelsiusDecimals, kCelsiusTenthsMax);
    if (!tenths) return bad("\"" + std::string(rest) + "\" is no temperature from 0 to 500");
    action.kind = HeightAction::Kind::kNozzleTemperature;
    action.celsius = static_cast<double>(*tenths) / 10;
    return action;
  }
  action.kind = HeightAction::Kind::kGcode;
  const bool is_command = !word.empty() && word.front() >= 'A' && word.front() <= 'Z';
  if ((word != "gcode" || rest.empty()) && !is_command) {
    return bad("\"" + std::string(text) + "\" is not known: " + kExpected);
  }
  action.line = word == "gcode" ? rest : text;
  return action;
}

std::vector<HeightAction> height_actions(const Settings& settings) {
  std::vector<HeightAction> actions;
  actions.reserve(settings.at_height.size());
  for (const std::string& line : settings.at_height) {
    Result<HeightAction> action = read_height_action(line);
    RIND_CHECK(action.ok());
    actions.push_back(std::move(action).value());
  }
  std::stable_sort(
      actions.begin(), actions.end(),
      [](const HeightAction& a, const HeightAction& b) { return a.height < b.height; });
  return actions;
}

std::span<const HeightAction> HeightActions::due(std::size_t done, Length bottom) const {
  RIND_CHECK(done <= actions_.size());
  std::size_t end = done;
  while (end < actions_.size() && actions_[end].height <= bottom) ++end;
  return {actions_.data() + done, end - done};
}

std::optional<double> HeightActions::nozzle_celsius(Length bottom) const {
  std::optional<double> celsius;
  for (const HeightAction& action : actions_) {
    if (action.height > bottom) break;
    if (action.kind == HeightAction::Kind::kNozzleTemperature) celsius = action.celsius;
  }
  return celsius;
}

}  // namespace core
