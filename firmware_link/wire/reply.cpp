#include "firmware_link/wire/reply.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

namespace firmware_link {
namespace {

bool take_prefix(std::string_view& line, std::string_view prefix) {
  if (line.substr(0, prefix.size()) != prefix) return false;
  line.remove_prefix(prefix.size());
  return true;
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_letter(char a, char b) { return lower(a) == lower(b); }

// As take_prefix(), in any case of letters: "Error:", "error:", "ERROR:" are all said.
bool take_prefix_any_case(std::string_view& line, std::string_view prefix) {
  if (line.size() < prefix.size() ||
      !std::equal(prefix.begin(), prefix.end(), line.begin(), same_letter)) {
    return false;
  }
  line.remove_prefix(prefix.size());
  return true;
}

bool holds_any_case(std::string_view text, std::string_view words) {
  return std::search(text.begin(), text.end(), words.begin(), words.end(), same_letter) !=
         text.end();
}

// What a controller says only when it has stopped by itself, whatever stands before it.
bool says_stopped(std::string_view text) {
  constexpr std::string_view kFinal[] = {"printer halted",    "kill() called",
                                         "thermal runaway",   "heating failed",
                                         "mintemp triggered", "maxtemp triggered"};
  return std::any_of(std::begin(kFinal), std::end(kFinal),
                     [&](std::string_view words) { return holds_any_case(text, words); });
}

std::string_view without_leading_blanks(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  return text;
}

template <typename Number>
std::optional<Number> leading_number(std::string_view text) {
  text = without_leading_blanks(text);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  if constexpr (std::is_floating_point_v<Number>) {
    if (!std::isfinite(value)) return std::nullopt;
  }
  return value;
}

// The number right behind `key` where that starts a word: "T:" is found in " T:25" but not in
// "BT:".
template <typename Number>
std::optional<Number> number_behind(std::string_view text, std::string_view key,
                                    std::string_view* rest = nullptr) {
  for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
    if (at > 0 && text[at - 1] != ' ') continue;
    const std::string_view behind = text.substr(at + key.size());
    if (rest != nullptr) *rest = behind;
    return leading_number<Number>(behind);
  }
  return std::nullopt;
}

// "25.45 /0.00": the second number is the target.
std::optional<double> target_in(std::string_view reading) {
  const std::size_t blank = reading.find(' ');
  if (blank == std::string_view::npos) return std::nullopt;
  const std::string_view behind = without_leading_blanks(reading.substr(blank));
  if (behind.empty() || behind.front() != '/') return std::nullopt;
  return leading_number<double>(behind.substr(1));
}

Temperatures read_temperatures(std::string_view text) {
  Temperatures read;
  std::string_view reading;
  read.nozzle_celsius = number_behind<double>(text, "T:", &reading);
  if (!read.nozzle_celsius) read.nozzle_celsius = number_behind<double>(text, "T0:", &reading);
  if (read.nozzle_celsius) read.nozzle_target_celsius = target_in(reading);
  read.bed_celsius = number_behind<double>(text, "B:", &reading);
  if (read.bed_celsius) read.bed_target_celsius = target_in(reading);
  return read;
}

std::size_t decimals_of(std::string_view number) {
  const std::size_t end = std::min(number.find(' '), number.size());
  const std::size_t point = number.substr(0, end).find('.');
  return point == std::string_view::npos ? 0 : end - point - 1;
}

// The first of each: behind "Count" they come again, in steps. Nothing where they don't all have as
// many decimals: then a digit got lost on the way.
std::optional<Position> read_position(std::string_view text) {
  text = text.substr(0, text.find("Count"));
  Position read;
  std::optional<std::size_t> decimals;
  bool alike = true;
  const auto number = [&](std::string_view key) {
    std::string_view behind;
    const auto value = number_behind<double>(text, key, &behind);
    if (!value) return value;
    alike = alike && decimals.value_or(decimals_of(behind)) == decimals_of(behind);
    decimals = decimals_of(behind);
    return value;
  };
  read.x_mm = number("X:");
  read.y_mm = number("Y:");
  read.z_mm = number("Z:");
  read.e_mm = number("E:");
  if (!alike) return std::nullopt;
  return read;
}

Reply plain(Reply::Kind kind, std::string_view text) {
  Reply reply;
  reply.kind = kind;
  reply.text = text;
  return reply;
}

Reply read_ok(std::string_view rest) {
  Reply reply;
  reply.kind = Reply::Kind::kOk;
  reply.text = without_leading_blanks(rest);
  reply.number = number_behind<std::int64_t>(rest, "N");
  reply.planner_free = number_behind<std::int32_t>(rest, "P");
  reply.slots_free = number_behind<std::int32_t>(rest, "B");
  reply.temperatures = read_temperatures(rest);
  return reply;
}

Reply read_error(std::string_view text) {
  Reply reply;
  reply.kind = Reply::Kind::kError;
  reply.text = without_leading_blanks(text);
  constexpr std::string_view kFinal[] = {"stop called", "mintemp", "maxtemp"};
  for (const std::string_view words : kFinal) {
    if (holds_any_case(reply.text, words)) reply.kind = Reply::Kind::kHalted;
  }
  if (says_stopped(reply.text)) reply.kind = Reply::Kind::kHalted;
  return reply;
}

Reply read_echo(std::string_view text) {
  text = without_leading_blanks(text);
  if (take_prefix(text, "busy:")) return plain(Reply::Kind::kBusy, text);
  if (take_prefix(text, "Unknown command:")) {
    return plain(Reply::Kind::kUnknownCommand, without_leading_blanks(text));
  }
  return plain(says_stopped(text) ? Reply::Kind::kHalted : Reply::Kind::kEcho, text);
}

// "ok" and "okay" are different words.
bool ends_word(std::string_view rest) {
  return rest.empty() || rest.front() == ' ' || rest.front() == '\t';
}

}  // namespace

Reply read_reply(std::string_view line) {
  using Kind = Reply::Kind;
  while (!line.empty() && (line.back() == '\r' || line.back() == '\n')) line.remove_suffix(1);
  line = without_leading_blanks(line);
  std::string_view rest = line;
  if (take_prefix(rest, "ok") && ends_word(rest)) return read_ok(rest);
  rest = line;
  if (take_prefix(rest, "Resend:") || take_prefix(rest, "rs ")) {
    // A number that doesn't read asks for nothing that could be sent.
    // "rs N12" is said too.
    rest = without_leading_blanks(rest);
    (void)take_prefix(rest, "N");
    Reply reply = plain(Kind::kResend, rest);
    reply.number = leading_number<std::int64_t>(rest);
    return reply;
  }
  if (take_prefix_any_case(rest, "error:")) return read_error(rest);
  // Repetier, and then nothing is obeyed until M999.
  if (take_prefix_any_case(rest, "fatal:")) {
    return plain(Kind::kHalted, without_leading_blanks(rest));
  }
  if (take_prefix(rest, "echo:")) return read_echo(rest);
  if (rest == "start") return plain(Kind::kStart, rest);
  if (rest == "wait") return plain(Kind::kWait, rest);
  if (take_prefix(rest, "!!")) return plain(Kind::kAlarm, without_leading_blanks(rest));
  if (take_prefix(rest, "//")) {
    rest = without_leading_blanks(rest);
    if (take_prefix(rest, "action:")) return plain(Kind::kAction, rest);
    return plain(Kind::kNote, rest);
  }
  if (take_prefix(rest, "FIRMWARE_NAME:")) return plain(Kind::kFirmwareName, rest);
  if (take_prefix(rest, "Cap:")) return plain(Kind::kCapability, rest);
  const std::string_view head = rest.substr(0, 3);
  if (head.substr(0, 2) == "T:" || head == "T0:" || head.substr(0, 2) == "B:") {
    Reply reply = plain(Kind::kTemperatures, rest);
    reply.temperatures = read_temperatures(rest);
    return reply;
  }
  if (head.substr(0, 2) == "X:") {
    const std::optional<Position> position = read_position(rest);
    if (!position) return plain(Kind::kUnknown, rest);
    Reply reply = plain(Kind::kPosition, rest);
    reply.position = *position;
    return reply;
  }
  return plain(says_stopped(rest) ? Kind::kHalted : Kind::kUnknown, rest);
}

std::size_t LineSplitter::take(std::span<const std::byte> bytes) {
  if (complete_) {
    size_ = 0;
    complete_ = false;
    cutting_ = false;
  }
  std::size_t taken = 0;
  while (taken < bytes.size()) {
    const char c = static_cast<char>(bytes[taken++]);
    if (c == '\n' || c == '\r') {
      if (size_ == 0) continue;
      complete_ = true;
      break;
    }
    if (size_ < bytes_.size()) {
      bytes_[size_++] = c;
    } else if (!cutting_) {
      cutting_ = true;
      ++lines_cut_;
    }
  }
  return taken;
}

std::optional<std::string_view> LineSplitter::line() const {
  if (!complete_) return std::nullopt;
  return std::string_view(bytes_.data(), size_);
}

}  // namespace firmware_link
