#include "firmware_link/wire/line_codec.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>

#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

static_assert(kMoveBytesMax <= kTextBytesMax);
static_assert(kArcBytesMax <= kTextBytesMax);
static_assert(kSetTemperatureBytesMax <= kTextBytesMax);
static_assert(kSetFanBytesMax <= kTextBytesMax);
static_assert(kSetAccelerationBytesMax <= kTextBytesMax);
static_assert(kSetPressureAdvanceBytesMax <= kTextBytesMax);
// "-9999999.999" and "-9999999.99999" are what the bounds allow.
static_assert(kPositionUmMax == 9'999'999'999 && kFilament10nmMax == 999'999'999'999);
static_assert(kArcCentreUmMax == 9'999'999);  // "-9999.999"

constexpr std::array<std::uint64_t, 10> kPowers = {
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000, 1'000'000'000};

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }

bool is_move(std::string_view text) {
  return text.size() > 3 && text[0] == 'G' && text[1] >= '0' && text[1] <= '3' &&
         (text[2] == ' ' || is_letter(text[2]));
}

class TextWriter {
 public:
  explicit TextWriter(TextBuffer& into) : start_(into.data()), at_(into.data()) {}

  void literal(std::string_view text) {
    LINK_CHECK(size() + text.size() <= kTextBytesMax);
    std::memcpy(at_, text.data(), text.size());
    at_ += text.size();
  }

  void word(char letter, std::int64_t value, int decimals) {
    std::array<char, 2 + 21> part{' ', letter};
    const char* end = write_fixed(part.data() + 2, value, decimals);
    literal({part.data(), static_cast<std::size_t>(end - part.data())});
  }

  [[nodiscard]] std::string_view text() const { return {start_, size()}; }

 private:
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(at_ - start_); }

  char* start_;
  char* at_;
};

bool within(const std::optional<std::int64_t>& value, std::int64_t limit) {
  return !value || (*value >= -limit && *value <= limit);
}

void check_arc(const Move& move) {
  const Arc& arc = *move.arc;
  LINK_CHECK(within(arc.i_um, kArcCentreUmMax) && within(arc.j_um, kArcCentreUmMax));
  LINK_CHECK((arc.i_um != 0 || arc.j_um != 0) && (move.x_um || move.y_um));
  LINK_CHECK(move.extruding && !move.z_um);
}

void write_command(TextWriter& writer, const Move& move) {
  LINK_CHECK(within(move.x_um, kPositionUmMax) && within(move.y_um, kPositionUmMax) &&
             within(move.z_um, kPositionUmMax));
  LINK_CHECK(within(move.e_10nm, kFilament10nmMax));
  LINK_CHECK(!move.f_mm_min || (*move.f_mm_min >= 0 && *move.f_mm_min <= kFeedMmMinMax));
  if (move.arc) check_arc(move);
  writer.literal(move.arc ? (move.arc->clockwise ? "G2" : "G3") : move.extruding ? "G1" : "G0");
  if (move.x_um) writer.word('X', *move.x_um, 3);
  if (move.y_um) writer.word('Y', *move.y_um, 3);
  if (move.z_um) writer.word('Z', *move.z_um, 3);
  if (move.arc && move.arc->i_um != 0) writer.word('I', move.arc->i_um, 3);
  if (move.arc && move.arc->j_um != 0) writer.word('J', move.arc->j_um, 3);
  if (move.e_10nm) writer.word('E', *move.e_10nm, 5);
  if (move.f_mm_min) writer.word('F', *move.f_mm_min, 0);
}

void write_command(TextWriter& writer, const SetTemperature& set) {
  LINK_CHECK(set.celsius_tenths >= 0 && set.celsius_tenths <= 9999);
  const bool nozzle = set.heater == Heater::kNozzle;
  writer.literal(nozzle ? (set.wait ? "M109" : "M104") : (set.wait ? "M190" : "M140"));
  writer.word('S', set.celsius_tenths, 1);
}

void write_command(TextWriter& writer, const SetFan& set) {
  if (set.power == 0) {
    writer.literal("M107");
  } else {
    writer.literal("M106");
    writer.word('S', set.power, 0);
  }
}

// Klipper has one acceleration for all moves, RepRapFirmware one for printing and one for travel.
// Marlin has both, and reads either form.
void write_command(TextWriter& writer, const SetAcceleration& set) {
  LINK_CHECK(set.mm_s2 > 0);
  writer.literal("M204");
  if (set.flavor == Flavor::kRepRapFirmware) {
    writer.word('P', set.mm_s2, 0);
    writer.word('T', set.mm_s2, 0);
  } else {
    writer.word('S', set.mm_s2, 0);
  }
}

void write_command(TextWriter& writer, const SetPressureAdvance& set) {
  LINK_CHECK(set.tens_us >= 0);
  switch (set.flavor) {
    case Flavor::kMarlin:
      writer.literal("M900");
      return writer.word('K', set.tens_us, 5);
    case Flavor::kKlipper: {
      writer.literal("SET_PRESSURE_ADVANCE ADVANCE=");
      std::array<char, 21> number{};
      const char* end = write_fixed(number.data(), set.tens_us, 5);
      return writer.literal({number.data(), static_cast<std::size_t>(end - number.data())});
    }
    case Flavor::kRepRapFirmware:
      writer.literal("M572 D0");
      return writer.word('S', set.tens_us, 5);
  }
}

void write_command(TextWriter& writer, const Verbatim& verbatim) {
  writer.literal(verbatim.text());
}

void write_command(TextWriter& writer, const ReadyLine& ready) {
  writer.literal(ready.words.text());
}

// Digits of a decimal number, a power of ten at a time; stops at the first that is none.
std::int64_t read_fixed(std::string_view text, int decimals) {
  std::size_t i = 0;
  const bool negative = i < text.size() && text[i] == '-';
  if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
  constexpr std::int64_t kLimit = 1'000'000'000'000'000;
  std::int64_t value = 0;
  int taken = 0;
  bool point = false;
  for (; i < text.size() && value < kLimit; ++i) {
    if (text[i] == '.' && !point) {
      point = true;
    } else if (text[i] >= '0' && text[i] <= '9') {
      const std::int64_t digit = text[i] - '0';
      if (point && taken == decimals) {
        value += digit >= 5 ? 1 : 0;
        break;
      }
      value = value * 10 + digit;
      taken += point ? 1 : 0;
    } else {
      break;
    }
  }
  for (; taken < decimals && value < kLimit; ++taken) value *= 10;
  return negative ? -value : value;
}

std::optional<std::int64_t> read_integer(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end == text.data()) return std::nullopt;
  return value;
}

}  // namespace

char* write_fixed(char* at, std::int64_t value, int decimals) {
  LINK_CHECK(decimals >= 0 && decimals <= 9);
  // Through unsigned, because the lowest int64 has no positive twin.
  std::uint64_t magnitude = static_cast<std::uint64_t>(value);
  if (value < 0) {
    magnitude = 0 - magnitude;
    *at++ = '-';
  }
  const std::uint64_t power = kPowers[static_cast<std::size_t>(decimals)];
  const std::uint64_t whole = magnitude / power;
  std::uint64_t part = magnitude - whole * power;
  at = std::to_chars(at, at + 20, whole).ptr;
  if (part == 0) return at;
  while (part % 10 == 0) {
    part /= 10;
    --decimals;
  }
  *at++ = '.';
  for (char* digit = at + decimals; digit > at; part /= 10) {
    *--digit = static_cast<char>('0' + part % 10);
  }
  return at + decimals;
}

std::string_view encode(const Command& command, TextBuffer& into) {
  TextWriter writer(into);
  std::visit([&writer](const auto& kind) { write_command(writer, kind); }, command);
  LINK_CHECK(writer.text().size() <= kTextBytesMax && !writer.text().empty());
  return writer.text();
}

std::string_view shortened(std::string_view text, TextBuffer& into) {
  LINK_CHECK(text.size() <= into.size());
  if (!is_move(text) || text[2] != ' ') return text;
  std::size_t size = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    if (text[i] == ' ' && next != 'E') continue;
    const char before = i > 0 ? text[i - 1] : '\0';
    const bool starts_number = is_letter(before) || before == '-';
    if (text[i] == '0' && next == '.' && starts_number) continue;
    into[size++] = text[i];
  }
  return {into.data(), size};
}

std::string_view spelled_out(std::string_view text, SpelledBuffer& into) {
  if (!is_move(text) || text.size() > kLineBytesMax) return text;
  std::size_t size = 0;
  // At most two characters for each of the text's.
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char before = i > 0 ? text[i - 1] : ' ';
    if (is_letter(text[i]) && before != ' ') into[size++] = ' ';
    if (text[i] == '.' && (is_letter(before) || before == '-')) into[size++] = '0';
    into[size++] = text[i];
  }
  return {into.data(), size};
}

std::uint8_t checksum_of(std::string_view bytes) {
  std::uint8_t sum = 0;
  for (const char c : bytes) sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
  return sum;
}

std::string_view number_line(std::int32_t number, std::string_view text, LineBuffer& into) {
  LINK_CHECK(number >= 0 && number <= kResyncLineNumber);
  LINK_CHECK(text.size() <= kTextBytesMax);
  char* const start = into.data();
  char* const limit = start + into.size();
  char* at = start;
  *at++ = 'N';
  at = std::to_chars(at, limit, number).ptr;
  std::memcpy(at, text.data(), text.size());
  at += text.size();
  const std::uint8_t sum = checksum_of({start, static_cast<std::size_t>(at - start)});
  *at++ = '*';
  const auto [end, error] = std::to_chars(at, limit, sum);
  LINK_CHECK(error == std::errc{});
  return {start, static_cast<std::size_t>(end - start)};
}

NumberedText take_apart(std::string_view line) {
  NumberedText parts;
  parts.text = line;
  const std::size_t star = line.rfind('*');
  if (star != std::string_view::npos) {
    parts.checksum = read_integer(line.substr(star + 1));
    parts.checksum_matches = parts.checksum && *parts.checksum == checksum_of(line.substr(0, star));
    parts.text = line.substr(0, star);
  }
  if (!parts.text.empty() && parts.text.front() == 'N') {
    std::size_t end = 1;
    if (end < parts.text.size() && parts.text[end] == '-') ++end;
    while (end < parts.text.size() && parts.text[end] >= '0' && parts.text[end] <= '9') ++end;
    parts.number = read_integer(parts.text.substr(1, end - 1));
    if (parts.number) parts.text.remove_prefix(end);
  }
  parts.text = trim(parts.text);
  return parts;
}

std::optional<std::int64_t> word(std::string_view text, char letter, int decimals) {
  LINK_CHECK(decimals >= 0 && decimals <= 9);
  // The command word: a letter and its number.
  std::size_t i = text.empty() ? 0 : 1;
  while (i < text.size() && ((text[i] >= '0' && text[i] <= '9') || text[i] == '.')) ++i;
  const std::size_t at = text.find(letter, i);
  if (at == std::string_view::npos) return std::nullopt;
  return read_fixed(text.substr(at + 1), decimals);
}

}  // namespace firmware_link
