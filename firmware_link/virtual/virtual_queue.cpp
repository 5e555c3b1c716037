// Bytes become lines become command slots, in the order of Marlin's GCodeQueue (bugfix-2.1.x).
#include <algorithm>
#include <charconv>
#include <string>

#include "firmware_link/virtual/virtual_firmware.h"
#include "firmware_link/virtual/virtual_speech.h"  // numbers_lines

namespace firmware_link {
// Reads until a line has ended or nothing is left; false when there was nothing to do.
bool VirtualController::Firmware::read_bytes() {
  bool any = false;
  while (receive_.size() > 0 && !slots_.full()) {
    any = true;
    const char byte = receive_.pop();
    if (!options_.meatpack) {
      if (reader_.read(byte)) {
        take_line(reader_.take());
        return true;
      }
      continue;
    }
    const MeatUnpacker::Result read = unpacker_.take(static_cast<std::uint8_t>(byte));
    if (read.commanded) print("[MP] PV01 " + std::string(unpacker_.state()) + "\n");
    if (read.refused) {
      print("Error:Serial status mismatch\n");
      receive_.clear();
    }
    bool ended = false;
    for (std::size_t i = 0; i < read.count; ++i) {
      if (!reader_.read(read.characters[i])) continue;
      take_line(reader_.take());
      ended = true;
    }
    if (ended) return true;
  }
  return any;
}

void VirtualController::Firmware::take_line(VirtualLine line) {
  if (!numbers_lines(options_.dialect)) {
    if (plain_line_accepted(line)) slots_.push(line);
    return;
  }
  if (line.size == 0) return;
  std::string_view text = line.text();
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  const bool numbered = !text.empty() && text.front() == 'N';
  if (numbered ? numbered_line_accepted(text) : unnumbered_line_accepted(text)) slots_.push(line);
}

// Without a number these act as soon as they are read, before their turn.
bool VirtualController::Firmware::unnumbered_line_accepted(std::string_view text) {
  if (options_.emergency_parser) return true;
  if (text.substr(0, 4) == "M112") {
    kill("echo:M112 Shutdown\n");
    return false;
  }
  if (text.substr(0, 4) == "M108") handler_.cancelled = true;
  if (text.substr(0, 4) == "M410") {
    if (handler_.homes) {
      print("echo:Homing Failed\nError:Printer halted. kill() called!\n");
      halted_ = true;
      return false;
    }
    planner_.clear();
  }
  return true;
}

bool VirtualController::Firmware::numbered_line_accepted(std::string_view text) {
  using Verdict = VirtualLineNumbers::Verdict;
  const Verdict verdict = numbers_.check(text, speaks(VirtualDialect::kMarlin));
  if (verdict == Verdict::kAccepted) return true;
  if (verdict == Verdict::kSilent) return false;
  print("Error:");
  print(words_of(verdict));
  print_format(", Last Line: %lld\n", static_cast<long long>(numbers_.last()));
  flush_and_request_resend();
  return false;
}

// Those that number nothing: Klipper takes whatever comes, and reads over number and checksum;
// RepRapFirmware drops a line with a number and a wrong checksum, without a word.
bool VirtualController::Firmware::plain_line_accepted(VirtualLine& line) const {
  const NumberedText parts = take_apart(line.text());
  const bool klipper = speaks(VirtualDialect::kKlipper);
  if (!klipper && (parts.text.empty() || (parts.number && !parts.checksum_matches))) return false;
  if (parts.number) {
    const std::string text(parts.text);
    std::copy(text.begin(), text.end(), line.bytes.begin());
    line.size = text.size();
  }
  return true;
}

// Drops all that has arrived, in the middle of a line too: its tail then comes without a number.
void VirtualController::Firmware::flush_and_request_resend() {
  receive_.clear();
  ++totals_.resends_asked;
  print_format("Resend: %lld\nok\n", static_cast<long long>(numbers_.last()) + 1);
}

}  // namespace firmware_link
