#include "host/settings/settings_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <variant>

#include "core/check.h"
#include "core/limits.h"
#include "core/units.h"
#include "host/settings/settings_prusa.h"
#include "host/settings/settings_text.h"

namespace host {
namespace {

using core::Length;
using core::Settings;
using core::Status;
using Lines = std::vector<std::string>;

// Which field, and with it how its values are written.
using Member =
    std::variant<Length Settings::*, double Settings::*, int Settings::*, bool Settings::*,
                 core::WallShape Settings::*, core::BuildStyle Settings::*,
                 core::ArcUse Settings::*, core::PackUse Settings::*, Lines Settings::*>;

struct Setting {
  std::string_view key;
  Member member;
  std::string_view unit;  // "%": a share, which may also be given in percent
  double min = 0;         // both ends belong to the range
  double max = 0;
  std::string_view help;
};

using S = Settings;

// Names of an enumeration's values, in its order.
constexpr std::array<std::string_view, 2> names_of(core::WallShape) { return {"ball", "cylinder"}; }
constexpr std::array<std::string_view, 3> names_of(core::BuildStyle) {
  return {"thin-wall", "regular", "fast"};
}
constexpr std::array<std::string_view, 3> names_of(core::ArcUse) { return {"auto", "on", "off"}; }
constexpr std::array<std::string_view, 2> names_of(core::PackUse) { return {"auto", "off"}; }

constexpr double kBedMaxMm = core::kCoordinateMax / core::kUnitsPerMm / 2;  // the part lies within

constexpr std::array kTable = {
    Setting{"layer_height", &S::layer_height, "mm", 0.01, 2, "height of every layer"},
    Setting{"wall_thickness", &S::wall_thickness, "mm", 0.05, 100,
            "how thick the dense wall is, sideways, up and down"},
    Setting{
        "wall_shape", &S::wall_shape, "", 0, 0,
        "inner side of the wall: ball, as thick on any slope; cylinder, one depth for all layers"},
    Setting{"wall_layers", &S::wall_layers, "", 0, 64,
            "layers a cylinder reaches up and down; 0: as many as the wall is thick"},
    Setting{"style", &S::style, "", 0, 0,
            "thin-wall; to compare with: regular, dense everywhere; fast, loose in hidden layers"},
    Setting{"loose_width_min", &S::loose_width_min, "mm", 0, 20,
            "narrower parts of the inside are made solid"},
    Setting{"loose_area_min_mm2", &S::loose_area_min_mm2, "mm²", 0, 10'000,
            "smaller islands of the inside are made solid"},
    Setting{"nozzle_diameter", &S::nozzle_diameter, "mm", 0.05, 5, "bore of the nozzle"},
    Setting{"filament_diameter", &S::filament_diameter, "mm", 0.5, 10, "of the filament as bought"},
    Setting{"road_width", &S::road_width, "mm", 0.05, 10, "of every road that fits whole"},
    Setting{"road_width_min", &S::road_width_min, "mm", 0.01, 10,
            "narrowest road for a rest; narrower rests are left out"},
    Setting{"perimeters", &S::perimeters, "", 0, 50, "closed roads along every contour"},
    Setting{"road_overlap", &S::road_overlap, "%", 0, 1,
            "of neighbouring roads; 1: the layer has no voids, 0: roads just touch"},
    Setting{"loose_density", &S::loose_density, "%", 0, 1,
            "share of the inside that is filled; 0: empty, 1: dense"},
    Setting{"fill_angle_degrees", &S::fill_angle_degrees, "°", -360, 360,
            "direction of fill on even layers; odd ones are turned by 90°"},
    Setting{"loose_anchor", &S::loose_anchor, "mm", 0, 20,
            "how far loose roads reach into the wall"},
    Setting{"skirt_loops", &S::skirt_loops, "", 0, 50, "loops around the first layer; 0: none"},
    Setting{"skirt_distance", &S::skirt_distance, "mm", 0, 200, "from the part to the skirt"},
    Setting{"simplify_tolerance", &S::simplify_tolerance, "mm", 0, 0.5,
            "how far a slice's contours may be moved to save points"},
    Setting{"arc_tolerance", &S::arc_tolerance, "mm", 0.0005, 0.5,
            "how far chords may stay off the arcs of an offset"},
    Setting{"chain_gap_max", &S::chain_gap_max, "mm", 0, 100,
            "gaps of a broken mesh up to this are closed, wider ones only where one way is left"},
    Setting{"arcs", &S::arcs, "", 0, 0,
            "round roads as G2, G3; auto: where the controller says that it draws them, in files"},
    Setting{"arc_fit_tolerance", &S::arc_fit_tolerance, "mm", 0, 0.5,
            "how far an arc may be off the road that it stands for; 0: no arcs"},
    Setting{
        "segment_time_min_ms", &S::segment_time_min_ms, "ms", 0, 1'000,
        "shorter segments are merged, else laid slower; 0: as the port's baud says, in files none; "
        "0.001: none anywhere"},
    Setting{"segment_tolerance", &S::segment_tolerance, "mm", 0, 0.5,
            "how far a merged segment may be off the road"},
    Setting{"meatpack", &S::meatpack, "", 0, 0,
            "auto: lines packed where the controller offers MeatPack; only on a port that loses "
            "nothing"},
    Setting{"wait_limit_s", &S::wait_limit_s, "s", 0, 604'800,
            "how long the controller may be silent over a command, at least; 0: by the command, "
            "from seconds to hours"},
    Setting{"perimeter_speed_mm_s", &S::perimeter_speed_mm_s, "mm/s", 0.1, 2'000,
            "inner perimeters"},
    Setting{"outer_perimeter_speed_mm_s", &S::outer_perimeter_speed_mm_s, "mm/s", 0.1, 2'000,
            "the part's visible surface"},
    Setting{"solid_speed_mm_s", &S::solid_speed_mm_s, "mm/s", 0.1, 2'000, "dense fill of the wall"},
    Setting{"loose_speed_mm_s", &S::loose_speed_mm_s, "mm/s", 0.1, 2'000, "fill of the inside"},
    Setting{"rest_speed_mm_s", &S::rest_speed_mm_s, "mm/s", 0.1, 2'000,
            "narrow rests with roads of their own width"},
    Setting{"first_layer_speed_mm_s", &S::first_layer_speed_mm_s, "mm/s", 0.1, 2'000,
            "fastest road of the first layer"},
    Setting{"travel_speed_mm_s", &S::travel_speed_mm_s, "mm/s", 0.1, 5'000, "without material"},
    Setting{"lift_speed_mm_s", &S::lift_speed_mm_s, "mm/s", 0.1, 1'000, "up and down"},
    Setting{"layer_time_min_s", &S::layer_time_min_s, "s", 0, 3'600,
            "layers that would be done sooner are slowed down"},
    Setting{"slowed_speed_min_mm_s", &S::slowed_speed_min_mm_s, "mm/s", 0.1, 2'000,
            "slowing down stops here"},
    Setting{"acceleration_mm_s2", &S::acceleration_mm_s2, "mm/s2", 1, 100'000,
            "the machine's, for the estimate of time only"},
    Setting{"filament_acceleration_mm_s2", &S::filament_acceleration_mm_s2, "mm/s2", 1, 100'000,
            "of retractions, for the estimate of time only"},
    Setting{"junction_deviation_mm", &S::junction_deviation_mm, "mm", 0, 1,
            "how fast corners are taken, for the estimate of time only"},
    Setting{"retraction_mm", &S::retraction_mm, "mm", 0, 100, "filament drawn back before travel"},
    Setting{"retraction_speed_mm_s", &S::retraction_speed_mm_s, "mm/s", 0.1, 500,
            "of the filament"},
    Setting{"retraction_travel_min", &S::retraction_travel_min, "mm", 0, 1'000,
            "shorter travel inside the part is without retraction"},
    Setting{"retraction_lift", &S::retraction_lift, "mm", 0, 50,
            "nozzle's height over the layer in travel with retraction"},
    Setting{"bed_x", &S::bed_x, "mm", 1, kBedMaxMm, "width of the bed"},
    Setting{"bed_y", &S::bed_y, "mm", 1, kBedMaxMm, "depth of the bed"},
    Setting{"axis_z", &S::axis_z, "mm", 0, 1e9, "highest the nozzle can go; 0: not limited"},
    Setting{"centre", &S::centre, "", 0, 1, "part in the middle of the bed; 0: at part_x, part_y"},
    Setting{"part_x", &S::part_x, "mm", 0, kBedMaxMm, "where the part's lowest x comes to lie"},
    Setting{"part_y", &S::part_y, "mm", 0, kBedMaxMm, "where the part's lowest y comes to lie"},
    Setting{"nozzle_celsius", &S::nozzle_celsius, "°C", 0, 500, "nozzle; 0: not heated"},
    Setting{"nozzle_first_layer_celsius", &S::nozzle_first_layer_celsius, "°C", 0, 500,
            "nozzle on the first layer; 0: not heated"},
    Setting{"bed_celsius", &S::bed_celsius, "°C", 0, 200, "bed; 0: not heated"},
    Setting{"fan_share", &S::fan_share, "%", 0, 1, "speed of the part's fan"},
    Setting{"fan_from_layer", &S::fan_from_layer, "", 1, 1e6,
            "first layer with the fan on, counted from 1"},
    Setting{"start_gcode", &S::start_gcode, "", 0, kVerbatimLinesMax,
            "lines sent first, \\n between them; ';' starts a comment"},
    Setting{"end_gcode", &S::end_gcode, "", 0, kVerbatimLinesMax, "lines sent last"},
    Setting{"park_lift", &S::park_lift, "mm", 0, 1'000,
            "nozzle goes up by this at the end and at a stop"},
};

template <typename... Readers>
struct Overloaded : Readers... {
  using Readers::operator()...;
};
// clang 14 does not deduce aggregates.
template <typename... Readers>
Overloaded(Readers...) -> Overloaded<Readers...>;

core::Error bad(std::string message) { return {core::ErrorCode::kBadSetting, std::move(message)}; }

const Setting* find(std::string_view key) {
  const auto* found = std::find_if(kTable.begin(), kTable.end(),
                                   [&](const Setting& setting) { return setting.key == key; });
  return found == kTable.end() ? nullptr : found;
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
                               [&](Lines S::*f) { return write_lines(settings.*f); }},
                    setting.member);
}

// How many letters must be put in, left out or exchanged to make one word of the other
// (Levenshtein 1966).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t exchanged = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({exchanged, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

std::string nearest_key(std::string_view key) {
  std::vector<std::string_view> keys = prusa_keys();
  // Ours first: they win where both are as near.
  std::vector<std::string_view> ours;
  ours.reserve(kTable.size());
  for (const Setting& setting : kTable) ours.push_back(setting.key);
  keys.insert(keys.begin(), ours.begin(), ours.end());
  return std::string(*std::min_element(keys.begin(), keys.end(), [&](auto a, auto b) {
    return edit_distance(key, a) < edit_distance(key, b);
  }));
}

}  // namespace

Status set_setting(Settings& settings, std::string_view key, std::string_view text) {
  std::string name(trimmed(key));
  std::replace(name.begin(), name.end(), '-', '_');
  if (const Setting* setting = find(name)) return assign(settings, *setting, text);
  const std::optional<std::vector<SettingText>> translated = from_prusa(name, text);
  if (!translated.has_value()) {
    return bad(
        fmt::format("there is no setting \"{}\"; the nearest is \"{}\" (rind settings lists "
                    "them all)",
                    trimmed(key), nearest_key(name)));
  }
  if (translated->empty()) {
    return bad(fmt::format("{} = {} is PrusaSlicer's and has no counterpart here", name, text));
  }
  Settings changed = settings;
  for (const SettingText& ours : *translated) {
    const Setting* setting = find(ours.key);
    RIND_CHECK(setting != nullptr);
    Status status = assign(changed, *setting, ours.text);
    if (!status.ok()) return status;
  }
  settings = std::move(changed);
  return {};
}

std::vector<SettingRow> describe_settings(const Settings& settings) {
  const Settings defaults;
  std::vector<SettingRow> rows;
  rows.reserve(kTable.size());
  for (const Setting& setting : kTable) {
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
