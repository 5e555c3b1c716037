// A part that is ready to be sliced: its summary and its source of slices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/geometry.h"              // Box, Triangle
#include "core/result.h"                // Result
#include "core/slices/layer_heights.h"  // LayerHeights
#include "core/units.h"                 // LayerIndex, Length
#include "host/formats/layer_source.h"  // LayerSource
#include "host/part/bed_placing.h"      // Shift
#include "host/system/limits.h"         // kSortBytesDefault, kReorderTriangles

namespace host {

// Whether all layers of a mesh with an open surface are checked before the first slice.
enum class PlaneCheck {
  kNone,
  kWarn,    // layers with contours that can't be closed are a warning
  kRefuse,  // they are an error
};

using FacetObserver = std::function<void(const core::Triangle& triangle)>;

// How a part is to be opened.
struct OpenOptions {
  // Memory for sorting a mesh. REQUIRES: >= kSortBytesMin (limits.h)
  std::size_t sort_bytes = kSortBytesDefault;
  // The look-ahead, in triangles; so many may be out of order. Fewer if sort_bytes holds fewer.
  // REQUIRES: >= 2
  std::size_t reorder_triangles = kReorderTriangles;
  // A mesh from a pipe may be sliced as it arrives if its look-ahead is in order of height. A later
  // facet that breaks the order is an error of layers->next().
  bool stream_pipes = false;
  // The user says that it is in order. Otherwise the look-ahead is judged more strictly, because
  // any few triangles are nearly in order.
  bool order_is_sure = false;
  PlaneCheck plane_check = PlaneCheck::kNone;
  // The user says that the mesh's height is meant (height_check.h).
  bool tall = false;
  // Sees the facets of a mesh that is read to its end before its first slice; some of them twice
  // where it turns out that they must be sorted (PartSummary::seen_whole).
  FacetObserver on_facet = {};
  // Of the things that the file lays onto the bed, these alone, by their numbers (part_items.h);
  // empty: all of them.
  std::vector<std::size_t> items = {};
};

// One of several things on the bed: a part, a copy of one (plate.h), or an item of one
// (part_items.h).
struct PartObject {
  std::string name;  // letters, digits and underscores; each object has another one
  core::Box box;     // on the bed
  core::Length height;
  std::string title = {};               // as people call it: of a file, or of an item
  std::vector<std::size_t> items = {};  // that it is, of the file; empty: all of it
};

// A part's summary before its first slice. Of a pipe that is sliced as it arrives, it covers what
// was read so far; `layers` and `height` are 0.
struct PartSummary {
  std::string format;           // "binary STL", "ASCII CLI"
  std::int64_t facets = 0;      // in the file; 0 for layer files
  std::int64_t degenerate = 0;  // facets with two equal corners: left out
  // Empty and 0 for layers from a pipe, whose end is not known.
  core::Box box;                // on the bed
  core::Length height;          // above the bed, on its raft
  core::LayerIndex layers = 0;  // of the print, the raft's counted
  // Of a mesh that was read to its end: the heights that its layers have.
  core::Length lowest_layer;
  core::Length highest_layer;
  bool seen_whole = false;            // OpenOptions::on_facet has seen every facet
  bool nothing_hangs = false;         // no surface leans outwards: known of closed meshes alone
  std::vector<std::string> warnings;  // for people: what was odd and how it was treated
  std::vector<PartObject> objects;    // at most kObjectsMax; empty: there is one, without a name
};

// Resources used so far. Processor time is that of the calling thread.
struct PartCounters {
  std::int64_t peak_triangles_held = 0;  // crossing one plane
  double read_cpu_s = 0;
  double sort_cpu_s = 0;
  double slice_cpu_s = 0;
  std::int64_t spilled_bytes = 0;  // written to the temporary file for sorting
};

// Where a mesh was put, and how it is cut.
struct PartPlacing {
  Shift shift;
  core::LayerHeights heights;
};

class ObjectSequence;

struct OpenedPart {
  PartSummary summary;
  // Reads and checks what is needed before the first slice; returns the complete summary. Empty if
  // nothing is left to read. REQUIRES: called once, before layers->next().
  std::function<core::Result<PartSummary>()> read_rest;
  std::unique_ptr<LayerSource> layers;
  // Of objects that are printed one after another: `layers`, `counters` and `placing` are empty
  // then, and each object has its own (object_sequence.h). Null elsewhere.
  std::shared_ptr<ObjectSequence> sequence;
  std::function<PartCounters()> counters;  // valid as long as `layers`
  // Of a mesh. REQUIRES: it was read (read_rest). Valid as long as `layers`.
  std::function<PartPlacing()> placing;
  // Shows the facets of a mesh, or of all objects, where they lie on the bed; files are read once
  // more. Empty: it is no mesh, is cut, or can't be read again. Otherwise as placing().
  std::function<core::Status(const FacetObserver& on_facet)> draw;
  // What the file's modifiers change, for people: "modifier 'Box': density 50 %"; and warnings
  // about what of them is not used, which open_part() puts into the summary.
  std::vector<std::string> modifiers;
  std::vector<std::string> modifiers_unused;
  std::size_t items = 1;  // things that the file lays onto the bed, each of which may be an object
  bool enforced = false;  // the file marks where supports are enforced, and they are used
};

}  // namespace host
