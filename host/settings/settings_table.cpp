#include "host/settings/settings_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

#include "core/check.h"
#include "core/limits.h"
#include "core/units.h"
#include "host/settings/setting_names.h"
#include "host/settings/settings_prusa.h"
#include "host/settings/settings_rows.h"
#include "host/settings/settings_text.h"

namespace host {
namespace {

using core::Length;
using core::Settings;
using core::Status;
using Lines = SettingLines;

using S = Settings;

// Names of an enumeration's values, in its order.
constexpr std::array<std::string_view, 2> names_of(core::WallShape) { return {"ball", "cylinder"}; }
constexpr std::array<std::string_view, 3> names_of(core::BuildStyle) {
  return {"thin-wall", "regular", "fast"};
}
constexpr std::array<std::string_view, 3> names_of(core::ArcUse) { return {"auto", "on", "off"}; }
constexpr std::array<std::string_view, 2> names_of(core::PackUse) { return {"auto", "off"}; }

template <typename... Readers>
struct Overloaded : Readers... {
  using Readers::operator()...;
};
// clang 14 does not deduce aggregates.
template <typename... Readers>
Overloaded(Readers...) -> Overloaded<Readers...>;

core::Error bad(std::string message) { return {core::ErrorCode::kBadSetting, std::move(message)}; }

const Setting* find(std::string_view key) {
  const auto* found = std::find_if(kSettings.begin(), kSettings.end(),
                                   [&](const Setting& setting) { return setting.key == key; });
  return found == kSettings.end() ? nullptr : found;
}

std::string range_text(const Setting& setting) {
  if (std::holds_alternative<core::WallShape S::*>(setting.member)) {
    return fmt::format("{}", fmt::join(names_of(core::WallShape{}), ", "));
  }
  if (std::holds_alternative<core::BuildStyle S::*>(setting.member)) {
    return fmt::format("{}", fmt::join(names_of(core::BuildStyle{}), ", "));
  }
  if (std::holds_alternative<core::ArcUse S::*>(setting.member)) {
    return fmt::format("{}", fmt::join(names_of(core::ArcUse{}), ", "));
  }
  if (std::holds_alternative<core::PackUse S::*>(setting.member)) {
    return fmt::format("{}", fmt::join(names_of(core::PackUse{}), ", "));
  }
  if (std::holds_alternative<bool S::*>(setting.member)) return "0 or 1";
  if (std::holds_alternative<std::string S::*>(setting.member)) {
    return "commands with commas between them";
  }
  if (std::holds_alternative<Lines S::*>(setting.member)) {
    return fmt::format("up to {} lines of {} bytes", kVerbatimLinesMax, kVerbatimBytesMax);
  }
  if (setting.unit == "%") return "0 … 1 (or 0% … 100%)";
  const std::string_view space = setting.unit.empty() ? "" : " ";
  return fmt::format("{} … {}{}{}", write_number(setting.min), write_number(setting.max), space,
                     setting.unit);
}

Status in_range(const Setting& setting, double value) {
  // Written so that NaN, which compares false, is out of range too.
  if (value >= setting.min && value <= setting.max) return {};
  if (setting.unit == "%" && value > 1 && value <= 100) {
    return bad(fmt::format("{0} = {1} is out of range: {2}; for {1} per cent write {1}%",
                           setting.key, write_number(value), range_text(setting)));
  }
  return bad(fmt::format("{} = {} is out of range: {}", setting.key, write_number(value),
                         range_text(setting)));
}

// `read` with the setting's name in front of an error and the range behind it.
core::Error explain(const Setting& setting, const core::Error& error) {
  return bad(fmt::format("{}: {}; expected {}", setting.key, error.message, range_text(setting)));
}

template <typename Enumeration>
Status choose(Enumeration& field, const Setting& setting, std::string_view text) {
  constexpr auto kNames = names_of(Enumeration{});
  const auto found = std::find(kNames.begin(), kNames.end(), trimmed(text));
  if (found == kNames.end()) {
    return bad(fmt::format("{}: \"{}\" is not one of: {}", setting.key, trimmed(text),
                           range_text(setting)));
  }
  field = static_cast<Enumeration>(found - kNames.begin());
  return {};
}

template <typename Enumeration>
std::string name_of(Enumeration value) {
  return std::string(names_of(value)[static_cast<std::size_t>(value)]);
}

Status assign(Settings& settings, const Setting& setting, std::string_view text) {
  const auto assign_to = [&](auto& field, const auto& read) -> Status {
    if (!read.ok()) return explain(setting, read.error());
    Status checked = in_range(setting, static_cast<double>(read.value()));
    if (checked.ok()) field = static_cast<std::decay_t<decltype(field)>>(read.value());
    return checked;
  };
  return std::visit(
      Overloaded{[&](double S::*field) {
                   return assign_to(settings.*field, read_number(text, setting.unit));
                 },
                 [&](int S::*field) { return assign_to(settings.*field, read_whole_number(text)); },
                 [&](bool S::*field) { return assign_to(settings.*field, read_switch(text)); },
                 [&](Length S::*field) -> Status {
                   double mm = 0;
                   Status status = assign_to(mm, read_number(text, setting.unit));
                   if (status.ok()) settings.*field = Length::from_mm(mm);
                   return status;
                 },
                 [&](core::WallShape S::*field) { return choose(settings.*field, setting, text); },
                 [&](core::BuildStyle S::*field) { return choose(settings.*field, setting, text); },
                 [&](core::ArcUse S::*field) { return choose(settings.*field, setting, text); },
                 [&](core::PackUse S::*field) { return choose(settings.*field, setting, text); },
                 [&](std::string S::*field) -> Status {
                   const std::string_view words = trimmed(text);
                   if (!is_printable(words) || words.size() > kWordsBytesMax) {
                     return bad(fmt::format("{}: expected {}, at most {} bytes", setting.key,
                                            range_text(setting), kWordsBytesMax));
                   }
                   settings.*field = words;
                   return {};
                 },
                 [&](Lines S::*field) -> Status {
                   core::Result<Lines> lines = read_lines(text);
                   if (!lines.ok()) return explain(setting, lines.error());
                   settings.*field = std::move(lines).value();
                   return {};
                 }},
      setting.member);
}

std::string value_text(const Settings& settings, const Setting& setting) {
  return std::visit(Overloaded{[&](double S::*f) { return write_number(settings.*f); },
                               [&](int S::*f) { return write_number(settings.*f); },
                               [&](bool S::*f) { return std::string(settings.*f ? "1" : "0"); },
                               [&](Length S::*f) { return write_number((settings.*f).mm()); },
                               [&](core::WallShape S::*f) { return name_of(settings.*f); },
                               [&](core::BuildStyle S::*f) { return name_of(settings.*f); },
                               [&](core::ArcUse S::*f) { return name_of(settings.*f); },
                               [&](core::PackUse S::*f) { return name_of(settings.*f); },
                               [&](std::string S::*f) { return settings.*f; },
                               [&](Lines S::*f) { return write_lines(settings.*f); }},
                    setting.member);
}

}  // namespace

Status set_setting(Settings& settings, std::string_view key, std::string_view text) {
  std::string name(trimmed(key));
  std::replace(name.begin(), name.end(), '-', '_');
  if (const Setting* setting = find(name)) return assign(settings, *setting, text);
  const std::optional<std::vector<SettingText>> translated = from_prusa(name, text);
  if (!translated.has_value()) {
    return bad(unknown_setting(trimmed(key), name));
  }
  if (translated->empty()) {
    return bad(fmt::format("{} = {} is PrusaSlicer's and has no counterpart here", name, text));
  }
  Settings changed = settings;
  for (const SettingText& ours : *translated) {
    const Setting* setting = find(ours.key);
    RIND_CHECK(setting != nullptr);
    Status status = assign(changed, *setting, ours.text);
    // The user typed another name than the one that the error begins with.
    if (!status.ok() && ours.key != name) return bad(name + ": " + status.error().message);
    if (!status.ok()) return status;
  }
  settings = std::move(changed);
  return {};
}

std::vector<SettingRow> describe_settings(const Settings& settings) {
  const Settings defaults;
  std::vector<SettingRow> rows;
  rows.reserve(kSettings.size());
  for (const Setting& setting : kSettings) {
    rows.push_back({std::string(setting.key), value_text(settings, setting),
                    std::string(setting.unit == "%" ? "share" : setting.unit),
                    value_text(defaults, setting), range_text(setting), std::string(setting.help)});
  }
  return rows;
}

bool is_gcode_setting(std::string_view key) {
  const Setting* setting = find(key);
  return setting != nullptr && std::holds_alternative<Lines S::*>(setting->member);
}

}  // namespace host
