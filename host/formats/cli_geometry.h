// The commands of a CLI file, for its two encodings, text and binary. Used by cli_reader.
#pragma once

#include <cstdint>
#include <memory>

#include "core/result.h"                    // Result
#include "host/formats/cli_header.h"        // CliHeader
#include "host/formats/contour_gatherer.h"  // ContourGatherer
#include "host/formats/text_scanner.h"      // TextScanner

namespace host {

struct CliCommand {
  enum class Kind { kLayer, kContour, kOpen, kHatches, kEnd };
  Kind kind = Kind::kEnd;
  std::int64_t z_units = 0;  // of a layer's upper face
};

class CliGeometry {
 public:
  virtual ~CliGeometry() = default;
  // The next command. Puts closed contours into `contours`; checks and skips open lines and
  // hatches. COSTS: a ring's memory.
  [[nodiscard]] virtual core::Result<CliCommand> next(ContourGatherer& contours) = 0;
  // An error with file, position and cause.
  [[nodiscard]] virtual core::Error bad(const std::string& cause) const = 0;
};

// REQUIRES: `text` is just behind the head and outlives the geometry.
[[nodiscard]] std::unique_ptr<CliGeometry> cli_text_geometry(TextScanner& text,
                                                             const CliHeader& header);
[[nodiscard]] std::unique_ptr<CliGeometry> cli_binary_geometry(TextScanner& text,
                                                               const CliHeader& header);

// dir of a polyline: 0 clockwise, inside is outside; 1 counter-clockwise; 2 open.
inline constexpr std::int64_t kCliClockwise = 0, kCliCounterClockwise = 1, kCliOpen = 2;

// The direction has precedence over the order of the points.
[[nodiscard]] inline Turn cli_turn(std::int64_t direction) {
  return direction == kCliClockwise ? Turn::kClockwise : Turn::kCounterClockwise;
}

}  // namespace host
