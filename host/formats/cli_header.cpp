#include "host/formats/cli_header.h"

#include <string>
#include <string_view>
#include <vector>

#include "host/formats/format_limits.h"  // kHeadBytesMax
#include "host/formats/number_text.h"    // parse_real

namespace host {
namespace {

using core::Result;
using core::Status;

// Larger units are a mistake (metres).
constexpr double kUnitMaxMm = 1'000;

class HeaderReader {
 public:
  explicit HeaderReader(TextScanner& text) : text_(text) {}

  Result<CliHeader> read() {
    bool started = false;
    while (true) {
      if (Status found = find_command(); !found.ok()) return found.error();
      const std::string name = command_name();
      if (name == "HEADERSTART") {
        started = true;
      } else if (name == "HEADEREND") {
        return finished();
      } else if (started) {
        if (Status taken = take(name); !taken.ok()) return taken.error();
      }
    }
  }

 private:
  // Reads up to and including the next "$$".
  Status find_command() {
    int dollars = 0;
    while (dollars < 2) {
      const int c = text_.peek();
      if (c == TextScanner::kEnd) return text_.cut_short("'$$HEADEREND'");
      if (text_.byte() > kHeadBytesMax) {
        return text_.bad("no '$$HEADEREND' in the first " + std::to_string(kHeadBytesMax) +
                         " bytes; export the file again");
      }
      dollars = c == '$' ? dollars + 1 : 0;
      text_.take();
    }
    return {};
  }

  std::string command_name() {
    std::string name;
    for (int c = text_.peek(); c >= 'A' && c <= 'Z' && name.size() < kWordBytesMax;
         c = text_.peek()) {
      name += static_cast<char>(c);
      text_.take();
    }
    return name;
  }

  // The text after a command's "/", up to the line's end, the next command or a comment.
  std::string parameters() {
    std::string found;
    if (text_.peek() != '/') return found;
    text_.take();
    bool quoted = false;
    for (int c = text_.peek(); c != TextScanner::kEnd && c != '\n' && c != '\r'; c = text_.peek()) {
      const std::string_view ahead = text_.lookahead(2);
      if (!quoted && (ahead == "$$" || ahead == "//")) break;
      if (c == '"') quoted = !quoted;
      if (found.size() < kEntryBytesMax) found += static_cast<char>(c);
      text_.take();
    }
    while (!found.empty() && is_blank(found.back())) found.pop_back();
    return found;
  }

  Status take(const std::string& name) {
    if (name == "ASCII" || name == "BINARY") {
      kind_known_ = true;
      header_.binary = name == "BINARY";
    } else if (name == "ALIGN") {
      header_.aligned = true;
    } else if (name == "UNITS") {
      const std::string unit = parameters();
      const std::optional<double> mm = parse_real(unit);
      if (!mm || *mm <= 0 || *mm > kUnitMaxMm) {
        return text_.bad("$$UNITS/" + shown(unit) +
                         " is no unit in mm, as in $$UNITS/0.01; correct the file's head");
      }
      header_.unit_mm = *mm;
    } else if (name == "LAYERS") {
      header_.layers = parse_integer(parameters()).value_or(0);
      if (header_.layers < 0) header_.layers = 0;
    } else if (name == "DIMENSION") {
      take_dimension(parameters());
    } else if (name == "USERDATA") {
      return skip_user_data();
    } else if (name == "LABEL") {
      // Its text may hold anything.
      static_cast<void>(parameters());
    }
    return {};
  }

  void take_dimension(std::string_view list) {
    std::array<double, 6> numbers{};
    for (double& number : numbers) {
      const std::size_t comma = list.find(',');
      const std::optional<double> read = parse_real(list.substr(0, comma));
      if (!read) return;
      number = *read;
      list.remove_prefix(comma == std::string_view::npos ? list.size() : comma + 1);
    }
    header_.dimension_mm = numbers;
  }

  // Right behind the second comma stand so many bytes of any kind.
  Status skip_user_data() {
    std::string number;
    bool quoted = false;
    for (int commas = 0; commas < 2;) {
      const int c = text_.peek();
      if (c == TextScanner::kEnd) return text_.cut_short("the length of $$USERDATA");
      if (c == '\n' || c == '\r') return {};
      text_.take();
      if (c == '"') quoted = !quoted;
      if (c == ',' && !quoted) {
        ++commas;
      } else if (commas == 1 && number.size() < kWordBytesMax) {
        number += static_cast<char>(c);
      }
    }
    const std::optional<std::int64_t> length = parse_integer(number);
    if (!length || *length < 0 || *length > kHeadBytesMax) {
      return text_.bad("'" + shown(number) + "' is no length for $$USERDATA, which has up to " +
                       std::to_string(kHeadBytesMax) + " bytes; remove it from the file");
    }
    for (std::int64_t i = 0; i < *length; ++i) {
      if (text_.peek() == TextScanner::kEnd) return text_.cut_short("$$USERDATA");
      text_.take();
    }
    return {};
  }

  Result<CliHeader> finished() {
    if (header_.unit_mm == 0) {
      return text_.bad(
          "the head has no $$UNITS, so that sizes mean nothing; add it, as in "
          "$$UNITS/0.01");
    }
    if (!kind_known_) {
      return text_.bad("the head says neither $$ASCII nor $$BINARY; add the one that is true");
    }
    return header_;
  }

  TextScanner& text_;
  CliHeader header_;
  bool kind_known_ = false;
};

}  // namespace

Result<CliHeader> read_cli_header(TextScanner& text) { return HeaderReader(text).read(); }

}  // namespace host
