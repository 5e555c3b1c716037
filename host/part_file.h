// Opens a part, whatever kind of file it is, as a source of slices.
//
// The kind is told by the content, never by the name. A mesh has to be read to its end before its
// first slice, because facets come in any order; nothing of it is built in memory but triangles
// sorted by lowest z. The part is set on the bed here: its lowest point at height 0, and in the
// plane at the bed's centre or where the settings say.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/geometry.h"      // Box
#include "core/result.h"        // Result
#include "core/settings.h"      // Settings
#include "core/units.h"         // LayerIndex, Length
#include "host/layer_source.h"  // LayerSource

namespace host {

// What is known of a part before its first slice.
struct PartSummary {
  std::string format;           // "binary STL", "ASCII STL"
  std::int64_t facets = 0;      // in the file
  std::int64_t degenerate = 0;  // of them, two corners at one point: left out
  core::Box box;                // on the bed
  core::Length height;
  core::LayerIndex layers = 0;
  std::vector<std::string> warnings;  // for people: what was odd and how it was taken
};

// What has been used so far; processor time of the thread that called.
struct PartCounters {
  std::int64_t peak_triangles_held = 0;  // crossing one plane
  double read_cpu_s = 0;
  double sort_cpu_s = 0;
  double slice_cpu_s = 0;
};

struct OpenedPart {
  PartSummary summary;
  std::unique_ptr<LayerSource> layers;
  std::function<PartCounters()> counters;  // valid as long as `layers`
};

// `path` may be "-" for standard input. Errors name the file, the place, the cause and what to do:
// kUnreadable for the file itself, kBadPart for its content and for a part without height or
// thinner than a layer, kOutOfBounds for one larger than the bed, the axis or the coordinates.
[[nodiscard]] core::Result<OpenedPart> open_part(const std::string& path,
                                                 const core::Settings& settings);

}  // namespace host
