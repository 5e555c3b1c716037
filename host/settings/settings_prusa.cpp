#include "host/settings/settings_prusa.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/result.h"
#include "host/settings/settings_text.h"

namespace host {
namespace {

using Translated = std::vector<SettingText>;

enum class Kind {
  kNumber,       // as it is; percentages (of another setting) have no counterpart
  kWidth,        // a number, but 0 means "automatic"
  kHeight,       // a number, 0 means the same with us
  kShare,        // with "%"
  kPercent,      // a whole number of percent, without "%"
  kLayersAfter,  // how many layers go before the first one
  kGcode,
  kBed,
};

struct Alias {
  std::string_view theirs;
  std::string_view ours;
  Kind kind = Kind::kNumber;
};

constexpr std::array kAliases = {
    Alias{"layer_height", "layer_height"},
    Alias{"nozzle_diameter", "nozzle_diameter"},
    Alias{"filament_diameter", "filament_diameter"},
    Alias{"extrusion_width", "road_width", Kind::kWidth},
    Alias{"perimeters", "perimeters"},
    Alias{"fill_density", "loose_density", Kind::kShare},
    Alias{"fill_angle", "fill_angle_degrees"},
    Alias{"skirts", "skirt_loops"},
    Alias{"skirt_distance", "skirt_distance"},
    Alias{"perimeter_speed", "perimeter_speed_mm_s"},
    Alias{"external_perimeter_speed", "outer_perimeter_speed_mm_s"},
    Alias{"solid_infill_speed", "solid_speed_mm_s"},
    Alias{"infill_speed", "loose_speed_mm_s"},
    Alias{"gap_fill_speed", "rest_speed_mm_s"},
    Alias{"first_layer_speed", "first_layer_speed_mm_s"},
    Alias{"travel_speed", "travel_speed_mm_s"},
    Alias{"slowdown_below_layer_time", "layer_time_min_s"},
    Alias{"min_print_speed", "slowed_speed_min_mm_s"},
    Alias{"retract_length", "retraction_mm"},
    Alias{"retract_speed", "retraction_speed_mm_s"},
    Alias{"retract_before_travel", "retraction_travel_min"},
    Alias{"retract_lift", "retraction_lift"},
    Alias{"bed_shape", "bed_x", Kind::kBed},
    Alias{"max_print_height", "axis_z", Kind::kHeight},
    Alias{"temperature", "nozzle_celsius"},
    Alias{"first_layer_temperature", "nozzle_first_layer_celsius"},
    Alias{"bed_temperature", "bed_celsius"},
    Alias{"max_fan_speed", "fan_share", Kind::kPercent},
    Alias{"disable_fan_first_layers", "fan_from_layer", Kind::kLayersAfter},
    Alias{"start_gcode", "start_gcode", Kind::kGcode},
    Alias{"end_gcode", "end_gcode", Kind::kGcode},
};

constexpr std::array<std::string_view, 14> kHallmarks = {"top_solid_layers",
                                                         "bottom_solid_layers",
                                                         "support_material",
                                                         "brim_width",
                                                         "raft_layers",
                                                         "gcode_flavor",
                                                         "fill_pattern",
                                                         "infill_extrusion_width",
                                                         "perimeter_extrusion_width",
                                                         "first_layer_height",
                                                         "cooling",
                                                         "solid_infill_below_area",
                                                         "avoid_crossing_perimeters",
                                                         "external_perimeter_extrusion_width"};

// "0x0,250x0,250x210,0x210": the four corners of a rectangle at the origin, in any order.
Translated bed(std::string_view text) {
  double x_max = 0, y_max = 0;
  int corners = 0;
  std::vector<std::pair<double, double>> points;
  while (!text.empty()) {
    const std::string_view point = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), point.size() + 1));
    const std::size_t cross = point.find('x');
    if (cross == std::string_view::npos) return {};
    const core::Result<double> x = read_number(point.substr(0, cross), "mm");
    const core::Result<double> y = read_number(point.substr(cross + 1), "mm");
    if (!x.ok() || !y.ok()) return {};
    points.emplace_back(x.value(), y.value());
    x_max = std::max(x_max, x.value());
    y_max = std::max(y_max, y.value());
  }
  for (const auto& corner : {std::pair(0.0, 0.0), {x_max, 0.0}, {x_max, y_max}, {0.0, y_max}}) {
    corners += std::find(points.begin(), points.end(), corner) != points.end() ? 1 : 0;
  }
  if (corners != 4 || points.size() != 4) return {};
  return {{"bed_x", write_number(x_max)}, {"bed_y", write_number(y_max)}};
}

Translated translate(const Alias& alias, std::string_view text) {
  const std::string ours(alias.ours);
  if (alias.kind == Kind::kBed) return bed(text);
  if (alias.kind == Kind::kGcode) {
    if (text.find_first_of("[{") != std::string_view::npos) return {};
    return {{ours, std::string(text)}};
  }
  const std::string_view first = trimmed(text.substr(0, text.find(',')));
  if (alias.kind == Kind::kShare) return {{ours, std::string(first)}};
  if (first.ends_with('%')) return {};
  const core::Result<double> number = read_number(first, "");
  // What is no number at all is left to the setting itself, which says so.
  if (!number.ok()) return {{ours, std::string(first)}};
  switch (alias.kind) {
    case Kind::kWidth:
      if (number.value() == 0) return {};
      break;
    case Kind::kPercent:
      return {{ours, write_number(number.value() / 100)}};
    case Kind::kLayersAfter:
      return {{ours, write_number(number.value() + 1)}};
    default:
      break;
  }
  return {{ours, std::string(first)}};
}

}  // namespace

std::optional<Translated> from_prusa(std::string_view key, std::string_view text) {
  for (const Alias& alias : kAliases) {
    if (alias.theirs == key) return translate(alias, trimmed(text));
  }
  return std::nullopt;
}

std::vector<std::string_view> prusa_keys() {
  std::vector<std::string_view> keys;
  keys.reserve(kAliases.size());
  for (const Alias& alias : kAliases) keys.push_back(alias.theirs);
  return keys;
}

bool is_prusa_hallmark(std::string_view key) {
  return std::find(kHallmarks.begin(), kHallmarks.end(), key) != kHallmarks.end();
}

}  // namespace host
