#include "host/gcode/gcode_kind.h"

#include <array>
#include <cstddef>
#include <string_view>

#include "host/system/text.h"  // is_digit

namespace host {
namespace {

// Enough for most files, without waiting long for a pipe; then all that a window holds, for files
// that start with pictures in comments.
constexpr std::array<std::size_t, 3> kLookBytes{134, 4'096, InputFile::kWindowMax};

enum class Verdict { kYes, kNo, kMoreNeeded };

std::string_view without_blanks(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string_view() : line.substr(first);
}

bool is_classic_line(std::string_view line) {
  constexpr std::string_view kLetters = "GMTNgmtn";
  return line.size() >= 2 && kLetters.find(line[0]) != std::string_view::npos && is_digit(line[1]);
}

// "START_PRINT BED=60"
bool is_macro_line(std::string_view line) {
  std::size_t size = 0;
  while (size < line.size() &&
         ((line[size] >= 'A' && line[size] <= 'Z') || line[size] == '_' || is_digit(line[size]))) {
    ++size;
  }
  return size >= 3 && !is_digit(line[0]) && (size == line.size() || line[size] == ' ');
}

// `whole`: no more bytes can be had.
Verdict verdict_of(std::string_view bytes, bool whole) {
  if (bytes.find('\0') != std::string_view::npos) return Verdict::kNo;
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  while (!bytes.empty()) {
    const std::size_t end = bytes.find_first_of("\r\n");
    if (end == std::string_view::npos && !whole) break;
    const std::string_view line = without_blanks(bytes.substr(0, end));
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
    if (line.empty() || line[0] == ';' || line == "%") continue;
    if (is_classic_line(line)) return Verdict::kYes;
    if (!is_macro_line(line)) return Verdict::kNo;
  }
  return Verdict::kMoreNeeded;
}

}  // namespace

core::Result<std::optional<GcodeKind>> gcode_kind(InputFile& file) {
  for (const std::size_t count : kLookBytes) {
    const core::Result<std::string_view> window = file.window(count);
    if (!window.ok()) return window.error();
    const std::string_view bytes = window.value();
    if (bytes.starts_with("GCDE")) return std::optional(GcodeKind::kBinary);
    const bool ended = bytes.size() < count;
    switch (verdict_of(bytes, ended)) {
      case Verdict::kYes:
        return std::optional(GcodeKind::kText);
      case Verdict::kNo:
        return std::optional<GcodeKind>();
      case Verdict::kMoreNeeded:
        break;
    }
    if (ended) return std::optional<GcodeKind>();
    // No other kind of part starts with so many such comments.
    if (count == kLookBytes.back() && without_blanks(bytes).starts_with(';')) {
      return std::optional(GcodeKind::kText);
    }
  }
  return std::optional<GcodeKind>();
}

}  // namespace host
