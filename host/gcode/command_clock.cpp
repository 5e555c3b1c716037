#include "host/gcode/command_clock.h"

#include <algorithm>
#include <array>
#include <string>
#include <variant>

#include "firmware_link/wire/gcode_words.h"  // canonical, command_word_size, is_classic
#include "host/gcode/flavor_of.h"
#include "host/gcode/gcode_numbers.h"
#include "host/gcode/line_meaning.h"
#include "host/gcode/model_changes.h"

namespace host {
namespace {

using firmware_link::Effect;
using firmware_link::Move;
using firmware_link::PlaceAfter;
using firmware_link::ReadyLine;

// A controller that is told to wait longer is left to wait: it is no part of the motion.
constexpr double kDwellMax_s = 3'600;

double mm(std::int64_t um) { return static_cast<double>(um) * 1e-3; }

bool moves(const Move& move) { return move.x_um || move.y_um || move.z_um || move.e_10nm; }

// These wait until all that was planned has been done.
bool comes_to_rest(std::string_view command) {
  constexpr std::array<std::string_view, 17> kRest = {"G4",   "G28",  "G29",  "G30",  "G32", "G80",
                                                      "M0",   "M1",   "M18",  "M109", "M25", "M84",
                                                      "M190", "M226", "M400", "M600", "M601"};
  return std::find(kRest.begin(), kRest.end(), command) != kRest.end();
}

double dwell_s(std::string_view parameters) {
  const GcodeNumbers numbers(parameters);
  double seconds = 0;
  if (const auto ms = numbers.fixed('P')) seconds = static_cast<double>(*ms) * 1e-8;
  if (const auto s = numbers.fixed('S')) seconds = static_cast<double>(*s) * 1e-5;
  return std::clamp(seconds, 0.0, kDwellMax_s);
}

}  // namespace

CommandClock::CommandClock(const core::Settings& settings)
    : flavor_(flavor_of(settings.gcode_flavor)), clock_(core::motion_model(settings)) {}

void CommandClock::add(const firmware_link::Command& command, std::optional<double> filament_mm) {
  if (const auto* move = std::get_if<Move>(&command)) add_filament(move->e_10nm.value_or(0));
  add_time(command, filament_mm);
}

void CommandClock::add_time(const firmware_link::Command& command,
                            std::optional<double> filament_mm) {
  if (const auto* move = std::get_if<Move>(&command)) {
    add_move(*move, filament_mm);
  } else if (const auto* ready = std::get_if<ReadyLine>(&command)) {
    add_line(*ready);
  } else if (const auto* line = std::get_if<firmware_link::Verbatim>(&command)) {
    add_user_line(*line);
  } else if (const auto* set = std::get_if<firmware_link::SetAcceleration>(&command)) {
    core::MotionModel model = clock_.model();
    model.acceleration_mm_s2 = set->mm_s2;
    model.travel_acceleration_mm_s2 = 0;
    clock_.set_model(model);
  } else if (const auto* heat = std::get_if<firmware_link::SetTemperature>(&command)) {
    if (heat->wait) clock_.rest(0);
  }
}

void CommandClock::add_move(const Move& move, std::optional<double> filament_mm) {
  if (move.f_mm_min) feed_mm_min_ = *move.f_mm_min;
  if (!moves(move)) return;
  core::MotionClock::Move way;
  if (move.arc) {
    way.arc = {mm(x_um_ + move.arc->i_um), mm(y_um_ + move.arc->j_um), move.arc->clockwise,
               mm(move.arc->length_um)};
  }
  x_um_ = move.x_um.value_or(x_um_);
  y_um_ = move.y_um.value_or(y_um_);
  z_um_ = move.z_um.value_or(z_um_);
  way.x_mm = mm(x_um_);
  way.y_mm = mm(y_um_);
  way.z_mm = mm(z_um_);
  way.filament_mm =
      filament_mm ? *filament_mm : static_cast<double>(move.e_10nm.value_or(0)) * 1e-5;
  way.speed_mm_s =
      static_cast<double>(std::max<std::int64_t>(1, feed_mm_min_ * feed_percent_)) / 6'000;
  clock_.add(way);
}

CommandClock CommandClock::at_rest(std::int64_t x_um, std::int64_t y_um, std::int64_t z_um) const {
  CommandClock clock = *this;
  clock.clock_ = core::MotionClock(clock_.model());
  clock.x_um_ = x_um;
  clock.y_um_ = y_um;
  clock.z_um_ = z_um;
  clock.clock_.set_place(mm(x_um), mm(y_um), mm(z_um));
  return clock;
}

bool CommandClock::goes_on_as(const CommandClock& from, bool any_height) const {
  return x_um_ == from.x_um_ && y_um_ == from.y_um_ && (any_height || z_um_ == from.z_um_) &&
         feed_mm_min_ == from.feed_mm_min_ && feed_percent_ == from.feed_percent_ &&
         flavor_ == from.flavor_ && clock_.goes_on_as(from.clock_, any_height);
}

void CommandClock::skip(const CommandClock& from, const CommandClock& to, bool any_height) {
  x_um_ = to.x_um_;
  y_um_ = to.y_um_;
  if (!any_height) z_um_ = to.z_um_;
  feed_mm_min_ = to.feed_mm_min_;
  clock_.skip(from.clock_, to.clock_, any_height);
}

void CommandClock::add_line(const ReadyLine& line) {
  add_filament(line.move.e_10nm.value_or(0));
  add_move(line.move, std::nullopt);
  if (line.effect.kind == Effect::Kind::kFeedPercent) feed_percent_ = line.effect.value;
  if (line.effect.kind == Effect::Kind::kFlowPercent) flow_percent_ = line.effect.value;
  if (line.place == PlaceAfter::kAxesLost) {
    if ((line.lost_axes & 1) != 0) x_um_ = 0;
    if ((line.lost_axes & 2) != 0) y_um_ = 0;
    if ((line.lost_axes & 4) != 0) z_um_ = 0;
    clock_.set_place(mm(x_um_), mm(y_um_), mm(z_um_));
  }
  if (moves(line.move)) return;
  change_model(line.words.text());
}

// What these change in modes and factors holds for rind's own commands behind them, too; those
// that restore modes are such lines.
void CommandClock::add_user_line(const firmware_link::Verbatim& line) {
  modes_.x_um = x_um_;
  modes_.y_um = y_um_;
  modes_.z_um = z_um_;
  MeaningRules rules;
  rules.flavor = flavor_;
  rules.checks = false;
  const core::Result<std::optional<LineMeaning>> meaning = meaning_of(line.text(), rules, modes_);
  if (meaning.ok() && meaning.value()) add_line(meaning.value()->line);
}

void CommandClock::change_model(std::string_view text) {
  const std::size_t word_size = firmware_link::command_word_size(text);
  const std::string command = firmware_link::canonical(text.substr(0, word_size));
  const std::string_view parameters = text.substr(word_size);
  if (command == "M600" && needed_10nm_ > 0 && !to_change_mm_) to_change_mm_ = needed_mm();
  core::MotionModel model = clock_.model();
  if (changes_model(command, parameters, flavor_, model)) {
    clock_.set_model(model);
  } else if (comes_to_rest(command)) {
    clock_.rest(command == "G4" ? dwell_s(parameters) : 0);
  }
}

}  // namespace host
