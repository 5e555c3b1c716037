// A part that is ready to be sliced: what is known of it, and where its slices come from.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/geometry.h"      // Box
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

}  // namespace host
