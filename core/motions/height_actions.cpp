#include "core/motions/height_actions.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/check.h"         // RIND_CHECK
#include "core/decimal_text.h"  // read_decimal, take_word

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

}  // namespace

Result<HeightAction> read_height_action(std::string_view text) {
  const std::string_view height = take_word(text);
  const std::optional<std::int64_t> units = read_decimal(height, kHeightDecimals, kHeightUnitsMax);
  if (!units || *units <= 0) {
    return bad("\"" + std::string(height) + "\" is no height above 0: " + kExpected);
  }
  HeightAction action;
  action.height = Length::from_units(*units);
  std::string_view rest = text;
  const std::string_view word = take_word(rest);
  if (word == "pause" && rest.empty()) return action;
  if (word == "nozzle_celsius") {
    const std::optional<std::int64_t> tenths =
        read_decimal(rest, kCelsiusDecimals, kCelsiusTenthsMax);
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
