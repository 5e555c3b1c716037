#include "host/part/modifier_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "host/system/text.h"  // trimmed

namespace host {
namespace {

using core::LaidValue;
using core::Settings;

// As in the settings' table.
constexpr double kSpeedMin_mm_s = 0.1, kSpeedMax_mm_s = 2'000;
constexpr double kFlowMin = 0.1, kFlowMax = 3;

struct SpeedWord {
  std::string_view theirs;
  std::string_view ours;
  LaidValue value;
  double Settings::*of_part;    // null: an overhang's
  std::string_view share_of{};  // whose share it may be, in the same slicer
  bool may_be_zero = false;     // no difference
};

constexpr std::array kSpeeds = {
    SpeedWord{"perimeter_speed", "perimeters", LaidValue::kPerimeterSpeed,
              &Settings::perimeter_speed_mm_s},
    SpeedWord{"inner_wall_speed", "perimeters", LaidValue::kPerimeterSpeed,
              &Settings::perimeter_speed_mm_s},
    SpeedWord{"external_perimeter_speed", "outer perimeters", LaidValue::kOuterPerimeterSpeed,
              &Settings::outer_perimeter_speed_mm_s, "perimeter_speed"},
    SpeedWord{"outer_wall_speed", "outer perimeters", LaidValue::kOuterPerimeterSpeed,
              &Settings::outer_perimeter_speed_mm_s},
    SpeedWord{"small_perimeter_speed", "small perimeters", LaidValue::kSmallPerimeterSpeed,
              &Settings::small_perimeter_speed_mm_s, "perimeter_speed", true},
    SpeedWord{"infill_speed", "inside", LaidValue::kLooseSpeed, &Settings::loose_speed_mm_s},
    SpeedWord{"sparse_infill_speed", "inside", LaidValue::kLooseSpeed, &Settings::loose_speed_mm_s},
    SpeedWord{"solid_infill_speed", "solid", LaidValue::kSolidSpeed, &Settings::solid_speed_mm_s,
              "infill_speed"},
    SpeedWord{"internal_solid_infill_speed", "solid", LaidValue::kSolidSpeed,
              &Settings::solid_speed_mm_s},
    SpeedWord{"top_solid_infill_speed", "tops", LaidValue::kTopSpeed, &Settings::top_speed_mm_s,
              "solid_infill_speed"},
    SpeedWord{"top_surface_speed", "tops", LaidValue::kTopSpeed, &Settings::top_speed_mm_s},
    SpeedWord{"gap_fill_speed", "gaps", LaidValue::kRestSpeed, &Settings::rest_speed_mm_s},
    SpeedWord{"gap_infill_speed", "gaps", LaidValue::kRestSpeed, &Settings::rest_speed_mm_s},
    SpeedWord{"bridge_speed", "bridges", LaidValue::kBridgeSpeed, &Settings::bridge_speed_mm_s},
    SpeedWord{"internal_bridge_speed", "bridges over the inside", LaidValue::kInternalBridgeSpeed,
              &Settings::internal_bridge_speed_mm_s, "bridge_speed"},
    SpeedWord{"ironing_speed", "ironing", LaidValue::kIroningSpeed, &Settings::ironing_speed_mm_s},
    SpeedWord{"overhang_1_4_speed", "overhangs up to 1/4", LaidValue::kOverhangSpeed1, nullptr,
              "outer_wall_speed", true},
    SpeedWord{"overhang_2_4_speed", "overhangs up to 2/4", LaidValue::kOverhangSpeed2, nullptr,
              "outer_wall_speed", true},
    SpeedWord{"overhang_3_4_speed", "overhangs up to 3/4", LaidValue::kOverhangSpeed3, nullptr,
              "outer_wall_speed", true},
    SpeedWord{"overhang_4_4_speed", "overhangs up to 4/4", LaidValue::kOverhangSpeed4, nullptr,
              "outer_wall_speed", true},
};

struct FlowWord {
  std::string_view theirs;
  std::string_view ours;
  LaidValue value;
  double Settings::*of_part = nullptr;  // what the roads have already; null: 1
};

constexpr std::array kFlows = {
    FlowWord{"print_flow_ratio", "all roads", LaidValue::kFlow},
    FlowWord{"bridge_flow_ratio", "bridges", LaidValue::kBridgeFlow, &Settings::bridge_flow},
    FlowWord{"bridge_flow", "bridges", LaidValue::kBridgeFlow, &Settings::bridge_flow},
    FlowWord{"internal_bridge_flow", "bridges over the inside", LaidValue::kInternalBridgeFlow,
             &Settings::internal_bridge_flow},
    FlowWord{"top_solid_infill_flow_ratio", "tops", LaidValue::kTopFlow, &Settings::top_flow},
    FlowWord{"bottom_solid_infill_flow_ratio", "bottoms", LaidValue::kBottomFlow},
    FlowWord{"outer_wall_flow_ratio", "outer perimeters", LaidValue::kOuterPerimeterFlow},
    FlowWord{"inner_wall_flow_ratio", "perimeters", LaidValue::kPerimeterFlow},
    FlowWord{"overhang_flow_ratio", "overhangs", LaidValue::kOverhangFlow},
    FlowWord{"sparse_infill_flow_ratio", "inside", LaidValue::kLooseFlow},
    FlowWord{"internal_solid_infill_flow_ratio", "solid", LaidValue::kSolidFlow},
    FlowWord{"gap_fill_flow_ratio", "gaps", LaidValue::kGapFlow},
};

// OrcaSlicer shows some settings only where another one is on.
std::string_view switch_of(std::string_view key) {
  if (key.starts_with("overhang_") && key.ends_with("_speed")) return "enable_overhang_speed";
  const bool ungated = key == "print_flow_ratio" || key == "bridge_flow_ratio" ||
                       key == "top_solid_infill_flow_ratio" ||
                       key == "bottom_solid_infill_flow_ratio";
  return key.ends_with("_flow_ratio") && !ungated ? "set_other_flow_ratios" : "";
}

std::string_view value_of(const ModifierSettings& modifier, std::string_view key) {
  for (const auto& [name, value] : modifier) {
    if (name == key) return trimmed(value);
  }
  return {};
}

std::optional<double> number_in(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

const SpeedWord* speed_word(std::string_view key) {
  const auto* found = std::find_if(kSpeeds.begin(), kSpeeds.end(),
                                   [&](const SpeedWord& one) { return one.theirs == key; });
  return found == kSpeeds.end() ? nullptr : found;
}

double part_speed(const SpeedWord& word, const Settings& settings) {
  if (word.of_part != nullptr) return settings.*word.of_part;
  const auto first = static_cast<std::size_t>(LaidValue::kOverhangSpeed1);
  return settings.overhang_speed_mm_s[static_cast<std::size_t>(word.value) - first];
}

// Nothing where it is not usable.
std::optional<double> speed_in(const SpeedWord& word, const ModifierSettings& modifier,
                               const Settings& settings) {
  std::string_view text = value_of(modifier, word.theirs);
  const bool share = text.ends_with('%');
  if (share) text = trimmed(text.substr(0, text.size() - 1));
  std::optional<double> speed = number_in(text);
  if (!speed) return speed;
  if (share) {
    const SpeedWord* whole = speed_word(word.share_of);
    if (whole == nullptr) return std::nullopt;
    const bool said = !value_of(modifier, whole->theirs).empty();
    const std::optional<double> of =
        said ? speed_in(*whole, modifier, settings) : part_speed(*whole, settings);
    if (!of) return std::nullopt;
    *speed *= *of / 100;
  }
  if (word.may_be_zero && *speed == 0) return speed;
  if (!(*speed >= kSpeedMin_mm_s && *speed <= kSpeedMax_mm_s)) return std::nullopt;
  return speed;
}

}  // namespace

ValueUse read_laid_value(std::string_view key, const ModifierSettings& modifier,
                         const Settings& settings, core::AreaChange& change, std::string& words) {
  if (key == "set_other_flow_ratios" || key == "enable_overhang_speed") return ValueUse::kSilent;
  const std::string_view needs = switch_of(key);
  const bool counts = needs.empty() || value_of(modifier, needs) != "0";
  if (const SpeedWord* word = speed_word(key)) {
    const std::optional<double> speed = speed_in(*word, modifier, settings);
    if (!speed) return ValueUse::kNone;
    if (!counts) return ValueUse::kSilent;
    change.value(word->value) = *speed;
    words = fmt::format("{} at {:g} mm/s", word->ours, *speed);
    return ValueUse::kUsed;
  }
  const auto* flow = std::find_if(kFlows.begin(), kFlows.end(),
                                  [&](const FlowWord& one) { return one.theirs == key; });
  if (flow == kFlows.end()) return ValueUse::kNone;
  const std::optional<double> ratio = number_in(value_of(modifier, key));
  if (!ratio || !(*ratio >= kFlowMin && *ratio <= kFlowMax)) return ValueUse::kNone;
  if (!counts) return ValueUse::kSilent;
  change.value(flow->value) = flow->of_part != nullptr ? *ratio / settings.*flow->of_part : *ratio;
  words = fmt::format("flow of {} {:g}", flow->ours, *ratio);
  return ValueUse::kUsed;
}

void complete_laid_values(const Settings& settings, core::AreaChange& change) {
  const auto fill = [&](LaidValue which, double value) {
    if (!change.value(which)) change.value(which) = value;
  };
  if (const std::optional<double> speed = change.value(LaidValue::kBridgeSpeed)) {
    fill(LaidValue::kInternalBridgeSpeed, *speed);
    fill(LaidValue::kOverhangSpeed3, *speed);
    fill(LaidValue::kOverhangSpeed4, *speed);
  }
  if (const std::optional<double> flow = change.value(LaidValue::kBridgeFlow)) {
    fill(LaidValue::kInternalBridgeFlow,
         *flow * settings.bridge_flow / settings.internal_bridge_flow);
  }
}

core::LaidValues own_laid_values(const Settings& settings) {
  core::LaidValues values;
  values.fill(1);  // flows
  for (const SpeedWord& word : kSpeeds) {
    values[static_cast<std::size_t>(word.value)] = part_speed(word, settings);
  }
  return values;
}

}  // namespace host
