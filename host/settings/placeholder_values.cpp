#include "host/settings/placeholder_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>
#include <vector>

#include "core/slices/height_ranges.h"     // first_layer_height
#include "host/settings/foreign_names.h"   // prusa_name
#include "host/settings/settings_prusa.h"  // ours_for
#include "host/settings/settings_table.h"  // describe_settings
#include "host/settings/settings_text.h"   // read_number, unescaped_lines, write_number
#include "host/system/text.h"              // trimmed

namespace host {
namespace {

using core::Result;

template <std::size_t kCount>
bool is_one_of(std::string_view name, const std::array<std::string_view, kCount>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// PrusaSlicer's whole numbers, by their ends and by name: a division of these drops the rest.
bool is_whole(std::string_view name) {
  constexpr std::array<std::string_view, 13> kNames = {
      "perimeters",       "skirts",           "skirt_height",     "num_extruders",
      "initial_tool",     "initial_extruder", "current_extruder", "current_object_idx",
      "layer_num",        "extruder",         "threads",          "fan_below_layer_time",
      "total_toolchanges"};
  for (const std::string_view end :
       {"temperature", "_layers", "_fan_speed", "_layer", "_extruder", "_layer_time", "_count",
        "_temp", "_temp_initial_layer", "temperature_initial_layer", "_layer_number"}) {
    if (name.ends_with(end)) return true;
  }
  return is_one_of(name, kNames);
}

// Lists of texts, one for each extruder, between semicolons.
bool is_text_list(std::string_view name) {
  constexpr std::array<std::string_view, 4> kNames = {"extruder_colour", "start_filament_gcode",
                                                      "end_filament_gcode", "compatible_printers"};
  return name.starts_with("filament_") || is_one_of(name, kNames);
}

// The values of a list of texts, of which some are quoted.
std::vector<std::string> texts_of(std::string_view list) {
  std::vector<std::string> texts(1);
  bool quoted = false;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const char c = list[i];
    if (c == '\\' && quoted && i + 1 < list.size()) {
      texts.back() += c;
      texts.back() += list[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ';' && !quoted) {
      texts.emplace_back();
    } else {
      texts.back() += c;
    }
  }
  return texts;
}

std::string unescaped(std::string_view text) {
  std::string whole;
  for (const std::string& line : unescaped_lines(text)) {
    whole += (whole.empty() ? "" : "\n") + line;
  }
  return whole;
}

bool is_number(std::string_view text) {
  if (text.ends_with('%')) text.remove_suffix(1);
  return read_number(text, "").ok();
}

// The index-th of a profile's values, "215,210" or "PLA;PETG"; the first if there are fewer, as in
// PrusaSlicer.
Variable element(std::string_view name, std::string_view list, std::size_t index) {
  const std::string_view whole = trimmed(list);
  if (is_text_list(name) && whole.find_first_of(";\"") != std::string_view::npos) {
    const std::vector<std::string> texts = texts_of(whole);
    const std::string& one = texts[index < texts.size() ? index : 0];
    if (!is_number(trimmed(one))) return {unescaped(one), VariableKind::kText};
    return {std::string(trimmed(one)), VariableKind::kNumber};
  }
  std::vector<std::string_view> numbers;
  for (std::string_view rest = whole;;) {
    numbers.push_back(trimmed(rest.substr(0, rest.find(','))));
    if (!is_number(numbers.back())) return {unescaped(whole), VariableKind::kText};
    if (numbers.back().size() >= rest.size() || rest.find(',') == std::string_view::npos) break;
    rest.remove_prefix(rest.find(',') + 1);
  }
  return {std::string(numbers[index < numbers.size() ? index : 0]),
          is_whole(name) ? VariableKind::kWhole : VariableKind::kNumber};
}

Variable number(double value) { return {write_number(value), VariableKind::kNumber}; }

std::optional<Variable> one_of_two(std::size_t index, double x, double y) {
  if (index > 1) return std::nullopt;
  return number(index == 0 ? x : y);
}

constexpr std::array<std::string_view, 4> kOfLayers = {"layer_num", "layer_z", "max_layer_z",
                                                       "total_layer_count"};
constexpr std::array<std::string_view, 3> kOfPlace = {
    "first_layer_print_min", "first_layer_print_max", "first_layer_print_size"};
constexpr std::array<std::string_view, 2> kOfName = {"input_filename", "input_filename_base"};

}  // namespace

std::optional<Variable> profile_value(const ProfileValues& profile, std::string_view name,
                                      std::size_t index) {
  if (const auto said = profile.find(name); said != profile.end()) {
    return element(name, said->second, index);
  }
  if (name != "num_extruders") return std::nullopt;
  const auto nozzles = profile.find("nozzle_diameter");
  if (nozzles == profile.end()) return Variable{"1", VariableKind::kWhole};
  const auto commas = std::count(nozzles->second.begin(), nozzles->second.end(), ',');
  return Variable{std::to_string(commas + 1), VariableKind::kWhole};
}

PlaceholderValues::PlaceholderValues(const PrintSettings& settings, const ProfileValues& profile,
                                     const PartFacts* part)
    : settings_(settings), profile_(profile), part_(part) {
  // A name that nobody has given stands for nothing.
  for (const SettingRow& row : describe_settings(settings)) {
    if (row.type != "text" || !row.plain_value.empty()) rows_[row.key] = row.plain_value;
  }
  // As they are used, where the settings say "auto".
  rows_["first_layer_height"] = write_number(core::first_layer_height(settings).mm());
  rows_["bed_first_layer_celsius"] = write_number(core::bed_first_layer_celsius(settings));
}

Result<std::optional<Variable>> PlaceholderValues::find(std::string_view name,
                                                        std::size_t index) const {
  // G-code may hold placeholders itself.
  if (is_gcode_setting(name)) return std::optional<Variable>();
  if (const std::string_view theirs = prusa_name(name); theirs != name) {
    Result<std::optional<Variable>> known = find(theirs, index);
    if (!known.ok() || known.value()) return known;
  }
  if (index == 0 && name != "bed_shape") {
    if (const auto row = rows_.find(ours_for(name).value_or(name)); row != rows_.end()) {
      const bool numeric = is_number(row->second);
      return std::optional(Variable{row->second, !numeric         ? VariableKind::kText
                                                 : is_whole(name) ? VariableKind::kWhole
                                                                  : VariableKind::kNumber});
    }
  }
  if (std::optional<Variable> said = profile_value(profile_, name, index)) return said;
  if (std::optional<Variable> known = of_print(name, index)) return known;
  const bool layers = is_one_of(name, kOfLayers), place = is_one_of(name, kOfPlace);
  if (!layers && !place && !is_one_of(name, kOfName)) return std::optional<Variable>();
  if (part_ == nullptr) {
    lacked_part_ = true;
    return core::Error{core::ErrorCode::kBadSetting, fmt::format("{} is a part's", name)};
  }
  if ((layers && part_->layers == 0) || (place && part_->box.empty())) {
    return core::Error{core::ErrorCode::kBadSetting,
                       fmt::format("{} is not known of a part that is read as it arrives; give it "
                                   "as a file",
                                   name)};
  }
  return of_part(name, index);
}

std::optional<Variable> PlaceholderValues::of_print(std::string_view name,
                                                    std::size_t index) const {
  const double x = settings_.bed_origin_x.mm(), y = settings_.bed_origin_y.mm();
  const double width = settings_.bed_x.mm(), depth = settings_.bed_y.mm();
  if (name == "print_bed_min") return one_of_two(index, x, y);
  if (name == "print_bed_max") return one_of_two(index, x + width, y + depth);
  if (name == "print_bed_size") return one_of_two(index, width, depth);
  if (name == "is_extruder_used") return Variable{index == 0 ? "1" : "0", VariableKind::kWhole};
  if (index > 0) return std::nullopt;
  if (name == "num_extruders" || name == "num_printing_extruders") {
    return Variable{"1", VariableKind::kWhole};
  }
  constexpr std::array<std::string_view, 9> kNone = {
      "initial_tool",       "initial_extruder", "initial_no_support_extruder",
      "current_extruder",   "extruder",         "total_toolchanges",
      "current_object_idx", "has_wipe_tower",   "has_single_extruder_multi_material_priming"};
  if (is_one_of(name, kNone)) return Variable{"0", VariableKind::kWhole};
  // What PrusaSlicer has where a profile does not say it.
  if (name == "z_offset") return Variable{"0", VariableKind::kNumber};
  if (name == "max_print_height") return Variable{"200", VariableKind::kNumber};
  return std::nullopt;
}

std::optional<Variable> PlaceholderValues::of_part(std::string_view name, std::size_t index) const {
  const auto mm = [](std::int64_t units) { return core::Length::from_units(units).mm(); };
  const core::Box& box = part_->box;
  const double x = settings_.bed_origin_x.mm(), y = settings_.bed_origin_y.mm();
  if (name == "first_layer_print_min")
    return one_of_two(index, x + mm(box.min.x), y + mm(box.min.y));
  if (name == "first_layer_print_max")
    return one_of_two(index, x + mm(box.max.x), y + mm(box.max.y));
  if (name == "first_layer_print_size") {
    return one_of_two(index, mm(std::int64_t{box.max.x} - box.min.x),
                      mm(std::int64_t{box.max.y} - box.min.y));
  }
  if (index > 0) return std::nullopt;
  if (name == "layer_num") return Variable{std::to_string(part_->layers - 1), VariableKind::kWhole};
  if (name == "total_layer_count") {
    return Variable{std::to_string(part_->layers), VariableKind::kWhole};
  }
  if (is_one_of(name, kOfName)) {
    // As in PrusaSlicer, the name is that of the G-code.
    std::string base = std::filesystem::path(part_->name).stem().string();
    if (name == "input_filename") base += ".gcode";
    return Variable{std::move(base), VariableKind::kText};
  }
  return number(part_->top.mm());
}

}  // namespace host
