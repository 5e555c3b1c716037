// validate_settings(): rules between settings.
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/bed.h"  // Bed
#include "core/limits.h"
#include "core/motions/height_actions.h"    // read_height_action
#include "core/raft_heights.h"              // raft_lift, settings_above_raft
#include "core/settings.h"                  // wall_layers
#include "core/slices/height_limits.h"      // adaptive_bounds
#include "core/slices/height_ranges.h"      // height_ranges
#include "core/supports/support_heights.h"  // support_ranges
#include "host/output/thumbnail_text.h"     // read_thumbnails
#include "host/part/part_transform.h"       // check_part_transform
#include "host/settings/own_accelerations.h"
#include "host/settings/settings_table.h"

namespace host {
namespace {

using core::Status;

// Wider roads don't stick: the flat face of the nozzle ends about there.
constexpr double kRoadPerNozzleMax = 2.5;

core::Error bad(std::string message) { return {core::ErrorCode::kBadSetting, std::move(message)}; }

// Settings from code are checked like those that a user typed.
Status every_value_in_range(const PrintSettings& settings) {
  PrintSettings copy = settings;
  for (const SettingRow& row : describe_settings(settings)) {
    Status status = set_setting(copy, row.key, row.value);
    if (!status.ok()) return status;
  }
  return {};
}

Status wall_fits_window(const PrintSettings& settings) {
  const int layers = core::wall_layers(settings);
  if (layers <= core::kWallLayersMax) return {};
  return bad(fmt::format(
      "wall_thickness = {} mm is {} layers of layer_height = {} mm, the window takes {}: "
      "a thinner wall or thicker layers",
      settings.wall_thickness.mm(), layers, settings.layer_height.mm(), core::kWallLayersMax));
}

// Names and values of a layer's height and of its roads' width.
Status road_fits_nozzle(const PrintSettings& settings, std::string_view height_key,
                        core::Length layer_height, std::string_view width_key,
                        core::Length road_width) {
  const double nozzle = settings.nozzle_diameter.mm();
  const double height = layer_height.mm(), width = road_width.mm();
  if (height > nozzle) {
    return bad(fmt::format(
        "{} = {} mm is more than nozzle_diameter = {} mm: such roads are not pressed onto the "
        "layer below",
        height_key, height, nozzle));
  }
  if (width <= height || width > kRoadPerNozzleMax * nozzle) {
    return bad(fmt::format(
        "{} = {} mm must be more than {} = {} mm and at most {} times nozzle_diameter = {} mm",
        width_key, width, height_key, height, kRoadPerNozzleMax, nozzle));
  }
  return {};
}

// Of kinds of road that have a width of their own.
std::vector<std::pair<std::string_view, core::Length>> own_widths(const PrintSettings& settings) {
  std::vector<std::pair<std::string_view, core::Length>> widths;
  if (settings.top_width > core::Length()) widths.emplace_back("top_width", settings.top_width);
  if (settings.support_width > core::Length()) {
    widths.emplace_back("support_width", settings.support_width);
  }
  return widths;
}

Status roads_fit_nozzle(const PrintSettings& settings) {
  const core::Length height = settings.layer_height, width = settings.road_width;
  Status fits = road_fits_nozzle(settings, "layer_height", height, "road_width", width);
  if (!fits.ok()) return fits;
  const bool own_height = settings.first_layer_height > core::Length();
  const bool own_width = settings.first_layer_width > core::Length();
  fits = road_fits_nozzle(settings, own_height ? "first_layer_height" : "layer_height",
                          own_height ? settings.first_layer_height : height,
                          own_width ? "first_layer_width" : "road_width",
                          own_width ? settings.first_layer_width : width);
  if (!fits.ok()) return fits;
  for (const auto& [key, own] : own_widths(settings)) {
    fits = road_fits_nozzle(settings, "layer_height", height, key, own);
    if (!fits.ok()) return fits;
    if (settings.road_width_min <= own) continue;
    return bad(fmt::format("road_width_min = {} mm is more than {} = {} mm",
                           settings.road_width_min.mm(), key, own.mm()));
  }
  if (own_width && settings.road_width_min > settings.first_layer_width) {
    return bad(fmt::format("road_width_min = {} mm is more than first_layer_width = {} mm",
                           settings.road_width_min.mm(), settings.first_layer_width.mm()));
  }
  if (settings.road_width_min > settings.road_width) {
    return bad(fmt::format("road_width_min = {} mm is more than road_width = {} mm",
                           settings.road_width_min.mm(), width.mm()));
  }
  return {};
}

Status vase_has_a_thin_wall(const PrintSettings& settings) {
  if (!settings.spiral_vase || settings.style == core::BuildStyle::kThinWall) return {};
  return bad("spiral_vase needs style = thin-wall: a vase has no inside to build another way");
}

Status vase_has_no_supports(const PrintSettings& settings) {
  if (!settings.spiral_vase || settings.supports == core::SupportPlace::kOff) return {};
  return bad("spiral_vase needs supports = off: a vase is laid in one go, without travel");
}

Status lookahead_is_enough(const PrintSettings& settings) {
  if (settings.support_lookahead == 0 || settings.supports == core::SupportPlace::kOff) return {};
  if (settings.support_style != core::SupportStyle::kGrid) {
    return bad("support_lookahead needs support_style = grid: branches depend on the whole part");
  }
  if (settings.loose_roof == core::LooseRoof::kOff &&
      settings.loose_pattern != core::LoosePattern::kLightning) {
    return {};
  }
  return bad(
      "support_lookahead needs an inside that is known as soon: loose_roof = off, and no "
      "lightning, which both depend on the whole part");
}

// A height that layers may have besides layer_height, under the name of what says so.
Status height_fits(const PrintSettings& settings, const std::string& name, core::Length height) {
  Status fits = road_fits_nozzle(settings, name, height, "road_width", settings.road_width);
  for (const auto& [key, own] : own_widths(settings)) {
    if (fits.ok()) fits = road_fits_nozzle(settings, name, height, key, own);
  }
  if (!fits.ok() || core::wall_counts_layers(settings)) return fits;
  if (height * core::kWallLayersMax >= settings.wall_thickness) return {};
  return bad(fmt::format(
      "wall_thickness = {} mm is more than {} layers of {} = {} mm, as many as the window takes: "
      "a thinner wall or thicker layers",
      settings.wall_thickness.mm(), core::kWallLayersMax, name, height.mm()));
}

Status other_heights_fit(const PrintSettings& settings) {
  if (settings.adaptive_layer_height) {
    const core::HeightBounds bounds = core::adaptive_bounds(settings);
    if (bounds.lowest > bounds.highest) {
      const bool given = settings.layer_height_max > core::Length();
      return bad(fmt::format(
          "layer_height_min = {} mm and layer_height_max = {} mm{} leave no height of whole "
          "hundredths of a millimetre between them",
          settings.layer_height_min.mm(),
          given ? settings.layer_height_max.mm() : bounds.highest.mm(),
          given ? "" : " (auto: 3/4 of nozzle_diameter)"));
    }
    Status fits = height_fits(settings, "layer_height_max", bounds.highest);
    if (fits.ok()) fits = height_fits(settings, "layer_height_min", bounds.lowest);
    if (!fits.ok()) return fits;
  }
  // Of the part's own layers.
  const auto ranges =
      core::height_ranges(core::settings_above_raft(static_cast<const core::Settings&>(settings)));
  if (!ranges.ok()) return ranges.error();
  for (const core::HeightRange& range : ranges.value()) {
    const std::string name = fmt::format("height_range, line {}: height", range.line);
    if (Status fits = height_fits(settings, name, range.height); !fits.ok()) return fits;
  }
  const bool given = settings.wall_shape == core::WallShape::kCylinder && settings.wall_layers > 0;
  if (!core::has_unequal_layers(settings) || !core::wall_counts_layers(settings) || given)
    return {};
  return bad(
      "wall_shape = cylinder and style = fast count layers, and with adaptive_layer_height or "
      "height_range these differ in height: set wall_layers as well, or use wall_shape = ball");
}

Status accelerations_have_a_default(const PrintSettings& settings) {
  if (settings.default_acceleration_mm_s2 > 0) return {};
  for (const auto& [key, member] : kOwnAccelerations) {
    if (settings.*member == 0) continue;
    return bad(fmt::format(
        "{} = {:g} needs default_acceleration_mm_s2, too: what other roads have, and what the "
        "printer is left with",
        key, settings.*member));
  }
  return {};
}

Status heights_of_slowdown_fit(const PrintSettings& settings) {
  const core::Length from = settings.height_slowdown_from, to = settings.height_slowdown_to;
  const bool speed = settings.height_slowdown_speed < 1;
  const bool acceleration = settings.height_slowdown_acceleration < 1;
  if (to == core::Length()) {
    if (from == core::Length() && !speed && !acceleration) return {};
    return bad("height_slowdown_from, _speed and _acceleration need height_slowdown_to");
  }
  if (to <= from) {
    return bad(
        fmt::format("height_slowdown_to = {} mm must be more than height_slowdown_from = {} "
                    "mm",
                    to.mm(), from.mm()));
  }
  if (acceleration && settings.default_acceleration_mm_s2 == 0) {
    return bad(
        "height_slowdown_acceleration needs default_acceleration_mm_s2: of the printer's own "
        "nothing is known");
  }
  return {};
}

Status part_has_a_place(const PrintSettings& settings) {
  const double x = settings.part_x.mm(), y = settings.part_y.mm();
  if (settings.centre && (x != 0 || y != 0)) {
    return bad(fmt::format(
        "part_x = {} mm, part_y = {} mm contradict centre = 1: set centre = 0 as well", x, y));
  }
  if (settings.part_x >= settings.bed_x || settings.part_y >= settings.bed_y) {
    return bad(fmt::format("part_x = {} mm, part_y = {} mm is not on the bed of {} by {} mm", x, y,
                           settings.bed_x.mm(), settings.bed_y.mm()));
  }
  if (settings.park_x > settings.bed_x || settings.park_y > settings.bed_y) {
    return bad(fmt::format("park_x = {} mm, park_y = {} mm is not on the bed of {} by {} mm",
                           settings.park_x.mm(), settings.park_y.mm(), settings.bed_x.mm(),
                           settings.bed_y.mm()));
  }
  const core::Point park{static_cast<std::int32_t>(settings.park_x.units()),
                         static_cast<std::int32_t>(settings.park_y.units())};
  const bool named = settings.park_x >= core::Length() && settings.park_y >= core::Length();
  if (named && !core::Bed(settings).holds(park)) {
    return bad(
        fmt::format("park_x = {} mm, park_y = {} mm is beyond the outline of the bed "
                    "(bed_shape)",
                    settings.park_x.mm(), settings.park_y.mm()));
  }
  if (settings.axis_z == core::Length()) return {};
  if (settings.axis_z < settings.layer_height) {
    return bad(fmt::format("axis_z = {} mm is less than one layer of {} mm; off: not limited",
                           settings.axis_z.mm(), settings.layer_height.mm()));
  }
  if (const core::Length lift = core::raft_lift(settings);
      settings.axis_z < settings.layer_height + lift) {
    return bad(
        fmt::format("axis_z = {} mm holds no layer of {} mm over a raft of {} mm: "
                    "fewer raft_layers",
                    settings.axis_z.mm(), settings.layer_height.mm(), lift.mm()));
  }
  return {};
}

Status support_heights_are_known(const PrintSettings& settings) {
  const auto ranges = core::support_ranges(settings);
  return ranges.ok() ? Status() : ranges.error();
}

Status actions_are_known(const PrintSettings& settings) {
  for (std::size_t i = 0; i < settings.at_height.size(); ++i) {
    const auto action = core::read_height_action(settings.at_height[i]);
    if (!action.ok())
      return bad(fmt::format("at_height, line {}: {}", i + 1, action.error().message));
  }
  return {};
}

Status thumbnails_are_known(const PrintSettings& settings) {
  const auto read = read_thumbnails(settings.thumbnails, settings.thumbnails_format);
  return read.ok() ? Status() : bad("thumbnails: " + read.error().message);
}

Status part_can_be_placed(const PrintSettings& settings) { return check_part_transform(settings); }

}  // namespace

Status validate_settings(const PrintSettings& settings) {
  for (const auto rule :
       {every_value_in_range, wall_fits_window, roads_fit_nozzle, other_heights_fit,
        vase_has_a_thin_wall, vase_has_no_supports, lookahead_is_enough,
        accelerations_have_a_default, heights_of_slowdown_fit, part_has_a_place,
        support_heights_are_known, actions_are_known, thumbnails_are_known, part_can_be_placed}) {
    Status status = rule(settings);
    if (!status.ok()) return status;
  }
  return {};
}

}  // namespace host
