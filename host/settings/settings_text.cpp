#include "host/settings/settings_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "host/system/text.h"  // lower_case, trimmed

namespace host {
namespace {

core::Error bad(std::string message) { return {core::ErrorCode::kBadSetting, std::move(message)}; }

std::string_view without_sign(std::string_view text) {
  // from_chars takes "-" but not "+"; "+-1" stays an error.
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

// Conditions that stand in the comment ("; up{endif}") stay.
std::string without_comment(std::string_view line) {
  const std::size_t start = std::min(line.find(';'), line.size());
  std::string kept(line.substr(0, start));
  for (std::size_t at = line.find('{', start); at < line.size(); at = line.find('{', at + 1)) {
    const std::size_t end = line.find('}', at);
    if (end == std::string_view::npos) break;
    const std::string_view all = line.substr(at, end + 1 - at);
    const std::string_view content = trimmed(all.substr(1));
    const bool keep = content.starts_with("if ") || content.starts_with("elsif ") ||
                      content == "else}" || content == "endif}";
    if (keep) kept += all;
  }
  return kept;
}

}  // namespace

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
    return bad(fmt::format("read \"{}\" as a number, but \"{}\" follows{}", whole.substr(0, length),
                           rest, rest.starts_with(',') ? " (decimals follow a point)" : ""));
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
  const std::string word = lower_case(trimmed(text));
  for (const char* yes : {"1", "true", "yes", "on"}) {
    if (word == yes) return true;
  }
  for (const char* no : {"0", "false", "no", "off"}) {
    if (word == no) return false;
  }
  return bad(fmt::format("\"{}\" is neither 1 nor 0 (nor true/false, yes/no, on/off)", word));
}

// "\n" and "\r" end a line; any other character after a backslash is that character.
std::vector<std::string> unescaped_lines(std::string_view text) {
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

bool is_printable(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

core::Result<std::vector<std::string>> sendable_lines(const std::vector<std::string>& lines) {
  std::vector<std::string> sent;
  for (const std::string& raw : lines) {
    const std::string text = without_comment(raw);
    const std::string_view line = trimmed(text);
    if (line.empty()) continue;
    const bool filled_in = line.find_first_of("{[") == std::string_view::npos;
    const std::size_t most = filled_in ? kVerbatimBytesMax : kPlaceholderLineBytesMax;
    if (line.size() > most) {
      return bad(fmt::format("line \"{}…\" has {} bytes, a controller takes {}", line.substr(0, 20),
                             line.size(), most));
    }
    if (!is_printable(line)) {
      return bad(
          fmt::format("line {} holds characters that are not printable ASCII", sent.size() + 1));
    }
    if (sent.size() == kVerbatimLinesMax) {
      return bad(fmt::format("more than {} lines", kVerbatimLinesMax));
    }
    sent.emplace_back(line);
  }
  return sent;
}

core::Result<std::vector<std::string>> read_lines(std::string_view text) {
  return sendable_lines(unescaped_lines(text));
}

std::string write_number(double number) {
  // No powers of ten for users, except for numbers with more than 16 digits.
  const double size = std::abs(number);
  const bool plain = size == 0 || (size >= 1e-6 && size < 1e16);
  std::array<char, 40> buffer{};
  const auto [end, code] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                    plain ? std::chars_format::fixed : std::chars_format::general);
  RIND_CHECK(code == std::errc());
  return {buffer.data(), end};
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\r') continue;
    if (c == '\\') result += '\\';
    result += c == '\n' ? std::string_view("\\n") : std::string_view(&c, 1);
  }
  return result;
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
