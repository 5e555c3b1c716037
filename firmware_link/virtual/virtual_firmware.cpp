#include "firmware_link/virtual/virtual_firmware.h"

#include <algorithm>
#include <chrono>

#include "firmware_link/virtual/virtual_speech.h"  // banner_of
#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

constexpr Duration kSecond = std::chrono::seconds(1);

void take_earlier(std::optional<Instant>& earliest, Instant candidate) {
  if (!earliest || candidate < *earliest) earliest = candidate;
}

}  // namespace

VirtualController::Firmware::Firmware(const VirtualControllerOptions& options, Instant now)
    : options_(options),
      now_(now),
      reader_(numbers_lines(options.dialect)),
      heaters_{{options.ambient_celsius, options.nozzle_heating_celsius_s, now},
               {options.ambient_celsius, options.bed_heating_celsius_s, now}} {
  LINK_CHECK(options_.baud >= 0 && options_.command_cost.count() >= 0);
  LINK_CHECK(options_.limits.acceleration_mm_s2 > 0);
  set_.limits = options_.limits;
  if (numbers_lines(options_.dialect) && options_.busy_lines) reports_.busy_interval_s = 2;
  planner_.moved = options_.moved;
  print(banner_of(options_.dialect));
  if (speaks(VirtualDialect::kKlipper)) start_klipper(options_.klipper.ready_after);
}

std::size_t VirtualController::Firmware::input(std::span<const std::byte> bytes, Instant now) {
  advance(now);
  if (options_.baud == 0) {
    for (const std::byte b : bytes) {
      receive(static_cast<char>(b));
      // The main loop is faster than any wire; without this a long write would overflow the ring.
      if (static_cast<char>(b) == '\n' || receive_.room() == 0) advance(now);
    }
    return bytes.size();
  }
  const std::size_t taken = std::min(bytes.size(), wire_.room());
  if (wire_.size() == 0) wire_ready_ = now + Duration(10'000'000 / options_.baud);
  for (const std::byte b : bytes.first(taken)) wire_.push(static_cast<char>(b));
  return taken;
}

void VirtualController::Firmware::receive(char c) {
  if (halted_) return;
  // Klipper and RepRapFirmware always look for it in what arrives.
  if (options_.emergency_parser || !numbers_lines(options_.dialect)) {
    const VirtualEarlyCommands::Act act = early_.read(c);
    if (act == VirtualEarlyCommands::Act::kEndWait) handler_.cancelled = true;
    if (act == VirtualEarlyCommands::Act::kStop) {
      kill("echo:M112 Shutdown\n");
      return;
    }
  }
  if (receive_.room() == 0) {
    ++totals_.receive_bytes_lost;
    return;
  }
  receive_.push(c);
  totals_.receive_bytes_max = std::max(totals_.receive_bytes_max, receive_.size());
}

// Does one thing that can be done at now_; false when there is none.
bool VirtualController::Firmware::step() {
  if (wire_.size() > 0 && wire_ready_ <= now_) {
    receive(wire_.pop());
    wire_ready_ += Duration(10'000'000 / options_.baud);
    return true;
  }
  if (halted_ || blocked()) return false;
  if (report() || klipper_turn()) return true;
  if (handler_.runs && finish_command()) return true;
  if (!handler_.runs && !slots_.empty()) {
    start_command();
    return true;
  }
  return read_bytes();
}

void VirtualController::Firmware::advance(Instant now) {
  LINK_CHECK(now >= now_);
  while (true) {
    while (step()) {
    }
    const std::optional<Instant> next = next_event();
    // An event at now_ that step() could not use waits for room in the answers.
    if (!next || *next > now || *next <= now_) break;
    note_standing();
    now_ = *next;
    planner_.advance(now_);
    heaters_.advance(now_);
    note_standing();
  }
  note_standing();
  now_ = std::max(now_, now);
  planner_.advance(now_);
  note_standing();
  heaters_.advance(now_);
}

void VirtualController::Firmware::note_standing() {
  standing_.look(halted_ || handler_.runs || !slots_.empty() || !planner_.empty(), now_);
}

void VirtualController::Firmware::set_last_line(std::int64_t number, Instant now) {
  advance(now);
  numbers_.set_last(number);
}

std::size_t VirtualController::Firmware::output(std::span<std::byte> into) {
  std::size_t count = 0;
  while (count < into.size() && answers_.size() > 0) {
    into[count++] = static_cast<std::byte>(answers_.pop());
  }
  return count;
}

std::optional<Instant> VirtualController::Firmware::next_event() const {
  std::optional<Instant> next;
  if (wire_.size() > 0) take_earlier(next, wire_ready_);
  if (halted_ || blocked()) return next;
  if (reports_.temperatures && !(mishaps_.silent() && handler_.runs))
    take_earlier(next, reports_.temperatures_next);
  if (const auto planner = planner_.next_event()) take_earlier(next, *planner);
  if (const auto klipper = klipper_next()) take_earlier(next, *klipper);
  if (!handler_.runs) return next;
  if (reports_.busy_interval_s > 0) take_earlier(next, handler_.busy_next);
  switch (handler_.waiting) {
    case Waiting::kNothing:
    case Waiting::kTime:
      take_earlier(next, handler_.until);
      break;
    case Waiting::kNozzle:
    case Waiting::kBed:
      take_earlier(next, handler_.heat_report_next);
      if (handler_.warm_since) take_earlier(next, *handler_.warm_since + kResidency);
      break;
    case Waiting::kPlannerSlot:
    case Waiting::kPlannerEmpty:
      break;
  }
  return next;
}

bool VirtualController::Firmware::owes_answer() const {
  if (klipper_.becomes_ready()) return true;
  return !halted_ && (wire_.size() > 0 || receive_.size() > 0 || !slots_.empty());
}

void VirtualController::Firmware::reset(Instant now) {
  advance(now);
  forget_all();
  print(banner_of(options_.dialect));
  if (speaks(VirtualDialect::kKlipper)) start_klipper(options_.klipper.ready_after);
}

void VirtualController::Firmware::forget_all() {
  wire_.clear();
  receive_.clear();
  early_.clear();
  unpacker_ = {};
  reader_.clear();
  numbers_.set_last(0);
  slots_.clear();
  handler_.runs = handler_.homes = false;
  handler_.waiting = Waiting::kNothing;
  mishaps_.forget_delay();
  reports_.busy_interval_s = numbers_lines(options_.dialect) && options_.busy_lines ? 2 : 0;
  reports_.temperatures.reset();
  halted_ = false;
  position_ = {};
  blocks_.clear();
  planner_.clear();
  set_ = {};
  set_.limits = options_.limits;
  pause_was_asked_ = true;
  heaters_.off();
  heaters_.fan = 0;
  standing_.cooled();
}

VirtualControllerState VirtualController::Firmware::state() const {
  VirtualControllerState state;
  state.x_mm = position_.mm(0);
  state.y_mm = position_.mm(1);
  state.z_mm = position_.mm(2);
  state.e_mm = static_cast<double>(position_.filament_10nm()) * 1e-5;
  state.nozzle_celsius = heaters_.nozzle.celsius();
  state.nozzle_target_celsius = heaters_.nozzle.target();
  state.bed_celsius = heaters_.bed.celsius();
  state.bed_target_celsius = heaters_.bed.target();
  state.fan = heaters_.fan;
  state.halted = halted_;
  state.last_line = numbers_.last();
  state.planner_blocks = planner_.count();
  state.tool = set_.tool;
  state.feed_percent = position_.feed_percent();
  state.flow_percent = set_.flow_percent;
  state.pressure_advance = set_.pressure_advance;
  state.limits = set_.limits;
  return state;
}

const VirtualControllerTotals& VirtualController::Firmware::totals() {
  totals_.stood_max = standing_.longest();
  totals_.planner_underruns = planner_.underruns();
  totals_.planner_low = planner_.low();
  totals_.planner_busy = planner_.busy();
  totals_.planner_blocks_max = planner_.count_max();
  return totals_;
}

void VirtualController::Firmware::print(std::string_view text) {
  // step() starts nothing with less than half the room left, and no answer is as long as that.
  LINK_CHECK(text.size() <= answers_.room());
  for (const char c : text) answers_.push(c);
}

std::string VirtualController::Firmware::temperatures() const {
  HeaterReport report;
  report.nozzle_celsius = heaters_.nozzle.celsius();
  report.nozzle_target = heaters_.nozzle.target();
  report.nozzle_power = heaters_.nozzle.power();
  report.bed_celsius = heaters_.bed.celsius();
  report.bed_target = heaters_.bed.target();
  report.bed_power = heaters_.bed.power();
  return temperatures_of(options_.dialect, report);
}

void VirtualController::Firmware::print_temperatures() { print(temperatures()); }

// Says what is due by the clock.
bool VirtualController::Firmware::report() {
  if (reports_.temperatures && !(mishaps_.silent() && handler_.runs) &&
      reports_.temperatures_next <= now_) {
    reports_.temperatures_next += *reports_.temperatures;
    print_temperatures();
    print("\n");
    return true;
  }
  if (!handler_.runs) return false;
  const bool heating = handler_.waiting == Waiting::kNozzle || handler_.waiting == Waiting::kBed;
  if (heating && handler_.heat_report_next <= now_) {
    handler_.heat_report_next += kSecond;
    (void)heated(handler_.waiting == Waiting::kNozzle ? heaters_.nozzle : heaters_.bed);
    if (speaks(VirtualDialect::kRepRap)) return true;  // it waits in silence
    if (speaks(VirtualDialect::kKlipper)) {
      print(temperatures().substr(1) + "\n");
      return true;
    }
    print_temperatures();
    if (handler_.warm_since) {
      const Duration rest = std::max(Duration(0), *handler_.warm_since + kResidency - now_);
      print_format(" W:%d\n", static_cast<int>(rest / kSecond));
    } else {
      print(" W:?\n");
    }
    return true;
  }
  if (reports_.busy_interval_s > 0 && handler_.busy_next <= now_) {
    handler_.busy_next += reports_.busy_interval_s * kSecond;
    print("echo:busy: processing\n");
    return true;
  }
  return false;
}

void VirtualController::Firmware::kill(std::string_view words) {
  heaters_.off();
  planner_.clear();
  if (speaks(VirtualDialect::kKlipper)) {
    klipper_shut_down(words);
    return;
  }
  print(words);
  print("Error:Printer halted. kill() called!\n");
  halted_ = true;
  handler_.runs = false;
  slots_.clear();
  receive_.clear();
  wire_.clear();
}

void VirtualController::Firmware::halt(std::string_view words, Instant now) {
  advance(now);
  if (!halted_ && !blocked()) kill(words);
}

void VirtualController::Firmware::say(std::string_view words, Instant now) {
  advance(now);
  LINK_CHECK(words.size() <= 200);
  if (!halted_ && !blocked()) print(words);
}

void VirtualController::Firmware::break_heaters(Instant now) {
  advance(now);
  heaters_.nozzle.break_down();
  heaters_.bed.break_down();
}

}  // namespace firmware_link
