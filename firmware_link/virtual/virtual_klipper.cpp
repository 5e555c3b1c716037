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

constexpr std::string_view kStartupMessage =
    "Printer is not ready\n"
    "The klippy host software is attempting to connect.  Please\n"
    "retry in a few moments.";
constexpr std::string_view kShutdownMessage =
    "\nOnce the underlying issue is corrected, use the\n"
    "\"FIRMWARE_RESTART\" command to reset the firmware, reload the\n"
    "config, and restart the host software.\nPrinter is shutdown";
constexpr std::string_view kErrorMessage =
    "\n\nOnce the underlying issue is corrected, use the \"RESTART\"\n"
    "command to reload the config and restart the host software.\nPrinter is halted";

std::string_view first_word(std::string_view text) { return text.substr(0, text.find(' ')); }

// "Z=5.2" in "SET_KINEMATIC_POSITION Z=5.2".
std::optional<std::int64_t> parameter_um(std::string_view text, char axis) {
  const std::size_t at = text.find(std::string(" ") + axis + "=");
  if (at == std::string_view::npos) return std::nullopt;
  return word(std::string(1, axis) + std::string(text.substr(at + 3)), axis, 3);
}

}  // namespace

void VirtualController::Firmware::klipper_begin(Duration ready_after) {
  klipper_ready_.reset();
  klipper_idle_ = true;
  homed_.fill(options_.homed);
  if (!options_.config_error.empty()) {
    klipper_ = KlipperState::kError;
  } else if (ready_after.count() > 0) {
    klipper_ = KlipperState::kStartup;
    klipper_ready_ = now_ + ready_after;
  } else {
    klipper_ = KlipperState::kReady;
  }
}

// What comes by the clock.
bool VirtualController::Firmware::klipper_turn() {
  if (!speaks(VirtualDialect::kKlipper)) return false;
  if (klipper_ready_ && *klipper_ready_ <= now_) {
    klipper_ready_.reset();
    klipper_ = KlipperState::kReady;
    print("// Klipper state: Ready\n");
    return true;
  }
  if (!planner_.empty() || handling_) {
    moved_last_ = now_;
    return false;
  }
  if (klipper_idle_ || klipper_ != KlipperState::kReady ||
      now_ < moved_last_ + options_.idle_timeout) {
    return false;
  }
  klipper_idle_ = true;
  nozzle_.set_target(0);
  bed_.set_target(0);
  homed_ = {};
  return true;
}

std::optional<Instant> VirtualController::Firmware::klipper_next() const {
  if (klipper_ready_) return klipper_ready_;
  if (!speaks(VirtualDialect::kKlipper) || klipper_idle_ || !planner_.empty() || handling_) {
    return std::nullopt;
  }
  return moved_last_ + options_.idle_timeout;
}

std::string VirtualController::Firmware::klipper_state_message() const {
  switch (klipper_) {
    case KlipperState::kStartup:
      return std::string(kStartupMessage);
    case KlipperState::kShutdown:
      return klipper_words_ + std::string(kShutdownMessage);
    case KlipperState::kError:
      return std::string(options_.config_error) + std::string(kErrorMessage);
    case KlipperState::kReady:
      break;
  }
  return "Printer is ready";
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
  if (klipper_ == KlipperState::kShutdown) return;
  const bool asked = words.find("M112") != std::string_view::npos;
  klipper_words_ = asked ? "Shutdown due to M112 command" : words.substr(0, words.find('\n'));
  const bool was_ready = klipper_ == KlipperState::kReady;
  klipper_ = KlipperState::kShutdown;
  klipper_ready_.reset();
  if (was_ready) print("// Klipper state: Shutdown\n");
  // Whatever was waited for is waited for no more.
  homing_ = false;
  pending_blocks_ = 0;
  if (!handling_) return;
  waiting_ = Waiting::kTime;
  wait_until_ = now_ + kShutdownTakes;
}

void VirtualController::Firmware::restart(Duration ready_after, Instant now) {
  advance(now);
  if (blocked()) return;
  // Its motors are let go first, and what comes then is refused.
  if (!slots_.empty()) print("!! Must home axis first: 1.000 2.000 0.200 [3.000]\nok\n");
  print("// Klipper state: Disconnect\n");
  forget_all();
  klipper_begin(std::max(ready_after, kShutdownTakes));
  homed_ = {};
}

bool VirtualController::Firmware::klipper_answers_unready(std::string_view command) {
  if (command == "M110" || command == "M112" || command == "M21" || command == "HELP") return false;
  if (command == "M115") return false;
  if (command == "M114") return klipper_ == KlipperState::kStartup;
  if (command == "M105") return false;
  return true;
}

// True when that was the whole of its answer, but for the `ok`.
bool VirtualController::Firmware::klipper_answers(std::string_view text) {
  const std::string_view command = first_word(text);
  if (klipper_ != KlipperState::kReady && klipper_answers_unready(command)) {
    std::string message = klipper_state_message();
    if (command == "STATUS") message += "\nKlipper state: Not ready";
    klipper_error(message);
    return true;
  }
  if (text.empty()) return true;
  if (command.size() > 1 && (command[0] == 'G' || command == "M400")) klipper_idle_ = false;
  if (command == "STATUS") {
    print("// Klipper state: Ready\n");
  } else if (command == "HELP") {
    klipper_help();
  } else if (command == "SET_KINEMATIC_POSITION" && options_.force_move) {
    klipper_set_position(text);
  } else {
    return false;
  }
  return true;
}

void VirtualController::Firmware::klipper_help() {
  if (klipper_ != KlipperState::kReady) {
    print("// Printer is not ready - not all commands available.\n");
  }
  print(
      "// Available extended commands:\n// ECHO\n// FIRMWARE_RESTART: Restart firmware, host, and "
      "reload config\n// HELP      : Report the list of available extended G-Code commands\n");
  if (klipper_ != KlipperState::kReady) return;
  print("// SET_IDLE_TIMEOUT: Set the idle timeout in seconds\n");
  if (options_.force_move) {
    print("// SET_KINEMATIC_POSITION: Force a low-level kinematic position\n");
  }
}

void VirtualController::Firmware::klipper_set_position(std::string_view text) {
  constexpr char kAxes[] = {'X', 'Y', 'Z'};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (const auto value = parameter_um(text, kAxes[axis])) position_um_[axis] = *value;
    homed_[axis] = true;
  }
}

// A move that it cannot make is not made in part.
bool VirtualController::Firmware::klipper_refuses(const std::array<std::int64_t, 3>& target_um,
                                                  std::int64_t filament_10nm) {
  const double low_mm[] = {options_.bed_origin_x_mm, options_.bed_origin_y_mm, 0};
  const double sides_mm[] = {options_.bed_x_mm, options_.bed_y_mm, options_.height_z_mm};
  const char* why = nullptr;
  for (std::size_t axis = 0; axis < 3 && why == nullptr; ++axis) {
    if (target_um[axis] == position_um_[axis]) continue;
    const double mm = static_cast<double>(target_um[axis]) * 1e-3;
    if (!homed_[axis]) {
      why = "Must home axis first";
    } else if (mm < low_mm[axis] || mm > low_mm[axis] + sides_mm[axis]) {
      why = "Move out of range";
    }
  }
  if (why != nullptr) {
    print_format("!! %s: %.3f %.3f %.3f [%.3f]\n", why, static_cast<double>(target_um[0]) * 1e-3,
                 static_cast<double>(target_um[1]) * 1e-3, static_cast<double>(target_um[2]) * 1e-3,
                 static_cast<double>(e_10nm_ + filament_10nm) * 1e-5);
    return true;
  }
  if (filament_10nm == 0 || nozzle_.celsius() >= options_.extrude_celsius_min) return false;
  ++totals_.cold_extrusions;
  klipper_error("Extrude below minimum temp\nSee the 'min_extrude_temp' config option for details");
  return true;
}

}  // namespace firmware_link
