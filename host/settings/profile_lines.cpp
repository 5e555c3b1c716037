#include "host/settings/profile_lines.h"

#include <fmt/format.h>
#include <ini.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "host/system/text.h"  // trimmed

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

// The text that inih reads, and the lines that it returns.
struct Reader {
  std::string_view rest;
  std::string name;
  int line_number = 0;
  bool at_line_start = true;
  std::string section;
  std::vector<ProfileLine> lines;
};

// inih cuts the names of sections at 50 bytes.
void note_section(std::string_view line, Reader& reader) {
  if (line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
  line = trimmed(line);
  const std::size_t end = line.find(']');
  if (line.starts_with('[') && end != std::string_view::npos) {
    reader.section = trimmed(line.substr(1, end - 1));
  }
}

// Like fgets: reads up to `size` - 1 characters, at most to the end of the line. Also counts lines,
// because inih does not pass its own count to the handler.
char* read_piece(char* into, int size, void* stream) {
  Reader& reader = *static_cast<Reader*>(stream);
  if (reader.rest.empty() || size <= 1) return nullptr;
  const std::size_t line_end = reader.rest.find('\n');
  const std::size_t line = line_end == std::string_view::npos ? reader.rest.size() : line_end + 1;
  if (reader.at_line_start) {
    ++reader.line_number;
    note_section(reader.rest.substr(0, line), reader);
  }
  const std::size_t length = std::min(line, static_cast<std::size_t>(size - 1));
  std::memcpy(into, reader.rest.data(), length);
  into[length] = '\0';
  reader.rest.remove_prefix(length);
  reader.at_line_start = into[length - 1] == '\n';
  return into;
}

int take_line(void* user, const char* /*section*/, const char* key, const char* value) {
  Reader& reader = *static_cast<Reader*>(user);
  reader.lines.push_back({fmt::format("{}:{}", reader.name, reader.line_number), reader.section,
                          key, value == nullptr ? "" : value});
  return 1;
}

}  // namespace

Error error_at(const ProfileLine& line, const std::string& message) {
  return {ErrorCode::kBadSetting, fmt::format("{}: {}", line.place, message)};
}

Result<std::vector<ProfileLine>> read_ini_lines(std::string_view text, const std::string& name) {
  if (text.find('\0') != std::string_view::npos) {
    return Error{ErrorCode::kBadSetting,
                 fmt::format("{}: holds a zero byte: not a settings file (a part?)", name)};
  }
  // By default, inih silently cuts lines at 200 bytes, and values at " ;".
  ini_use_stack = false;
  ini_allow_realloc = true;
  ini_max_line = static_cast<int>(kSettingsBytesMax) + 3;
  ini_allow_inline_comments = false;
  ini_allow_multiline = false;
  ini_stop_on_first_error = true;
  Reader reader{.rest = text,
                .name = name,
                .line_number = 0,
                .at_line_start = true,
                .section = {},
                .lines = {}};
  // Handler and reader get the same pointer; inih only passes it on.
  const int bad_line = ini_parse_stream(read_piece, &reader, take_line, &reader);
  const auto error = [&name](int line, const char* cause) {
    return Error{ErrorCode::kBadSetting, fmt::format("{}:{}: {}", name, line, cause)};
  };
  if (bad_line < 0) return error(reader.line_number, "out of memory");
  if (bad_line > 0) {
    return error(bad_line, "neither \"key = value\" nor [section] nor a comment");
  }
  return std::move(reader.lines);
}

}  // namespace host
