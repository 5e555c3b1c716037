// A part that is ready to be sliced: what is known of it, and where its slices come from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/geometry.h"              // Box
#include "core/result.h"                // Result
#include "core/units.h"                 // LayerIndex, Length
#include "host/formats/layer_source.h"  // LayerSource
#include "host/system/limits.h"         // kSortBytesDefault, kReorderTriangles

namespace host {

// What is looked for in all layers of a mesh whose surface is not closed, before the first slice.
enum class PlaneCheck {
  kNone,
  kWarn,    // layers with contours that can't be closed are a warning
  kRefuse,  // they are an error
};

// How a part is to be opened.
struct OpenOptions {
  // For sorting a mesh. REQUIRES: >= kSortBytesMin (limits.h)
  std::size_t sort_bytes = kSortBytesDefault;
  // Triangles looked at ahead, and that may be out of order; fewer where sort_bytes holds fewer.
  // REQUIRES: >= 2
  std::size_t reorder_triangles = kReorderTriangles;
  // A mesh that comes through a pipe in order of height may be sliced as it comes. The begin of it
  // is looked at; if a facet comes too late all the same, layers->next() ends with an error.
  bool stream_pipes = false;
  // Somebody says that it is in order; otherwise the look-ahead has to be so by far, since any few
  // triangles are nearly in order.
  bool order_is_sure = false;
  PlaneCheck plane_check = PlaneCheck::kNone;
  // Somebody says that a mesh is meant to be as high as it is (height_check.h).
  bool tall = false;
};

// What is known of a part before its first slice. One that is sliced as it comes through a pipe is
// known only as far as it was read: `layers` and `height` are 0 then.
struct PartSummary {
  std::string format;           // "binary STL", "ASCII CLI"
  std::int64_t facets = 0;      // in the file; layer files have none
  std::int64_t degenerate = 0;  // of them, two corners at one point: left out
  // Not known of layers from a pipe before its end: an empty box, and 0.
  core::Box box;  // on the bed
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
  std::int64_t spilled_bytes = 0;  // written to the temporary file for sorting
};

struct OpenedPart {
  PartSummary summary;
  // Reads what has to be read before the first slice, and checks it; gives the whole summary.
  // Empty: there is nothing left to read. REQUIRES: called once, before layers->next().
  std::function<core::Result<PartSummary>()> read_rest;
  std::unique_ptr<LayerSource> layers;
  std::function<PartCounters()> counters;  // valid as long as `layers`
};

}  // namespace host
