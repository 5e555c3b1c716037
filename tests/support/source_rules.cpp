#include "tests/support/source_rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <optional>
#include <set>
#include <span>

#include "tests/support/source_text.h"

namespace test {
namespace {

constexpr std::size_t kColumnsMax = 100;
constexpr std::size_t kFileLinesMax = 400;
constexpr std::size_t kFunctionLinesMax = 70;

std::string at(const Source& source, std::size_t line, const std::string& what) {
  return source.path + ":" + std::to_string(line) + ": " + what;
}

bool is_header(const std::string& path) { return path.ends_with(".h"); }

bool is_code(const std::string& path) { return is_header(path) || path.ends_with(".cpp"); }

bool within(const std::string& path, std::string_view place) { return path.starts_with(place); }

struct Library {
  std::string_view header;                    // or the start of its name
  std::array<std::string_view, 6> allowed{};  // sources, or the starts of their names
};

// A library's header is included in one source, or a few; never in a header. Tests may use any.
constexpr std::array kLibraries = {
    Library{"boost/polygon/polygon.hpp", {"tools/oracles/"}},
    Library{"boost/polygon/voronoi", {"core/offsets/voronoi_diagram.cpp"}},
    Library{"libserialport.h",
            {"firmware_link/ports/serial_port.cpp", "firmware_link/ports/ports.cpp"}},
    Library{"ini.h", {"host/settings/profile_lines.cpp"}},
    Library{"CLI/",
            {"host/settings/options.cpp", "host/settings/setting_options.cpp",
             "host/settings/command_options.cpp", "host/settings/documents.cpp",
             "host/settings/usage.cpp", "tools/"}},
    Library{"fast_float/", {"host/formats/"}},
    Library{"expat.h", {"host/formats/xml_scanner.cpp"}},
    Library{"zip.h", {"host/formats/zip_archive.cpp"}},
    Library{"zlib.h", {"host/output/png_writer.cpp", "host/gcode/bgcode_blocks.cpp"}},
    Library{"spdlog/", {"host/"}},
    Library{"nlohmann/", {"host/", "tools/"}},
    Library{"fmt/", {"host/", "tools/"}},
    Library{"benchmark/", {"tools/"}},
    Library{"doctest/", {"tests/"}},
    Library{"polyclipping/", {"tests/", "tools/bench_"}},
    Library{"clipper2/", {"tools/oracles/clipper2_calls.cpp"}},
};

// Headers that core and firmware_link must not include: only host knows threads, clocks and files.
constexpr std::array<std::string_view, 11> kOutermost = {
    "thread",   "mutex",   "condition_variable", "future", "ctime", "fstream",
    "iostream", "ostream", "filesystem",         "random", "atomic"};

// check.cpp writes a line before the program ends; the ports use the operating system.
bool may_touch_system(const std::string& path) {
  const bool pure = within(path, "core/") || within(path, "firmware_link/");
  return !pure || path.ends_with("/check.cpp") ||
         (within(path, "firmware_link/") &&
          (path.ends_with("_port.cpp") || path.ends_with("/ports.cpp")));
}

// True if the line contains it as a whole word: mkdtemp's six X in a row don't count.
bool says(const std::string& line, const std::string& word) {
  const auto letter = [&](std::size_t i) {
    return i < line.size() && std::isalpha(static_cast<unsigned char>(line[i])) != 0;
  };
  for (std::size_t i = line.find(word); i != std::string::npos; i = line.find(word, i + 1)) {
    const bool path = word.find('/') != std::string::npos;
    if (path || (!(i > 0 && letter(i - 1)) && !letter(i + word.size()))) return true;
  }
  return false;
}

// Whether a room may include from another one.
bool arrow_exists(const std::string& path, std::string_view included) {
  const auto from = [&](std::string_view room) { return included.starts_with(room); };
  if (within(path, "core/")) return from("core/");
  if (within(path, "firmware_link/")) return from("firmware_link/");
  const bool inner = from("core/") || from("firmware_link/") || from("host/");
  if (within(path, "host/")) return inner;
  if (within(path, "tools/")) return inner || from("tools/");
  return inner || from("tools/") || from("tests/");
}

// The folders of each library from the ground up: a folder may include those before it and itself.
// "" is the library's own folder.
constexpr std::array<std::string_view, 10> kCoreFloors = {
    "",      "regions", "booleans", "slices",  "offsets",
    "walls", "roads",   "supports", "motions", "sections"};
constexpr std::array<std::string_view, 5> kFirmwareLinkFloors = {"wire", "dialects", "ports",
                                                                 "session", "virtual"};
constexpr std::array<std::string_view, 13> kHostFloors = {
    "system",   "files",    "formats",     "gcode",    "presets",  "output", "part",
    "pipeline", "printing", "calibration", "settings", "commands", ""};

struct Floors {
  std::string_view room;
  std::span<const std::string_view> from_the_ground;
};
constexpr std::array kFloors = {Floors{"core/", kCoreFloors},
                                Floors{"firmware_link/", kFirmwareLinkFloors},
                                Floors{"host/", kHostFloors}};

// The number of the floor of `path`, a file of that library; nullopt: its folder is not listed.
std::optional<std::size_t> floor_of(std::string_view path, const Floors& floors) {
  path.remove_prefix(floors.room.size());
  const std::size_t end = path.find('/');
  const std::string_view folder = end == std::string_view::npos ? "" : path.substr(0, end);
  const auto found =
      std::find(floors.from_the_ground.begin(), floors.from_the_ground.end(), folder);
  if (found == floors.from_the_ground.end()) return std::nullopt;
  return static_cast<std::size_t>(found - floors.from_the_ground.begin());
}

void check_library(const Source& source, const Include& include, Complaints& complaints) {
  const auto complain = [&](const std::string& what) {
    complaints.push_back(at(source, include.line, "<" + include.name + "> " + what));
  };
  const auto* library = std::find_if(kLibraries.begin(), kLibraries.end(), [&](const Library& l) {
    return include.name.starts_with(l.header);
  });
  const bool tests = within(source.path, "tests/");
  if (library != kLibraries.end()) {
    const bool allowed = std::any_of(
        library->allowed.begin(), library->allowed.end(),
        [&](std::string_view place) { return !place.empty() && within(source.path, place); });
    if (!tests && is_header(source.path)) complain("is a library's: no header may include it");
    if (!tests && !allowed) complain("is a library's that belongs elsewhere");
    return;
  }
  const bool standard = include.name.find_first_of("./") == std::string::npos;
  if (standard) {
    const bool outermost =
        std::find(kOutermost.begin(), kOutermost.end(), include.name) != kOutermost.end();
    if (outermost && !may_touch_system(source.path)) complain("has no place in this room");
    return;
  }
  const bool system = include.name.ends_with(".h") &&
                      (include.name.find('/') == std::string::npos ||
                       within(include.name, "sys/") || within(include.name, "netinet/") ||
                       within(include.name, "arpa/") || within(include.name, "linux/"));
  if (!system) return complain("is not in the table of libraries");
  if (!may_touch_system(source.path)) complain("is the operating system's");
}

}  // namespace

Complaints check_size(const Source& source) {
  Complaints complaints;
  if (!is_code(source.path)) return complaints;
  const std::vector<std::string> lines = lines_of(source.text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // Bytes that continue a code point look like 10xxxxxx.
    const auto columns = static_cast<std::size_t>(
        std::count_if(lines[i].begin(), lines[i].end(), [](char c) { return (c & 0xC0) != 0x80; }));
    if (columns > kColumnsMax) {
      complaints.push_back(at(source, i + 1, std::to_string(columns) + " columns"));
    }
  }
  if (lines.size() > kFileLinesMax) {
    complaints.push_back(at(source, lines.size(), std::to_string(lines.size()) + " lines"));
  }
  return complaints;
}

Complaints check_functions(const Source& source) {
  Complaints complaints;
  if (!is_code(source.path)) return complaints;
  for (const Function& function : functions_of(source.text)) {
    const std::size_t lines = function.last_line - function.first_line + 1;
    if (lines > kFunctionLinesMax) {
      complaints.push_back(
          at(source, function.first_line, "a function of " + std::to_string(lines) + " lines"));
    }
  }
  return complaints;
}

Complaints check_words(const Source& source) {
  // In halves, so that they do not stand here.
  static const std::array<std::string, 5> kBanned = {
      std::string("TO") + "DO", std::string("FIX") + "ME", std::string("XX") + "X",
      std::string("/wo") + "rk/", std::string("../sha") + "red"};
  Complaints complaints;
  const std::vector<std::string> lines = lines_of(source.text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const std::string& word : kBanned) {
      if (says(lines[i], word)) {
        complaints.push_back(at(source, i + 1, "says " + word));
      }
    }
  }
  return complaints;
}

Complaints check_guard(const Source& source) {
  if (!is_header(source.path)) return {};
  for (const std::string& line : lines_of(source.text)) {
    if (line == "#pragma once") return {};
  }
  return {at(source, 1, "has no #pragma once")};
}

Complaints check_includes(const Source& source) {
  Complaints complaints;
  if (!is_code(source.path)) return complaints;
  for (const Include& include : includes_of(source.text)) {
    if (!include.quoted) {
      check_library(source, include, complaints);
    } else if (!arrow_exists(source.path, include.name)) {
      complaints.push_back(
          at(source, include.line, "\"" + include.name + "\" is against the arrows"));
    }
  }
  return complaints;
}

Complaints check_floors(const Source& source) {
  Complaints complaints;
  if (!is_code(source.path)) return complaints;
  for (const Floors& floors : kFloors) {
    if (!within(source.path, floors.room)) continue;
    const std::optional<std::size_t> own = floor_of(source.path, floors);
    if (!own) complaints.push_back(at(source, 1, "its folder is not in the list of floors"));
    for (const Include& include : includes_of(source.text)) {
      if (!own || !include.quoted || !within(include.name, floors.room)) continue;
      const std::optional<std::size_t> other = floor_of(include.name, floors);
      if (other && *other <= *own) continue;
      complaints.push_back(
          at(source, include.line, "\"" + include.name + "\" is on a higher floor"));
    }
  }
  return complaints;
}

Complaints check_calls(const Source& source) {
  Complaints complaints;
  if (may_touch_system(source.path)) return complaints;
  const std::vector<std::string> lines = lines_of(code_only(source.text));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const char* call : {"_clock::now", "std::time(", "clock_gettime", "sleep_for", " printf(",
                             "::printf(", "fprintf(", "fopen(", "std::cerr"}) {
      if (lines[i].find(call) != std::string::npos) {
        complaints.push_back(at(source, i + 1, std::string(call) + " has no place in this room"));
      }
    }
  }
  return complaints;
}

Complaints check_dead_headers(const std::vector<Source>& sources) {
  std::set<std::string> included;
  for (const Source& source : sources) {
    if (!is_code(source.path)) continue;
    for (const Include& include : includes_of(source.text)) {
      if (include.quoted && include.name != source.path) included.insert(include.name);
    }
  }
  Complaints complaints;
  for (const Source& source : sources) {
    if (is_header(source.path) && !included.contains(source.path)) {
      complaints.push_back(at(source, 1, "no file includes this header"));
    }
  }
  return complaints;
}

}  // namespace test
