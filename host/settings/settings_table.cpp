#include "host/settings/settings_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "core/check.h"
#include "core/limits.h"
#include "core/units.h"
#include "host/settings/bed_setting.h"
#include "host/settings/setting_names.h"
#include "host/settings/settings_prusa.h"
#include "host/settings/settings_rows.h"
#include "host/settings/settings_text.h"
#include "host/system/text.h"  // trimmed

namespace host {
namespace {

using core::Length;
using core::Status;
using Lines = SettingLines;

using S = PrintSettings;

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

// The names up to the first empty one.
std::span<const std::string_view> names_of(const Choice& choice) {
  const auto* end = std::find(choice.names.begin(), choice.names.end(), std::string_view());
  return {choice.names.begin(), end};
}

std::string number_range_text(const Setting& setting) {
  if (setting.unit == "%") {
    return fmt::format("{} … {} (or {}% … {}%)", write_number(setting.min),
                       write_number(setting.max), write_number(setting.min * 100),
                       write_number(setting.max * 100));
  }
  const std::string_view space = setting.unit.empty() ? "" : " ";
  std::string text = fmt::format("{} … {}{}{}", write_number(setting.min),
                                 write_number(setting.max), space, setting.unit);
  for (const NumberWord& word : setting.words) {
    if (!word.word.empty()) text += fmt::format(", {}", word.word);
  }
  return text;
}

std::string_view type_of(const Setting& setting) {
  return std::visit(
      Overloaded{[](Length S::*) { return "number"; }, [](double S::*) { return "number"; },
                 [](int S::*) { return "integer"; }, [](bool S::*) { return "switch"; },
                 [](std::string S::*) { return "text"; }, [](Lines S::*) { return "lines"; },
                 [](OverhangSteps S::*) { return "number"; },
                 [](BedCorners S::*) { return "corners"; }, [](const Choice&) { return "word"; }},
      setting.member);
}

// What a program needs to offer the setting.
void add_limits(const Setting& setting, SettingRow& row) {
  if (row.type == "number" || row.type == "integer") {
    row.min = setting.min;
    row.max = setting.max;
    for (const NumberWord& word : setting.words) {
      if (!word.word.empty()) row.words.emplace_back(word.word);
    }
  }
  if (const auto* choice = std::get_if<Choice>(&setting.member)) {
    const auto names = names_of(*choice);
    row.words.assign(names.begin(), names.end());
  }
}

std::string range_text(const Setting& setting) {
  if (const auto* choice = std::get_if<Choice>(&setting.member)) {
    return fmt::format("{}", fmt::join(names_of(*choice), ", "));
  }
  if (std::holds_alternative<bool S::*>(setting.member)) return "0 or 1";
  if (std::holds_alternative<std::string S::*>(setting.member)) {
    return fmt::format("up to {} bytes of text", kWordsBytesMax);
  }
  if (std::holds_alternative<OverhangSteps S::*>(setting.member)) {
    return fmt::format("{}; one number, or {} with commas between them", number_range_text(setting),
                       core::kOverhangSteps);
  }
  if (std::holds_alternative<BedCorners S::*>(setting.member)) {
    return fmt::format("rectangle, or 3 to {} corners as 0x0,250x0,250x210", core::kBedCornersMax);
  }
  if (std::holds_alternative<Lines S::*>(setting.member)) {
    return fmt::format("up to {:g} lines of {} bytes", setting.max, kVerbatimBytesMax);
  }
  return number_range_text(setting);
}

Status in_range(const Setting& setting, double value) {
  // Written so that NaN, which compares as false, is out of range, too.
  if ((value >= setting.min && value <= setting.max) || setting.word_for(value)) return {};
  if (setting.unit == "%" && value > 1 && value <= 100) {
    return bad(fmt::format("{0} = {1} is out of range: {2}; for {1} per cent write {1}%",
                           setting.key, write_number(value), range_text(setting)));
  }
  return bad(fmt::format("{} = {} is out of range: {}", setting.key, write_number(value),
                         range_text(setting)));
}

// The error with the setting's name before it and the range after it.
core::Error explain(const Setting& setting, const core::Error& error) {
  return bad(fmt::format("{}: {}; expected {}", setting.key, error.message, range_text(setting)));
}

Status choose(PrintSettings& settings, const Choice& choice, const Setting& setting,
              std::string_view text) {
  const std::span<const std::string_view> names = names_of(choice);
  const auto found = std::find(names.begin(), names.end(), trimmed(text));
  if (found == names.end()) {
    return bad(fmt::format("{}: \"{}\" is not one of: {}", setting.key, trimmed(text),
                           range_text(setting)));
  }
  choice.set(settings, static_cast<std::size_t>(found - names.begin()));
  return {};
}

enum class WordUse { kWords, kNumbers };

std::string number_text(const Setting& setting, double number, WordUse use) {
  const std::optional<std::string_view> word =
      use == WordUse::kWords ? setting.word_for(number) : std::nullopt;
  return word ? std::string(*word) : write_number(number);
}

// One number for all steps, or one for each.
Status assign_steps(OverhangSteps& steps, const Setting& setting, std::string_view text) {
  OverhangSteps read{};
  std::size_t count = 0;
  for (std::string_view rest = text; count < read.size(); ++count) {
    const std::size_t comma = rest.find(',');
    const core::Result<double> number = read_number(rest.substr(0, comma), setting.unit);
    if (!number.ok()) return explain(setting, number.error());
    if (Status fine = in_range(setting, number.value()); !fine.ok()) return fine;
    read[count] = number.value();
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  const auto commas = static_cast<std::size_t>(std::count(text.begin(), text.end(), ','));
  if (commas != 0 && commas + 1 != read.size()) {
    return bad(
        fmt::format("{} = {}: expected {}", setting.key, trimmed(text), range_text(setting)));
  }
  if (commas == 0) read.fill(read.front());
  steps = read;
  return {};
}

std::string steps_text(const OverhangSteps& steps) {
  const bool alike =
      std::all_of(steps.begin(), steps.end(), [&](double step) { return step == steps.front(); });
  if (alike) return write_number(steps.front());
  std::string text;
  for (const double step : steps) text += (text.empty() ? "" : ",") + write_number(step);
  return text;
}

Status assign(PrintSettings& settings, const Setting& setting, std::string_view text) {
  const std::optional<double> word = setting.number_of(trimmed(text));
  const auto assign_to = [&](auto& field, const auto& read) -> Status {
    using Field = std::decay_t<decltype(field)>;
    if (word) {
      field = static_cast<Field>(*word);
      return {};
    }
    if (!read.ok()) return explain(setting, read.error());
    Status checked = in_range(setting, static_cast<double>(read.value()));
    if (checked.ok()) field = static_cast<Field>(read.value());
    return checked;
  };
  return std::visit(
      Overloaded{
          [&](double S::*field) {
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
          [&](OverhangSteps S::*field) { return assign_steps(settings.*field, setting, text); },
          [&](const Choice& c) { return choose(settings, c, setting, text); },
          [&](BedCorners S::* /*field*/) -> Status {
            const core::Result<BedCorners> corners = read_bed_shape(text);
            if (!corners.ok()) return explain(setting, corners.error());
            set_bed_shape(settings, corners.value());
            return {};
          },
          [&](std::string S::*field) -> Status {
            const std::string_view words = trimmed(text);
            if (!is_printable(words) || words.size() > kWordsBytesMax) {
              return bad(fmt::format("{}: expected {}", setting.key, range_text(setting)));
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

std::string value_text(const PrintSettings& settings, const Setting& setting,
                       WordUse use = WordUse::kWords) {
  return std::visit(
      Overloaded{[&](double S::*f) { return number_text(setting, settings.*f, use); },
                 [&](int S::*f) { return number_text(setting, settings.*f, use); },
                 [&](bool S::*f) { return std::string(settings.*f ? "1" : "0"); },
                 [&](Length S::*f) { return number_text(setting, (settings.*f).mm(), use); },
                 [&](OverhangSteps S::*f) { return steps_text(settings.*f); },
                 [&](const Choice& c) { return std::string(c.names[c.get(settings)]); },
                 [&](BedCorners S::*f) { return write_bed_shape(settings.*f); },
                 [&](std::string S::*f) { return settings.*f; },
                 [&](Lines S::*f) { return write_lines(settings.*f); }},
      setting.member);
}

}  // namespace

std::optional<double> Setting::number_of(std::string_view word) const {
  for (const NumberWord& known : words) {
    if (!known.word.empty() && known.word == word) return known.number;
  }
  return std::nullopt;
}

std::optional<std::string_view> Setting::word_for(double number) const {
  for (const NumberWord& known : words) {
    if (!known.word.empty() && known.number == number) return known.word;
  }
  return std::nullopt;
}

Status set_setting(PrintSettings& settings, std::string_view key, std::string_view text) {
  std::string name(trimmed(key));
  std::replace(name.begin(), name.end(), '-', '_');
  if (const Setting* setting = find(name)) {
    const bool of_bed = name.starts_with("bed_") && !settings.bed_shape.empty();
    if (!of_bed) return assign(settings, *setting, text);
    const PrintSettings before = settings;
    Status status = assign(settings, *setting, text);
    if (status.ok()) follow_bed(name, before, settings);
    return status;
  }
  const std::optional<std::vector<SettingText>> translated = from_prusa(name, text);
  if (!translated.has_value()) {
    return bad(unknown_setting(trimmed(key), name));
  }
  if (translated->empty()) {
    return bad(fmt::format("{} = {} is PrusaSlicer's and has no counterpart here", name, text));
  }
  PrintSettings changed = settings;
  for (const SettingText& ours : *translated) {
    const Setting* setting = find(ours.key);
    RIND_CHECK(setting != nullptr);
    Status status = assign(changed, *setting, ours.text);
    // The error starts with our name, but the user typed another one.
    if (!status.ok() && ours.key != name) return bad(name + ": " + status.error().message);
    if (!status.ok()) return status;
  }
  settings = std::move(changed);
  return {};
}

std::vector<SettingRow> describe_settings(const PrintSettings& settings) {
  const PrintSettings defaults;
  std::vector<SettingRow> rows;
  rows.reserve(kSettings.size());
  for (const Setting& setting : kSettings) {
    rows.push_back({std::string(setting.key), value_text(settings, setting),
                    value_text(settings, setting, WordUse::kNumbers),
                    std::string(setting.unit == "%" ? "share" : setting.unit),
                    value_text(defaults, setting), range_text(setting), std::string(setting.help),
                    type_of(setting)});
    add_limits(setting, rows.back());
  }
  return rows;
}

std::vector<std::string> setting_words(std::string_view key) {
  const Setting* setting = find(key);
  const Choice* choice = setting == nullptr ? nullptr : std::get_if<Choice>(&setting->member);
  if (choice == nullptr) return {};
  const auto names = names_of(*choice);
  return {names.begin(), names.end()};
}

bool is_gcode_setting(std::string_view key) {
  const Setting* setting = find(key);
  return setting != nullptr && std::holds_alternative<Lines S::*>(setting->member);
}

}  // namespace host
