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
      nozzle_(options.ambient_celsius, options.nozzle_heating_celsius_s, now),
      bed_(options.ambient_celsius, options.bed_heating_celsius_s, now) {
  LINK_CHECK(options_.baud >= 0 && options_.command_cost.count() >= 0);
  LINK_CHECK(options_.acceleration_mm_s2 > 0);
  if (!numbers_lines(options_.dialect) || !options_.busy_lines) busy_interval_s_ = 0;
  planner_.moved = options_.moved;
  print(banner_of(options_.dialect));
  if (speaks(VirtualDialect::kKlipper)) klipper_begin(options_.ready_after);
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
    if (c == '\n' || c == '\r') {
      const std::string_view seen(early_.data(), early_size_ <= early_.size() ? early_size_ : 0);
      early_size_ = 0;
      if (seen == "M108") waiting_cancelled_ = true;
      if (seen == "M112") {
        kill("echo:M112 Shutdown\n");
        return;
      }
    } else if (early_size_ < early_.size()) {
      if (early_size_ != 0 || c != ' ') early_[early_size_++] = c;
    } else {
      early_size_ = early_.size() + 1;  // longer than what acts early
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
  if (handling_ && finish_command()) return true;
  if (!handling_ && !slots_.empty()) {
    begin_command();
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
    nozzle_.advance(now_);
    bed_.advance(now_);
    note_standing();
  }
  note_standing();
  now_ = std::max(now_, now);
  planner_.advance(now_);
  note_standing();
  nozzle_.advance(now_);
  bed_.advance(now_);
}

void VirtualController::Firmware::note_standing() {
  if (!laid_ || halted_ || handling_ || !slots_.empty() || !planner_.empty()) {
    standing_since_.reset();
    return;
  }
  if (!standing_since_) standing_since_ = now_;
  totals_.stood_max = std::max(totals_.stood_max, now_ - *standing_since_);
}

void VirtualController::Firmware::lose_answer(std::string_view word, std::string_view instead) {
  lose_word_ = std::string(word);
  lose_instead_ = std::string(instead);
}

void VirtualController::Firmware::set_last_line(std::int64_t number, Instant now) {
  advance(now);
  last_number_ = number;
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
  if (auto_report_ && !(silent_ && handling_)) take_earlier(next, auto_report_next_);
  if (const auto planner = planner_.next_event()) take_earlier(next, *planner);
  if (const auto klipper = klipper_next()) take_earlier(next, *klipper);
  if (!handling_) return next;
  if (busy_interval_s_ > 0) take_earlier(next, busy_next_);
  switch (waiting_) {
    case Waiting::kNothing:
    case Waiting::kTime:
      take_earlier(next, wait_until_);
      break;
    case Waiting::kNozzle:
    case Waiting::kBed:
      take_earlier(next, heat_report_next_);
      if (within_window_since_) take_earlier(next, *within_window_since_ + kResidency);
      break;
    case Waiting::kPlannerSlot:
    case Waiting::kPlannerEmpty:
      break;
  }
  return next;
}

bool VirtualController::Firmware::owes_answer() const {
  if (klipper_ready_) return true;
  return !halted_ && (wire_.size() > 0 || receive_.size() > 0 || !slots_.empty());
}

void VirtualController::Firmware::reset(Instant now) {
  advance(now);
  forget_all();
  print(banner_of(options_.dialect));
  if (speaks(VirtualDialect::kKlipper)) klipper_begin(options_.ready_after);
}

void VirtualController::Firmware::forget_all() {
  wire_.clear();
  receive_.clear();
  unpacker_ = {};
  assembling_.size = 0;
  in_comment_ = escaped_ = false;
  last_number_ = 0;
  slots_.clear();
  handling_ = laid_ = false;
  waiting_ = Waiting::kNothing;
  homing_ = false;
  pending_blocks_ = 0;
  busy_interval_s_ = numbers_lines(options_.dialect) && options_.busy_lines ? 2 : 0;
  klipper_words_.clear();
  delay_next_ = Duration(0);
  auto_report_.reset();
  halted_ = false;
  planner_.clear();
  pause_was_asked_ = true;
  nozzle_.set_target(0);
  bed_.set_target(0);
  fan_ = 0;
  position_um_ = {};
  homed_ = {};
  e_10nm_ = 0;
  feed_mm_min_ = 1500;
  feed_percent_ = 100;
  relative_ = relative_e_ = false;
  early_size_ = 0;
}

VirtualControllerState VirtualController::Firmware::state() const {
  VirtualControllerState state;
  state.x_mm = static_cast<double>(position_um_[0]) * 1e-3;
  state.y_mm = static_cast<double>(position_um_[1]) * 1e-3;
  state.z_mm = static_cast<double>(position_um_[2]) * 1e-3;
  state.e_mm = static_cast<double>(e_10nm_) * 1e-5;
  state.nozzle_celsius = nozzle_.celsius();
  state.nozzle_target_celsius = nozzle_.target();
  state.bed_celsius = bed_.celsius();
  state.bed_target_celsius = bed_.target();
  state.fan = fan_;
  state.halted = halted_;
  state.last_line = last_number_;
  state.planner_blocks = planner_.count();
  return state;
}

const VirtualControllerTotals& VirtualController::Firmware::totals() {
  totals_.planner_underruns = planner_.underruns();
  totals_.planner_low = planner_.low();
  totals_.planner_blocks_max = planner_.count_max();
  return totals_;
}

void VirtualController::Firmware::print(std::string_view text) {
  // step() begins nothing with less than half the room left, and nothing says as much at once.
  LINK_CHECK(text.size() <= answers_.room());
  for (const char c : text) answers_.push(c);
}

std::string VirtualController::Firmware::temperatures() const {
  HeaterReport report;
  report.nozzle_celsius = nozzle_.celsius();
  report.nozzle_target = nozzle_.target();
  report.nozzle_power = nozzle_.power();
  report.bed_celsius = bed_.celsius();
  report.bed_target = bed_.target();
  report.bed_power = bed_.power();
  return temperatures_of(options_.dialect, report);
}

void VirtualController::Firmware::print_temperatures() { print(temperatures()); }

// Says what is due by the clock.
bool VirtualController::Firmware::report() {
  if (auto_report_ && !(silent_ && handling_) && auto_report_next_ <= now_) {
    auto_report_next_ += *auto_report_;
    print_temperatures();
    print("\n");
    return true;
  }
  if (!handling_) return false;
  const bool heating = waiting_ == Waiting::kNozzle || waiting_ == Waiting::kBed;
  if (heating && heat_report_next_ <= now_) {
    heat_report_next_ += kSecond;
    (void)heated(waiting_ == Waiting::kNozzle ? nozzle_ : bed_);
    if (speaks(VirtualDialect::kRepRap)) return true;  // it waits in silence
    if (speaks(VirtualDialect::kKlipper)) {
      print(temperatures().substr(1) + "\n");
      return true;
    }
    print_temperatures();
    if (within_window_since_) {
      const Duration rest = std::max(Duration(0), *within_window_since_ + kResidency - now_);
      print_format(" W:%d\n", static_cast<int>(rest / kSecond));
    } else {
      print(" W:?\n");
    }
    return true;
  }
  if (busy_interval_s_ > 0 && busy_next_ <= now_) {
    busy_next_ += busy_interval_s_ * kSecond;
    print("echo:busy: processing\n");
    return true;
  }
  return false;
}

void VirtualController::Firmware::kill(std::string_view words) {
  nozzle_.set_target(0);
  bed_.set_target(0);
  planner_.clear();
  if (speaks(VirtualDialect::kKlipper)) {
    klipper_shut_down(words);
    return;
  }
  print(words);
  print("Error:Printer halted. kill() called!\n");
  halted_ = true;
  handling_ = false;
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
  nozzle_.break_down();
  bed_.break_down();
}

}  // namespace firmware_link
