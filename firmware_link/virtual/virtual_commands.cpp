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

// Marlin makes no block of a move under 6 steps: the next move goes its way, too. Its default axis
// has 80 steps a mm.
constexpr double kBlockLengthMmMin = 6.0 / 80;

Duration seconds(double value) { return Duration(std::llround(value * 1e6)); }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

// Takes the first slot's line apart as Marlin's parser does, and starts its command.
void VirtualController::Firmware::start_command() {
  std::string_view text = slots_.front().text();
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  handler_.number.reset();
  const bool numbered = text.size() > 1 && text[0] == 'N' && (is_digit(text[1]) || text[1] == '-');
  // The checksum of a line is behind its last star; the command ends at its first.
  if (numbered) {
    const NumberedText parts = take_apart(text);
    handler_.number = parts.number;
    text = parts.text;
  }
  if (const std::size_t star = text.find('*'); star != std::string_view::npos) {
    text = text.substr(0, star);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  }
  handler_.runs = true;
  handler_.cancelled = false;
  handler_.waiting = Waiting::kNothing;
  handler_.until = now_ + options_.command_cost;
  handler_.until += mishaps_.starts(word_of(text));
  handler_.busy_next = now_ + std::chrono::seconds(reports_.busy_interval_s);
  if (speaks(VirtualDialect::kKlipper) && klipper_answers(text)) return;
  bool known = speaks(VirtualDialect::kKlipper) && (klipper_sets(text) || klipper_macro(text));
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
  if (!handler_.number) ++totals_.unnumbered_commands;
  if (options_.executed && !std::exchange(handler_.refused, false)) {
    SpelledBuffer buffer;
    options_.executed({now_, handler_.number, spelled_out(text, buffer), known, text});
  }
  if (!known) {
    print(unknown_command(options_.dialect, text));
  }
}

bool VirtualController::Firmware::handle(char letter, std::int64_t code, std::string_view text) {
  if (letter == 'T') {
    set_.tool = code;
    return true;
  }
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
    case 80:  // Prusa's way to measure the bed
      handler_.dwell = Duration(0);
      pause_was_asked_ = true;
      return true;
    case 90:
    case 91:
      position_.set_relative(code == 91);
      if (!speaks(VirtualDialect::kKlipper)) position_.set_relative_filament(code == 91);
      return true;
    case 92:
      position_.set(text);
      return true;
    default:
      return false;
  }
}

void VirtualController::Firmware::wait(Waiting waiting) { handler_.waiting = waiting; }

void VirtualController::Firmware::wait_until(Instant when) {
  handler_.waiting = Waiting::kTime;
  handler_.until = when;
}

// Ends the command in its handler if it has nothing more to wait for.
bool VirtualController::Firmware::finish_command() {
  if (!wait_over()) return false;
  if (handler_.homes) {
    handler_.homes = false;
    const double ends_mm[] = {options_.bed_origin_x_mm, options_.bed_origin_y_mm, 5};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (handler_.home_axes[axis]) position_.home(axis, std::llround(ends_mm[axis] * 1000));
    }
    if (numbers_lines(options_.dialect)) print_position();
  }
  end_command();
  return true;
}

bool VirtualController::Firmware::wait_over() {
  switch (handler_.waiting) {
    case Waiting::kNothing:
    case Waiting::kTime:
      return handler_.until <= now_;
    case Waiting::kPlannerSlot:
      return blocks_.plan(planner_, pause_was_asked_, now_);
    case Waiting::kPlannerEmpty:
      if (!planner_.empty()) return false;
      if (handler_.dwell.count() == 0) return true;
      wait_until(now_ + handler_.dwell);
      handler_.dwell = Duration(0);
      return false;
    case Waiting::kNozzle:
      return heated(heaters_.nozzle);
    case Waiting::kBed:
      return heated(heaters_.bed);
  }
  return true;
}

// Ten seconds within a degree of the target; what has to cool down isn't waited for.
bool VirtualController::Firmware::heated(const VirtualHeater& heater) {
  if (handler_.cancelled || heater.target() < heater.celsius() - kTemperatureWindow) return true;
  if (heater.target() > heater.celsius() + kTemperatureWindow) return false;
  if (!handler_.warm_since) handler_.warm_since = now_;
  return now_ - *handler_.warm_since >= kResidency;
}

void VirtualController::Firmware::end_command() {
  handler_.runs = false;
  if (mishaps_.silent() && reports_.temperatures)
    reports_.temperatures_next = now_ + *reports_.temperatures;
  const std::size_t slots_free = slots_.room();
  (void)slots_.pop();
  if (const auto instead = mishaps_.ends()) {
    handler_.asks_temperatures = handler_.asks_identity = false;
    print(*instead);
    return;
  }
  if (handler_.asks_temperatures) {
    handler_.asks_temperatures = false;
    print("ok");
    print_temperatures();
    print("\n");
    return;
  }
  print("ok");
  if (handler_.asks_identity) print(" FIRMWARE_NAME:Klipper FIRMWARE_VERSION:?");
  handler_.asks_identity = false;
  if (options_.advanced_ok) {
    if (handler_.number) print_format(" N%lld", static_cast<long long>(*handler_.number));
    print_format(" P%zu B%zu", kPlannerBlocks - 1 - planner_.count(), slots_free);
  }
  print("\n");
}

// `way` is null for a straight move.
void VirtualController::Firmware::move(std::string_view text, const ArcWay* way) {
  const bool klipper = speaks(VirtualDialect::kKlipper);
  const bool leaves = way != nullptr && leaves_bed(*way);
  VirtualPosition::Target target = position_.target_of(text, travel_of(options_), !klipper);
  if (klipper && klipper_refuses(target)) {
    handler_.refused = true;
    return;
  }
  std::array<double, 3> delta_mm{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    delta_mm[axis] = static_cast<double>(target.um[axis] - position_.um()[axis]) * 1e-3;
  }
  position_.go(target);
  std::int64_t filament = target.filament_10nm;
  if (filament != 0 && heaters_.nozzle.celsius() < options_.extrude_celsius_min) {
    ++totals_.cold_extrusions;
    print(cold_extrusion(options_.dialect));
    filament = 0;
  }
  ++totals_.moves;
  totals_.clamped_moves += leaves || target.clamped ? 1 : 0;
  totals_.filament_10nm += filament;
  const double length_mm =
      way != nullptr ? way->length_mm : std::hypot(delta_mm[0], delta_mm[1], delta_mm[2]);
  totals_.distance_mm += length_mm;
  if (filament > 0 && length_mm > 0) {
    standing_.laid();
    totals_.z_mm_max = std::max(totals_.z_mm_max, position_.mm(2));
  }
  queue_move(length_mm, delta_mm, static_cast<double>(filament) * 1e-5, way);
}

void VirtualController::Firmware::queue_move(double length_mm, std::array<double, 3> delta,
                                             double filament_mm, const ArcWay* way) {
  if (way == nullptr) {
    for (std::size_t axis = 0; axis < delta.size(); ++axis) {
      delta[axis] += std::exchange(blocks_.short_way_mm[axis], 0.0);
    }
    filament_mm += std::exchange(blocks_.short_way_mm[3], 0.0);
    length_mm = std::hypot(delta[0], delta[1], delta[2]);
  }
  PlannerMove block;
  const bool moves = length_mm > 0;
  block.length_mm = moves ? length_mm : std::abs(filament_mm);
  const double least_mm = numbers_lines(options_.dialect) ? kBlockLengthMmMin : 1e-6;
  if (block.length_mm < least_mm) {
    blocks_.short_way_mm = {delta[0], delta[1], delta[2], filament_mm};
    return;
  }
  for (std::size_t axis = 0; moves && axis < delta.size(); ++axis) {
    block.direction[axis] = delta[axis] / length_mm;
  }
  block.direction[3] = filament_mm / block.length_mm;
  block.speed_mm_s =
      std::max(set_.limits.speed_mm_s(block.direction, position_.speed_mm_s()), 0.05);
  block.acceleration_mm_s2 = set_.limits.acceleration(block.direction);
  block.corners = set_.limits.corners;
  if (way != nullptr && way->radius_mm > 0) {
    queue_arc(*way, block);
  } else {
    queue_blocks(block, 1, 0);
  }
}

void VirtualController::Firmware::dwell(std::string_view text) {
  handler_.dwell = Duration(0);
  if (const auto milliseconds = word(text, 'P', 0)) handler_.dwell = Duration(*milliseconds * 1000);
  if (const auto thousandths = word(text, 'S', 3)) handler_.dwell = Duration(*thousandths * 1000);
  pause_was_asked_ = true;
  wait(Waiting::kPlannerEmpty);
}

void VirtualController::Firmware::home(std::string_view text) {
  constexpr char kAxes[] = {'X', 'Y', 'Z'};
  const std::string_view behind = text.substr(std::min<std::size_t>(text.size(), 3));
  bool any = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    handler_.home_axes[axis] = behind.find(kAxes[axis]) != std::string_view::npos;
    any = any || handler_.home_axes[axis];
  }
  if (!any) handler_.home_axes = {true, true, true};
  double time = 2;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!handler_.home_axes[axis]) continue;
    const double distance = std::abs(position_.mm(axis)) + 5;
    time += distance / (axis == 2 ? kHomingZSpeedMmS : kHomingSpeedMmS);
  }
  handler_.homes = true;
  handler_.dwell = seconds(time) + options_.homing_time;
  pause_was_asked_ = true;
  wait(Waiting::kPlannerEmpty);
}

void VirtualController::Firmware::print_position() {
  print(position_of(options_.dialect, state()));
}

}  // namespace firmware_link
