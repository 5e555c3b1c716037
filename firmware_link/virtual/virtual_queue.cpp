// Bytes become lines become command slots, in the order of Marlin's GCodeQueue (bugfix-2.1.x).
#include <algorithm>
#include <charconv>
#include <string>

#include "firmware_link/virtual/virtual_firmware.h"
#include "firmware_link/virtual/virtual_speech.h"  // numbers_lines

namespace firmware_link {
namespace {

// As strtol reads: blanks, a sign, digits; 0 when there are none.
std::int64_t leading_integer(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  std::int32_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

// Reads until a line has ended or nothing is left; false when there was nothing to do.
bool VirtualController::Firmware::read_bytes() {
  bool any = false;
  while (receive_.size() > 0 && !slots_.full()) {
    any = true;
    const char byte = receive_.pop();
    if (!options_.meatpack) {
      if (read_character(byte)) return true;
      continue;
    }
    const MeatUnpacker::Result read = unpacker_.take(static_cast<std::uint8_t>(byte));
    if (read.commanded) print("[MP] PV01 " + std::string(unpacker_.state()) + "\n");
    if (read.refused) {
      print("Error:Serial status mismatch\n");
      receive_.clear();
    }
    bool ended = false;
    for (std::size_t i = 0; i < read.count; ++i)
      ended = read_character(read.characters[i]) || ended;
    if (ended) return true;
  }
  return any;
}

// True when it ends a line.
bool VirtualController::Firmware::read_character(char c) {
  if (c == '\n' || c == '\r') {
    in_comment_ = escaped_ = false;
    end_line();
    return true;
  }
  if (in_comment_) return false;
  if (c == '\\' && !escaped_ && numbers_lines(options_.dialect)) {
    escaped_ = true;
    return false;
  }
  if (c == ';' && !escaped_) {
    in_comment_ = true;
    return false;
  }
  escaped_ = false;
  if (c == '\b' && numbers_lines(options_.dialect)) {  // takes back what is before it
    if (assembling_.size > 0) --assembling_.size;
    return false;
  }
  // What is over 95 characters is dropped without a word, the checksum with it.
  if (assembling_.size < assembling_.bytes.size()) assembling_.bytes[assembling_.size++] = c;
  return false;
}

void VirtualController::Firmware::end_line() {
  Slot slot = assembling_;
  assembling_.size = 0;
  if (!numbers_lines(options_.dialect)) {
    if (plain_line_accepted(slot)) take_slot(slot);
    return;
  }
  if (slot.size == 0) return;
  std::string_view line = slot.line();
  while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
  if (!line.empty() && line.front() == 'N') {
    if (!number_accepted(line)) return;
  } else if (!options_.emergency_parser) {
    // Without a number these act as soon as they are read, before their turn.
    if (line.substr(0, 4) == "M112") {
      kill("echo:M112 Shutdown\n");
      return;
    }
    if (line.substr(0, 4) == "M108") waiting_cancelled_ = true;
    if (line.substr(0, 4) == "M410") {
      if (homing_) {
        print("echo:Homing Failed\nError:Printer halted. kill() called!\n");
        halted_ = true;
        return;
      }
      planner_.clear();
    }
  }
  take_slot(slot);
}

void VirtualController::Firmware::take_slot(const Slot& slot) { slots_.push(slot); }

// Those that number nothing: Klipper takes whatever comes, and reads over number and checksum;
// RepRapFirmware drops a line with a number and a wrong checksum, without a word.
bool VirtualController::Firmware::plain_line_accepted(Slot& slot) const {
  const NumberedText parts = take_apart(slot.line());
  const bool klipper = speaks(VirtualDialect::kKlipper);
  if (!klipper && (parts.text.empty() || (parts.number && !parts.checksum_matches))) return false;
  if (parts.number) {
    const std::string text(parts.text);
    std::copy(text.begin(), text.end(), slot.bytes.begin());
    slot.size = text.size();
  }
  return true;
}

// The number is looked at before the checksum, and the last two numbers are met with silence.
bool VirtualController::Firmware::number_accepted(std::string_view line) {
  std::size_t number_at = 0;
  const bool sets_number = line.find("M110") != std::string_view::npos;
  if (sets_number) {
    const std::size_t second = line.find('N', 4);
    if (second != std::string_view::npos) number_at = second;
  }
  const std::int64_t number = leading_integer(line.substr(number_at + 1));
  if (number != last_number_ + 1 && !sets_number) {
    const bool silent = speaks(VirtualDialect::kMarlin);
    if (silent && number >= last_number_ - 1 && number <= last_number_) return false;
    line_error("Line Number is not Last Line Number+1");
    return false;
  }
  const std::size_t star = line.rfind('*');
  if (star == std::string_view::npos) {
    line_error("No Checksum with line number");
    return false;
  }
  if (leading_integer(line.substr(star + 1)) != checksum_of(line.substr(0, star))) {
    line_error("checksum mismatch");
    return false;
  }
  last_number_ = number;
  return true;
}

void VirtualController::Firmware::line_error(std::string_view what) {
  print("Error:");
  print(what);
  print_format(", Last Line: %lld\n", static_cast<long long>(last_number_));
  flush_and_request_resend();
}

// Drops all that has arrived, in the middle of a line too: its tail then comes without a number.
void VirtualController::Firmware::flush_and_request_resend() {
  receive_.clear();
  ++totals_.resends_asked;
  print_format("Resend: %lld\nok\n", static_cast<long long>(last_number_) + 1);
}

}  // namespace firmware_link
