#include "host/settings/setting_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "host/settings/prusa_left_out.h"
#include "host/settings/settings_prusa.h"
#include "host/settings/settings_rows.h"

namespace host {
namespace {

struct Synonym {
  std::string_view word;
  std::string_view key;
};

// Names in other programs and in everyday use.
constexpr std::array kSynonyms = {
    Synonym{"walls", "perimeters"},
    Synonym{"wall_loops", "perimeters"},
    Synonym{"wall_count", "perimeters"},
    Synonym{"wall_line_count", "perimeters"},
    Synonym{"shells", "perimeters"},
    Synonym{"infill", "loose_density"},
    Synonym{"infill_density", "loose_density"},
    Synonym{"sparse_infill_density", "loose_density"},
    Synonym{"density", "loose_density"},
    Synonym{"infill_angle", "fill_angle_degrees"},
    Synonym{"line_width", "road_width"},
    Synonym{"width", "road_width"},
    Synonym{"height", "layer_height"},
    Synonym{"nozzle", "nozzle_diameter"},
    Synonym{"vase", "spiral_vase"},
    Synonym{"vase_mode", "spiral_vase"},
    Synonym{"spiral_mode", "spiral_vase"},
    Synonym{"spiralize", "spiral_vase"},
    Synonym{"magic_spiralize", "spiral_vase"},
    Synonym{"filament", "filament_diameter"},
    Synonym{"flow", "extrusion_multiplier"},
    Synonym{"flow_ratio", "extrusion_multiplier"},
    Synonym{"speed", "perimeter_speed_mm_s"},
    Synonym{"print_speed", "perimeter_speed_mm_s"},
    Synonym{"fan", "fan_share"},
    Synonym{"fan_speed", "fan_share"},
    Synonym{"nozzle_temperature", "nozzle_celsius"},
    Synonym{"hotend", "nozzle_celsius"},
    Synonym{"bed_temp", "bed_celsius"},
    Synonym{"bed", "bed_x"},
    Synonym{"bed_width", "bed_x"},
    Synonym{"bed_depth", "bed_y"},
    Synonym{"bed_height", "axis_z"},
    Synonym{"z_hop", "retraction_lift"},
    Synonym{"retraction", "retraction_mm"},
    Synonym{"retraction_speed", "retraction_speed_mm_s"},
    Synonym{"skirt", "skirt_loops"},
    Synonym{"center", "centre"},
};

// Number of letters to insert, delete or replace to turn one word into the other (Levenshtein
// 1966).
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

// Names that differ by more than this are not confused.
std::size_t farthest(std::string_view key) { return std::min<std::size_t>(3, key.size() / 3); }

struct Nearest {
  std::string_view key;
  std::size_t distance = std::numeric_limits<std::size_t>::max();
};

void look_at(std::string_view candidate, std::string_view key, Nearest& nearest) {
  const std::size_t longer = std::max(candidate.size(), key.size());
  if (longer - std::min(candidate.size(), key.size()) > farthest(key)) return;
  const std::size_t distance = edit_distance(key, candidate);
  if (distance <= farthest(key) && distance < nearest.distance) nearest = {candidate, distance};
}

}  // namespace

std::string unknown_setting(std::string_view typed, std::string_view key) {
  constexpr const char* kAll = "rind settings lists them all";
  if (is_left_out(key)) {
    return fmt::format("\"{}\" is a setting of PrusaSlicer that rind does not have", typed);
  }
  const auto* synonym = std::find_if(kSynonyms.begin(), kSynonyms.end(),
                                     [&](const Synonym& one) { return one.word == key; });
  if (synonym != kSynonyms.end()) {
    return fmt::format("there is no setting \"{}\"; here it is called \"{}\" ({})", typed,
                       synonym->key, kAll);
  }
  // Our names first: they win if another is equally similar.
  Nearest nearest;
  for (const Setting& setting : kSettings) look_at(setting.key, key, nearest);
  for (const std::string_view theirs : prusa_keys()) look_at(theirs, key, nearest);
  Nearest left_out = nearest;
  for (const std::string_view theirs : left_out_keys()) look_at(theirs, key, left_out);
  if (left_out.distance < nearest.distance) {
    return fmt::format(
        "there is no setting \"{}\"; the nearest is PrusaSlicer's \"{}\", which rind does not have",
        typed, left_out.key);
  }
  if (nearest.key.empty()) return fmt::format("there is no setting \"{}\" ({})", typed, kAll);
  return fmt::format("there is no setting \"{}\"; the nearest is \"{}\" ({})", typed, nearest.key,
                     kAll);
}

}  // namespace host
