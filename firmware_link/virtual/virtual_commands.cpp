// What the virtual controller's commands do: heaters, motion, and when a handler is done.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "firmware_link/session/command_waits.h"  // word_of
#include "firmware_link/virtual/virtual_firmware.h"
#include "firmware_link/virtual/virtual_speech.h"  // unknown_command …
#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

constexpr double kTemperatureWindow = 1;
constexpr double kHomingSpeedMmS = 50;
constexpr double kHomingZSpeedMmS = 4;

// Marlin makes no block of a move under 6 steps; its default axis has 80 steps a mm.
constexpr double kBlockLengthMmMin = 6.0 / 80;

Duration seconds(double value) { return Duration(std::llround(value * 1e6)); }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

// Takes the first slot's line apart as Marlin's parser does, and begins what it says.
void VirtualController::Firmware::begin_command() {
  std::string_view text = slots_.front().line();
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  current_number_.reset();
  const bool numbered = text.size() > 1 && text[0] == 'N' && (is_digit(text[1]) || text[1] == '-');
  // The checksum of a line is behind its last star; the command ends at its first.
  if (numbered) {
    const NumberedText parts = take_apart(text);
    current_number_ = parts.number;
    text = parts.text;
  }
  if (const std::size_t star = text.find('*'); star != std::string_view::npos) {
    text = text.substr(0, star);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  }
  handling_ = true;
  waiting_cancelled_ = false;
  waiting_ = Waiting::kNothing;
  wait_until_ = now_ + options_.command_cost;
  if (delay_next_.count() > 0 && (delay_word_.empty() || word_of(text) == delay_word_)) {
    wait_until_ += delay_next_;
    delay_next_ = Duration(0);
  }
  busy_next_ = now_ + std::chrono::seconds(busy_interval_s_);

  losing_ = lose_word_ && (lose_word_->empty() || word_of(text) == *lose_word_);
  if (losing_) lose_word_.reset();
  if (speaks(VirtualDialect::kKlipper) && klipper_answers(text)) return;
  bool known = false;
  if (text.size() > 1 && is_digit(text[1])) {
    std::size_t end = 1;
    std::int64_t code = 0;
    while (end < text.size() && is_digit(text[end]) && code < 100000) {
      code = code * 10 + (text[end++] - '0');
    }
    known = handle(text[0], code, text);
  }
  ++totals_.commands;
  if (!known) ++totals_.unknown_commands;
  if (!current_number_) ++totals_.unnumbered_commands;
  if (options_.executed && !std::exchange(refused_, false)) {
    SpelledBuffer buffer;
    options_.executed({now_, current_number_, spelled_out(text, buffer), known});
  }
  if (!known) {
    print(unknown_command(options_.dialect, text));
  }
}

bool VirtualController::Firmware::handle(char letter, std::int64_t code, std::string_view text) {
  if (letter == 'T') return true;
  if (letter == 'G') return handle_g(code, text);
  if (letter == 'M') return handle_m(code, text);
  return false;
}

bool VirtualController::Firmware::handle_g(std::int64_t code, std::string_view text) {
  switch (code) {
    case 0:
    case 1:
      move(text, nullptr);
      return true;
    case 2:
    case 3:
      if (speaks(VirtualDialect::kKlipper)) return false;  // without [gcode_arcs]
      arc(code, text);
      return true;
    case 4:
      dwell(text);
      return true;
    case 21:
      return true;
    case 28:
      home(text);
      return true;
    case 29:
      dwell_ = Duration(0);
      pause_was_asked_ = true;
      return true;
    case 90:
    case 91:
      relative_ = code == 91;
      if (!speaks(VirtualDialect::kKlipper)) relative_e_ = relative_;
      return true;
    case 92:
      set_position(text);
      return true;
    default:
      return false;
  }
}

void VirtualController::Firmware::wait(Waiting waiting) { waiting_ = waiting; }

void VirtualController::Firmware::wait_until(Instant when) {
  waiting_ = Waiting::kTime;
  wait_until_ = when;
}

// Ends the command in its handler if it has nothing more to wait for.
bool VirtualController::Firmware::finish_command() {
  if (!wait_over()) return false;
  if (homing_) {
    homing_ = false;
    const double ends_mm[] = {options_.bed_origin_x_mm, options_.bed_origin_y_mm, 5};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!home_axes_[axis]) continue;
      homed_[axis] = true;
      position_um_[axis] = std::llround(ends_mm[axis] * 1000);
    }
    if (numbers_lines(options_.dialect)) print_position();
  }
  end_command();
  return true;
}

bool VirtualController::Firmware::wait_over() {
  switch (waiting_) {
    case Waiting::kNothing:
    case Waiting::kTime:
      return wait_until_ <= now_;
    case Waiting::kPlannerSlot:
      return plan_pending();
    case Waiting::kPlannerEmpty:
      if (!planner_.empty()) return false;
      if (dwell_.count() == 0) return true;
      wait_until(now_ + dwell_);
      dwell_ = Duration(0);
      return false;
    case Waiting::kNozzle:
      return heated(nozzle_);
    case Waiting::kBed:
      return heated(bed_);
  }
  return true;
}

// Ten seconds within a degree of the target; what has to cool down isn't waited for.
bool VirtualController::Firmware::heated(const VirtualHeater& heater) {
  if (waiting_cancelled_ || heater.target() < heater.celsius() - kTemperatureWindow) return true;
  if (heater.target() > heater.celsius() + kTemperatureWindow) return false;
  if (!within_window_since_) within_window_since_ = now_;
  return now_ - *within_window_since_ >= kResidency;
}

void VirtualController::Firmware::end_command() {
  handling_ = false;
  if (silent_ && auto_report_) auto_report_next_ = now_ + *auto_report_;
  const std::size_t slots_free = slots_.room();
  (void)slots_.pop();
  if (std::exchange(losing_, false)) {
    temperatures_asked_ = identity_asked_ = false;
    print(lose_instead_);
    return;
  }
  if (temperatures_asked_) {
    temperatures_asked_ = false;
    print("ok");
    print_temperatures();
    print("\n");
    return;
  }
  print("ok");
  if (identity_asked_) print(" FIRMWARE_NAME:Klipper FIRMWARE_VERSION:?");
  identity_asked_ = false;
  if (options_.advanced_ok) {
    if (current_number_) print_format(" N%lld", static_cast<long long>(*current_number_));
    print_format(" P%zu B%zu", kPlannerBlocks - 1 - planner_.count(), slots_free);
  }
  print("\n");
}

// `way` is null for a straight move.
void VirtualController::Firmware::move(std::string_view text, const ArcWay* way) {
  constexpr char kAxes[] = {'X', 'Y', 'Z'};
  const double low_mm[] = {options_.bed_origin_x_mm, options_.bed_origin_y_mm, 0};
  const double sides_mm[] = {options_.bed_x_mm, options_.bed_y_mm, options_.height_z_mm};
  if (const auto feed = word(text, 'F', 0); feed && *feed > 0) feed_mm_min_ = *feed;
  std::array<double, 3> delta_mm{};
  std::array<std::int64_t, 3> targets_um = position_um_;
  bool clamped = way != nullptr && leaves_bed(*way);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value = word(text, kAxes[axis], 3);
    if (!value) continue;
    std::int64_t target = relative_ ? position_um_[axis] + *value : *value;
    if (homed_[axis] && !speaks(VirtualDialect::kKlipper)) {
      const std::int64_t low = std::llround(low_mm[axis] * 1000);
      const std::int64_t high = low + std::llround(sides_mm[axis] * 1000);
      const std::int64_t inside = std::clamp<std::int64_t>(target, low, high);
      clamped = clamped || inside != target;
      target = inside;
    }
    delta_mm[axis] = static_cast<double>(target - position_um_[axis]) * 1e-3;
    targets_um[axis] = target;
  }
  std::int64_t filament = 0;
  if (const auto value = word(text, 'E', 5)) {
    filament = relative_e_ ? *value : *value - e_10nm_;
  }
  if (speaks(VirtualDialect::kKlipper) && klipper_refuses(targets_um, filament)) {
    refused_ = true;
    return;
  }
  position_um_ = targets_um;
  e_10nm_ += filament;
  if (filament != 0 && nozzle_.celsius() < options_.extrude_celsius_min) {
    ++totals_.cold_extrusions;
    print(cold_extrusion(options_.dialect));
    filament = 0;
  }
  ++totals_.moves;
  totals_.clamped_moves += clamped ? 1 : 0;
  totals_.filament_10nm += filament;
  const double length_mm =
      way != nullptr ? way->length_mm : std::hypot(delta_mm[0], delta_mm[1], delta_mm[2]);
  totals_.distance_mm += length_mm;
  if (filament > 0 && length_mm > 0) {
    laid_ = true;
    totals_.z_mm_max = std::max(totals_.z_mm_max, static_cast<double>(position_um_[2]) * 1e-3);
  }
  queue_move(length_mm, delta_mm, static_cast<double>(filament) * 1e-5, way);
}

void VirtualController::Firmware::queue_move(double length_mm, const std::array<double, 3>& delta,
                                             double filament_mm, const ArcWay* way) {
  PlannerMove block;
  const bool moves = length_mm > 0;
  block.length_mm = moves ? length_mm : std::abs(filament_mm);
  if (block.length_mm < kBlockLengthMmMin) return;
  double speed = static_cast<double>(feed_mm_min_ * feed_percent_) / 6000.0;
  const double limits[] = {options_.speed_xy_mm_s_max, options_.speed_xy_mm_s_max,
                           options_.speed_z_mm_s_max};
  for (std::size_t axis = 0; moves && axis < 3; ++axis) {
    block.direction[axis] = delta[axis] / length_mm;
    const double share = std::abs(block.direction[axis]);
    if (share > 0) speed = std::min(speed, limits[axis] / share);
  }
  if (filament_mm != 0) {
    speed = std::min(speed, options_.speed_e_mm_s_max * block.length_mm / std::abs(filament_mm));
  }
  block.speed_mm_s = std::max(speed, 0.05);
  block.acceleration_mm_s2 = options_.acceleration_mm_s2;
  if (way != nullptr && way->radius_mm > 0) {
    queue_arc(*way, block);
  } else {
    pending_turn_ = 0;
    queue_blocks(block, 1);
  }
}

void VirtualController::Firmware::dwell(std::string_view text) {
  dwell_ = Duration(0);
  if (const auto milliseconds = word(text, 'P', 0)) dwell_ = Duration(*milliseconds * 1000);
  if (const auto thousandths = word(text, 'S', 3)) dwell_ = Duration(*thousandths * 1000);
  pause_was_asked_ = true;
  wait(Waiting::kPlannerEmpty);
}

void VirtualController::Firmware::home(std::string_view text) {
  constexpr char kAxes[] = {'X', 'Y', 'Z'};
  const std::string_view behind = text.substr(std::min<std::size_t>(text.size(), 3));
  bool any = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    home_axes_[axis] = behind.find(kAxes[axis]) != std::string_view::npos;
    any = any || home_axes_[axis];
  }
  if (!any) home_axes_ = {true, true, true};
  double time = 2;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!home_axes_[axis]) continue;
    const double distance = std::abs(static_cast<double>(position_um_[axis])) * 1e-3 + 5;
    time += distance / (axis == 2 ? kHomingZSpeedMmS : kHomingSpeedMmS);
  }
  homing_ = true;
  dwell_ = seconds(time) + options_.homing_time;
  pause_was_asked_ = true;
  wait(Waiting::kPlannerEmpty);
}

void VirtualController::Firmware::set_position(std::string_view text) {
  constexpr char kAxes[] = {'X', 'Y', 'Z'};
  const auto e = word(text, 'E', 5);
  bool any = e.has_value();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (const auto value = word(text, kAxes[axis], 3)) {
      position_um_[axis] = *value;
      any = true;
    }
  }
  if (e) e_10nm_ = *e;
  if (any) return;
  position_um_ = {};
  e_10nm_ = 0;
}

void VirtualController::Firmware::print_position() {
  print(position_of(options_.dialect, state()));
}

}  // namespace firmware_link
