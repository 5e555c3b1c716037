#include "host/settings/settings_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace host {
namespace {

core::Error bad(std::string message) { return {core::ErrorCode::kBadSetting, std::move(message)}; }

std::string_view without_sign(std::string_view text) {
  // from_chars takes "-" but not "+"; "+-1" stays an error.
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

// "\n" and "\r" end a line; what else stands behind a backslash stands for itself.
std::vector<std::string> split_escaped(std::string_view text) {
  std::vector<std::string> lines(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '\\' && i + 1 < text.size();
    const char c = escape ? text[++i] : text[i];
    if (c == '\n' || c == '\r' || (escape && (c == 'n' || c == 'r'))) {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

// "N12 G1 X0" or "M110": the link counts lines, nobody else.
bool numbers_lines(std::string_view line) {
  const auto digit_at = [&](std::size_t i) {
    return i < line.size() && std::isdigit(static_cast<unsigned char>(line[i])) != 0;
  };
  const std::string start = lower(line.substr(0, 4));
  return (start.starts_with('n') && digit_at(1)) || (start == "m110" && !digit_at(4));
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n\v\f";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) + 1 - first);
}

core::Result<double> read_number(std::string_view text, std::string_view unit) {
  const std::string_view whole = without_sign(trimmed(text));
  if (whole.empty()) return bad("a number is missing");
  double value = 0;
  const auto [stop, code] = std::from_chars(whole.data(), whole.data() + whole.size(), value);
  if (code == std::errc::result_out_of_range) {
    return bad(fmt::format("\"{}\" is beyond what a number can hold", whole));
  }
  if (code != std::errc()) return bad(fmt::format("\"{}\" is not a number", whole));
  const auto length = static_cast<std::size_t>(stop - whole.data());
  const std::string_view rest = trimmed(whole.substr(length));
  const bool percent = unit == "%" && rest == "%";
  if (!rest.empty() && rest != unit) {
    return bad(fmt::format("read \"{}\" as a number and could not go on at \"{}\"{}",
                           whole.substr(0, length), rest,
                           rest.starts_with(',') ? " (decimals follow a point)" : ""));
  }
  if (!std::isfinite(value)) return bad(fmt::format("\"{}\" is not a finite number", whole));
  return percent ? value / 100 : value;
}

core::Result<std::int64_t> read_whole_number(std::string_view text) {
  const std::string_view whole = without_sign(trimmed(text));
  if (whole.empty()) return bad("a whole number is missing");
  std::int64_t value = 0;
  const auto [stop, code] = std::from_chars(whole.data(), whole.data() + whole.size(), value);
  if (code == std::errc::result_out_of_range) {
    return bad(fmt::format("\"{}\" is beyond what a whole number can hold", whole));
  }
  if (code != std::errc() || stop != whole.data() + whole.size()) {
    return bad(fmt::format("\"{}\" is not a whole number", whole));
  }
  return value;
}

core::Result<bool> read_switch(std::string_view text) {
  const std::string word = lower(trimmed(text));
  for (const char* yes : {"1", "true", "yes", "on"}) {
    if (word == yes) return true;
  }
  for (const char* no : {"0", "false", "no", "off"}) {
    if (word == no) return false;
  }
  return bad(fmt::format("\"{}\" is neither 1 nor 0 (nor true/false, yes/no, on/off)", word));
}

core::Result<std::vector<std::string>> read_lines(std::string_view text) {
  std::vector<std::string> lines;
  for (const std::string& raw : split_escaped(text)) {
    const std::string_view line = trimmed(std::string_view(raw).substr(0, raw.find(';')));
    if (line.empty()) continue;
    if (line.size() > kVerbatimBytesMax) {
      return bad(fmt::format("line \"{}…\" has {} bytes, a controller takes {}", line.substr(0, 20),
                             line.size(), kVerbatimBytesMax));
    }
    if (!std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' && c <= '~'; })) {
      return bad(
          fmt::format("line {} holds characters that are not printable ASCII", lines.size() + 1));
    }
    if (numbers_lines(line)) {
      return bad(fmt::format("line \"{}\" sets a line number, which the link does itself", line));
    }
    if (lines.size() == kVerbatimLinesMax) {
      return bad(fmt::format("more than {} lines", kVerbatimLinesMax));
    }
    lines.emplace_back(line);
  }
  return lines;
}

std::string write_number(double number) {
  // Users don't think in powers of ten; only numbers of more than 16 digits are written so.
  const double size = std::abs(number);
  const bool plain = size == 0 || (size >= 1e-6 && size < 1e16);
  std::array<char, 40> buffer{};
  const auto [end, code] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                    plain ? std::chars_format::fixed : std::chars_format::general);
  RIND_CHECK(code == std::errc());
  return {buffer.data(), end};
}

std::string write_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i != 0) text += "\\n";
    for (const char c : lines[i]) {
      if (c == '\\') text += '\\';
      text += c;
    }
  }
  return text;
}

}  // namespace host
