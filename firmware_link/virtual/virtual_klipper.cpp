// What is Klipper's own: it answers before it is ready and after it has shut down, refuses moves
// that it cannot make, and lets heaters and motors go when nothing moves for long. As klippy's
// modules gcode, webhooks, force_move and idle_timeout do (2026).
#include <algorithm>
#include <chrono>
#include <string>

#include "firmware_link/virtual/virtual_firmware.h"

namespace firmware_link {
namespace {

constexpr Duration kShutdownTakes = std::chrono::milliseconds(20);

std::string_view first_word(std::string_view text) { return text.substr(0, text.find(' ')); }

// "Z=5.2" in "SET_KINEMATIC_POSITION Z=5.2".
std::optional<std::int64_t> parameter_um(std::string_view text, char axis) {
  const std::size_t at = text.find(std::string(" ") + axis + "=");
  if (at == std::string_view::npos) return std::nullopt;
  return word(std::string(" ") + axis + std::string(text.substr(at + 3)), axis, 3);
}

}  // namespace

void VirtualController::Firmware::start_klipper(Duration ready_after) {
  klipper_.start(options_.klipper.config_error, ready_after, now_);
  position_.set_homed(options_.klipper.homed);
}

// What comes by the clock.
bool VirtualController::Firmware::klipper_turn() {
  if (!speaks(VirtualDialect::kKlipper)) return false;
  if (klipper_.found(now_)) {
    print("// Klipper state: Ready\n");
    return true;
  }
  const bool busy = !planner_.empty() || handler_.runs;
  if (!klipper_.falls_idle(busy, options_.klipper.idle_timeout, now_)) return false;
  heaters_.off();
  position_.set_homed(false);
  return true;
}

std::optional<Instant> VirtualController::Firmware::klipper_next() const {
  if (!speaks(VirtualDialect::kKlipper)) return std::nullopt;
  return klipper_.next(!planner_.empty() || handler_.runs, options_.klipper.idle_timeout);
}

// All lines as notes, where there are several, and the first as the error.
void VirtualController::Firmware::klipper_error(std::string_view message) {
  const std::string first(message.substr(0, message.find('\n')));
  if (first.size() < message.size()) {
    std::string notes = "// ";
    for (const char c : message) notes += c == '\n' ? std::string("\n// ") : std::string(1, c);
    print(notes + "\n");
  }
  print("!! " + first + "\n");
}

void VirtualController::Firmware::klipper_shut_down(std::string_view words) {
  bool was_ready = false;
  if (!klipper_.shut_down(words, &was_ready)) return;
  if (was_ready) print("// Klipper state: Shutdown\n");
  // Whatever was waited for is waited for no more.
  handler_.homes = false;
  blocks_.clear();
  if (!handler_.runs) return;
  wait_until(now_ + kShutdownTakes);
}

void VirtualController::Firmware::restart(Duration ready_after, Instant now) {
  advance(now);
  if (blocked()) return;
  // Its motors are let go first, and what comes then is refused.
  if (!slots_.empty()) print("!! Must home axis first: 1.000 2.000 0.200 [3.000]\nok\n");
  print("// Klipper state: Disconnect\n");
  forget_all();
  start_klipper(std::max(ready_after, kShutdownTakes));
  position_.set_homed(false);
}

bool VirtualController::Firmware::klipper_answers_unready(std::string_view command) {
  if (command == "M110" || command == "M112" || command == "M21" || command == "HELP") return false;
  if (command == "M115") return false;
  if (command == "M114") return klipper_.starting();
  if (command == "M105") return false;
  return true;
}

// SET_PRESSURE_ADVANCE, SET_VELOCITY_LIMIT.
bool VirtualController::Firmware::klipper_sets(std::string_view text) {
  const std::string_view command = first_word(text);
  if (command == "SET_VELOCITY_LIMIT") {
    set_.limits.set_velocity_limit(text);
    return true;
  }
  if (command != "SET_PRESSURE_ADVANCE") return false;
  if (const std::size_t at = text.find(" ADVANCE="); at != std::string_view::npos) {
    const auto told = word(" V" + std::string(text.substr(at + 9)), 'V', 5);
    set_.pressure_advance = static_cast<double>(told.value_or(0)) * 1e-5;
  }
  return true;
}

// True when it is one of printer.cfg's macros, which is obeyed.
bool VirtualController::Firmware::klipper_macro(std::string_view text) {
  const std::string_view name = first_word(text);
  std::string_view rest = options_.klipper.macros;
  while (!rest.empty()) {
    const std::string_view one = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(rest.size(), one.size() + 1));
    if (one.empty() || one != name) continue;
    if (name == "PRINT_START") home("G28");
    return true;
  }
  return false;
}

// True when that was the whole of its answer, but for the `ok`.
bool VirtualController::Firmware::klipper_answers(std::string_view text) {
  const std::string_view command = first_word(text);
  if (!klipper_.ready() && klipper_answers_unready(command)) {
    std::string message = klipper_.message();
    if (command == "STATUS") message += "\nKlipper state: Not ready";
    klipper_error(message);
    return true;
  }
  if (text.empty()) return true;
  if (command.size() > 1 && (command[0] == 'G' || command == "M400")) klipper_.wake();
  if (command == "STATUS") {
    print("// Klipper state: Ready\n");
  } else if (command == "HELP") {
    klipper_help();
  } else if (command == "SET_KINEMATIC_POSITION" && options_.klipper.force_move) {
    klipper_set_position(text);
  } else {
    return false;
  }
  return true;
}

void VirtualController::Firmware::klipper_help() {
  if (!klipper_.ready()) {
    print("// Printer is not ready - not all commands available.\n");
  }
  print(
      "// Available extended commands:\n// ECHO\n// FIRMWARE_RESTART: Restart firmware, host, and "
      "reload config\n// HELP      : Report the list of available extended G-Code commands\n");
  if (!klipper_.ready()) return;
  print("// SET_IDLE_TIMEOUT: Set the idle timeout in seconds\n");
  if (options_.klipper.force_move) {
    print("// SET_KINEMATIC_POSITION: Force a low-level kinematic position\n");
  }
}

void VirtualController::Firmware::klipper_set_position(std::string_view text) {
  constexpr char kAxes[] = {'X', 'Y', 'Z'};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    position_.home(axis, parameter_um(text, kAxes[axis]).value_or(position_.um()[axis]));
  }
}

// A move that it cannot make is not made in part.
bool VirtualController::Firmware::klipper_refuses(const VirtualPosition::Target& target) {
  const double low_mm[] = {options_.bed_origin_x_mm, options_.bed_origin_y_mm, 0};
  const double sides_mm[] = {options_.bed_x_mm, options_.bed_y_mm, options_.height_z_mm};
  const auto target_mm = [&](std::size_t axis) {
    return static_cast<double>(target.um[axis]) * 1e-3;
  };
  const char* why = nullptr;
  for (std::size_t axis = 0; axis < 3 && why == nullptr; ++axis) {
    if (target.um[axis] == position_.um()[axis]) continue;
    const double mm = target_mm(axis);
    if (!position_.homed(axis)) {
      why = "Must home axis first";
    } else if (mm < low_mm[axis] || mm > low_mm[axis] + sides_mm[axis]) {
      why = "Move out of range";
    }
  }
  if (why != nullptr) {
    print_format("!! %s: %.3f %.3f %.3f [%.3f]\n", why, target_mm(0), target_mm(1), target_mm(2),
                 static_cast<double>(position_.filament_10nm() + target.filament_10nm) * 1e-5);
    return true;
  }
  const bool cold = heaters_.nozzle.celsius() < options_.extrude_celsius_min;
  if (target.filament_10nm == 0 || !cold) return false;
  ++totals_.cold_extrusions;
  klipper_error("Extrude below minimum temp\nSee the 'min_extrude_temp' config option for details");
  return true;
}

}  // namespace firmware_link
