#include "core/motions/height_actions.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "core/check.h"         // RIND_CHECK
#include "core/decimal_text.h"  // read_decimal, take_word

namespace core {
namespace {

constexpr const char* kExpected =
    "expected a height in mm, then pause, gcode LINE, a command such as M600, or a setting and its "
    "value: nozzle_celsius, retraction_mm, retraction_speed_mm_s, volumetric_speed_max_mm3_s, "
    "extrusion_multiplier, pressure_advance_s";

constexpr std::array kHeightSettings = {
    HeightSetting{"nozzle_celsius", &Settings::nozzle_celsius, 1, 500, true},
    HeightSetting{"retraction_mm", &Settings::retraction_mm, 3, 100, true},
    HeightSetting{"retraction_speed_mm_s", &Settings::retraction_speed_mm_s, 2, 500, false},
    HeightSetting{"volumetric_speed_max_mm3_s", &Settings::volumetric_speed_max_mm3_s, 3, 10'000,
                  false},
    HeightSetting{"extrusion_multiplier", &Settings::extrusion_multiplier, 4, 10, false},
    HeightSetting{"pressure_advance_s", &Settings::pressure_advance_s, 5, 10, true},
};

constexpr int kHeightDecimals = 4;  // units
constexpr std::int64_t kHeightUnitsMax = std::int64_t{1'000'000} * std::int64_t{10'000};

Error bad(std::string message) { return {ErrorCode::kBadSetting, std::move(message)}; }

std::int64_t power_of_ten(int exponent) {
  std::int64_t power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

std::optional<double> value_of(const HeightSetting& setting, std::string_view text) {
  const std::int64_t scale = power_of_ten(setting.decimals);
  const auto largest = static_cast<std::int64_t>(setting.largest) * scale;
  const std::optional<std::int64_t> units = read_decimal(text, setting.decimals, largest);
  if (!units || (*units == 0 && !setting.may_be_zero)) return std::nullopt;
  return static_cast<double>(*units) / static_cast<double>(scale);
}

// "nozzle_celsius from 0 to 500, with 1 decimal".
std::string range_of(const HeightSetting& setting) {
  return std::string(setting.key) + (setting.may_be_zero ? " from 0 to " : " above 0, up to ") +
         std::to_string(static_cast<std::int64_t>(setting.largest)) + ", with " +
         std::to_string(setting.decimals) + (setting.decimals == 1 ? " decimal" : " decimals");
}

}  // namespace

std::span<const HeightSetting> height_settings() { return kHeightSettings; }

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
  for (const HeightSetting& setting : kHeightSettings) {
    if (word != setting.key) continue;
    const std::optional<double> value = value_of(setting, rest);
    if (!value) return bad("\"" + std::string(rest) + "\" is no " + range_of(setting));
    action.kind = HeightAction::Kind::kValue;
    action.setting = &setting;
    action.value = *value;
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

void HeightActions::apply(std::size_t done, Settings& settings) const {
  RIND_CHECK(done <= actions_.size());
  for (const HeightAction& action : std::span(actions_.data(), done)) {
    if (action.setting != nullptr) settings.*action.setting->member = action.value;
  }
}

}  // namespace core
