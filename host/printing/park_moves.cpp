#include "host/printing/park_moves.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "core/bed.h"                        // Bed
#include "core/check.h"                      // RIND_CHECK
#include "core/motions/park_place.h"         // kParkEdge, park_place
#include "firmware_link/wire/gcode_words.h"  // commands_in
#include "host/gcode/set_up_lines.h"         // sets_up
#include "host/pipeline/standing_values.h"
#include "host/pipeline/user_gcode.h"  // restored_after
#include "host/pipeline/wire_units.h"
#include "host/printing/safe_moves.h"

namespace host {
namespace {

using firmware_link::Command;
using firmware_link::Heater;
using firmware_link::Move;

constexpr std::int64_t kEdge_um = core::kParkEdge.units() / kUnitsPerUm;

// Whether the line sets the controller up and moves nothing.
bool sets_up_alone(const std::string& line) {
  const std::vector<std::string> codes = firmware_link::commands_in(line);
  return codes.size() == 1 && sets_up(codes.front());
}

// RepRapFirmware's macros for tools move axes, which are not homed.
std::string without_macros(const std::string& tool, firmware_link::Flavor flavor) {
  return flavor == firmware_link::Flavor::kRepRapFirmware ? tool + " P0" : tool;
}

ParkingPosition from_bed_origin(ParkingPosition position, const core::Settings& settings) {
  position.x_um += settings.bed_origin_x.units() / kUnitsPerUm;
  position.y_um += settings.bed_origin_y.units() / kUnitsPerUm;
  return position;
}

// The place, or one beside it that is on a bed that is no rectangle.
ParkingPosition on_outline(ParkingPosition position, core::Length edge,
                           const core::Settings& settings) {
  const core::Point at =
      core::Bed(settings).place_near({static_cast<std::int32_t>(position.x_um * kUnitsPerUm),
                                      static_cast<std::int32_t>(position.y_um * kUnitsPerUm)},
                                     edge);
  return {at.x / kUnitsPerUm, at.y / kUnitsPerUm};
}

std::int64_t gap(std::int64_t at, std::int64_t low, std::int64_t high) {
  return std::max<std::int64_t>({low - at, at - high, 0});
}

}  // namespace

ParkingPosition parking_position(const core::Settings& settings, const core::Box& part) {
  const auto inside = [](core::Length side) {
    const std::int64_t all = side.units() / kUnitsPerUm;
    const std::int64_t edge = std::min(kEdge_um, all / 2);
    return std::pair(edge, all - edge);
  };
  const auto [left, right] = inside(settings.bed_x);
  const auto [front, back] = inside(settings.bed_y);
  ParkingPosition best{left, front};
  std::int64_t farthest = part.empty() ? INT64_MAX : -1;
  for (const std::int64_t x : {left, right}) {
    for (const std::int64_t y : {front, back}) {
      const std::int64_t way = gap(x, part.min.x / kUnitsPerUm, part.max.x / kUnitsPerUm) +
                               gap(y, part.min.y / kUnitsPerUm, part.max.y / kUnitsPerUm);
      if (way > farthest) best = {x, y};
      farthest = std::max(farthest, way);
    }
  }
  const bool asked_x = settings.park_x >= core::Length();
  const bool asked_y = settings.park_y >= core::Length();
  const core::Point asked = core::park_place(settings);
  if (asked_x) best.x_um = asked.x / kUnitsPerUm;
  if (asked_y) best.y_um = asked.y / kUnitsPerUm;
  if (!settings.bed_shape.empty() && !(asked_x && asked_y)) {
    best = on_outline(best, asked_x || asked_y ? core::Length() : core::kParkEdge, settings);
  }
  return from_bed_origin(best, settings);
}

std::vector<Command> ParkMoves::leave_part(const MachineState& here) const {
  if (!here.position_known()) return {};
  std::vector<Command> way = here.own_modes();
  const std::vector<Command> off =
      lift_off(retraction_10nm(settings_) - here.drawn_back_10nm, lifted_from_um(here), settings_);
  way.insert(way.end(), off.begin(), off.end());
  // Where the parking position is in a file's own coordinates, nobody knows.
  if (here.shifted) return way;
  way.push_back(travel_move(position_.x_um, position_.y_um, settings_.travel_speed_mm_s));
  return way;
}

std::vector<Command> ParkMoves::come_back(const MachineState& here, bool reheat) const {
  std::vector<Command> way;
  if (reheat) {
    way.emplace_back(firmware_link::SetTemperature{Heater::kBed, here.bed_tenths, false});
    way.emplace_back(firmware_link::SetTemperature{Heater::kNozzle, here.nozzle_tenths, true});
  }
  const std::vector<Command> modes = here.file_modes_again();
  if (!here.position_known()) {
    way.insert(way.end(), modes.begin(), modes.end());
    return way;
  }
  const std::int64_t back = retraction_10nm(settings_);
  const std::int64_t drawn = std::max(here.drawn_back_10nm, back);
  if (drawn > 0) way.push_back(filament_move(drawn, settings_.retraction_speed_mm_s));
  way.push_back(filament_move(filament_10nm(kPrime_mm), kPrimeSpeed_mm_s));
  if (back > 0) way.push_back(filament_move(-back, settings_.retraction_speed_mm_s));
  way.push_back(travel_move(*here.x_um, *here.y_um, settings_.travel_speed_mm_s));
  way.push_back(lift_move(*here.z_um, settings_.lift_speed_mm_s));
  const std::int64_t owed = back - here.drawn_back_10nm;
  if (owed != 0) way.push_back(filament_move(owed, settings_.retraction_speed_mm_s));
  way.emplace_back(firmware_link::SetFan{here.fan});
  if (here.acceleration_mm_s2 > 0) {
    way.emplace_back(firmware_link::SetAcceleration{here.flavor, here.acceleration_mm_s2});
  }
  if (here.f_mm_min) {
    Move feed;
    feed.f_mm_min = here.f_mm_min;
    way.emplace_back(feed);
  }
  way.insert(way.end(), modes.begin(), modes.end());
  return way;
}

std::vector<Command> ParkMoves::restart(const MachineState& here, std::int64_t nozzle_z_um,
                                        std::string_view height_command,
                                        const std::vector<std::string>& file_set_up) const {
  std::vector<std::string> set_up = file_set_up;
  if (set_up.empty()) {
    std::copy_if(settings_.start_gcode.begin(), settings_.start_gcode.end(),
                 std::back_inserter(set_up), sets_up_alone);
    const std::string tool = StandingValues(settings_).tool();
    if (!tool.empty()) set_up.insert(set_up.begin(), without_macros(tool, here.flavor));
  }
  std::vector<Command> way = {command_of("G21"), command_of("G90"), command_of("M83")};
  for (const std::string& line : set_up) way.push_back(command_of(line));
  for (const std::string& line : restored_after(set_up)) way.push_back(command_of(line));
  const std::vector<Command> ways_of_moving = here.ways_of_moving();
  way.insert(way.end(), ways_of_moving.begin(), ways_of_moving.end());
  if (!height_command.empty()) {
    const double z_mm = static_cast<double>(nozzle_z_um) / 1'000;
    way.push_back(command_of(fmt::format("{}{:.3f}", height_command, z_mm)));
  }
  // Both heat up together. The nozzle may stick to what it laid, so it is hot before it moves.
  way.emplace_back(firmware_link::SetTemperature{Heater::kNozzle, here.nozzle_tenths, false});
  const bool bed = here.bed_tenths > 0;
  if (bed) way.emplace_back(firmware_link::SetTemperature{Heater::kBed, here.bed_tenths, true});
  way.emplace_back(firmware_link::SetTemperature{Heater::kNozzle, here.nozzle_tenths, true});
  const std::int64_t from_um = std::max(nozzle_z_um, lifted_from_um(here).value_or(nozzle_z_um));
  // Behind the user's own lines the filament is drawn back, and come_back() leaves it so.
  const std::int64_t draw_back_10nm = here.position_known() ? retraction_10nm(settings_) : 0;
  const std::vector<Command> off = lift_off(draw_back_10nm, from_um, settings_);
  way.insert(way.end(), off.begin(), off.end());
  way.push_back(command_of("G28 X Y"));
  way.push_back(travel_move(position_.x_um, position_.y_um, settings_.travel_speed_mm_s));
  return way;
}

}  // namespace host
