// A place in a ready G-code file at which reading, and a print, can go on: behind some line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "host/gcode/gcode_modes.h"  // GcodeModes
#include "host/gcode/gcode_text.h"   // TextPlace

namespace host {

struct FilePlace {
  TextPlace text;          // of the next line
  std::int64_t lines = 0;  // before it
  std::int64_t commands = 0;
  GcodeModes modes;
  std::string set_up;        // SetUpLines::text()
  bool set_up_whole = true;  // false: there were too many of these
  std::int32_t layer = 0;    // counted from 1; 0: before the first
  std::int64_t top_um = 0;   // the height at which it is laid
  double filament_mm = 0;    // in roads
  double seconds = 0;        // of motion at full speed
};

// For a journal; of the same place the same bytes.
[[nodiscard]] std::string bytes_of(const FilePlace& place);
// Nothing when these are not such bytes.
[[nodiscard]] std::optional<FilePlace> place_of(std::string_view bytes);
// Largest number of bytes.
inline constexpr std::size_t kPlaceBytesMax = 2'560;

}  // namespace host
