// The way of the data, from slices to commands, one layer at a time:
//
//     LayerSource ─> OffsetCutter ═> WallSplitter ─> LayerPlanner ═> MotionBuilder ─> MotionEncoder
//       slice          its offsets      T layers later  roads           motions          commands
//                                       wall + inside     │               └──────┬───────┘
//                                           │             │                      │
//     outputs:                           on_layer      on_roads              on_motion
//
// The steps before ═> run on as many processors as there are jobs (ordered_stages.h); what comes
// out is the same for any number. Printing, slicing into a file and planning all run this very
// code and differ only in what they do with the outputs, so what is printed is what is shown.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/motions/motion.h"           // Motion
#include "core/result.h"                   // Result
#include "core/roads/road.h"               // Road
#include "core/walls/split_layer.h"        // SplitLayer
#include "firmware_link/wire/command.h"    // Command
#include "host/part/bad_layers.h"          // OnBadLayer
#include "host/part/part_file.h"           // OpenedPart
#include "host/pipeline/checkpoint.h"      // Checkpoint
#include "host/pipeline/layer_watch.h"     // SlowLayer
#include "host/pipeline/print_settings.h"  // PrintSettings
#include "host/pipeline/statistics.h"      // GeometryStatistics
#include "host/system/warning_box.h"       // WarningBox

namespace host {

// A part and how it is to be printed.
struct Job {
  PrintSettings settings;  // REQUIRES: validated, check_user_gcode() fine
  OpenedPart part;         // used up by the run
  std::string part_path;   // for messages
  OnBadLayer on_bad_layer = OnBadLayer::kRepair;
  int jobs = 1;  // processors that the geometry may use; REQUIRES: 1 … kJobsMax

  // Whether the controller draws arcs, for arcs = auto: asked once, before the first layer's
  // motions, and may wait for the answer. Empty: it does.
  std::function<bool()> draws_arcs = nullptr;

  // Goes on in mid-print: with the layer of this checkpoint, which is computed as in the whole
  // print, from the slices around it; those below are read and dropped.
  std::optional<Checkpoint> start = std::nullopt;
};

// What is done with what comes out; any may be empty, and what nobody wants is not computed.
// Returning false stops the pipeline.
struct PipelineOutputs {
  std::function<bool(const core::SplitLayer&)> on_layer;
  std::function<bool(const core::SplitLayer&, const std::vector<core::Road>&)> on_roads;
  // Before each layer that has roads.
  std::function<void(const Checkpoint&)> on_checkpoint;
  // Before a layer that the print is to pause at (OnBadLayer::kPause), and why.
  std::function<void(const std::string&)> on_pause;
  // The command that carries the motion out, where it needs one.
  std::function<bool(const core::Motion&, const std::optional<firmware_link::Command>&)> on_motion;
};

// What other threads may look at, and say, meanwhile.
struct PipelineSignals {
  std::function<bool()> stop_asked;          // asked on each layer; may be empty
  std::atomic<std::int64_t> slices_cut = 0;  // told to others
  std::atomic<core::LayerIndex> layers = 0;  // of the part; 0: not known yet, or at all
  WarningBox warnings;                       // met on the way
  // A layer that takes long, while it does; called by a thread of its own; may be empty.
  std::function<void(const SlowLayer&)> on_slow_layer;
  double slow_layer_s = kSlowLayer_s;
};

enum class PipelineEnd { kDone, kStopped };

// Runs the part through to its end, or until an output or a signal stops it.
//
// Where the part has to be read to its end before its first slice, the heaters are turned on first.
// Errors are the source's own, and: no road fits anywhere (nothing was sent to on_motion then but
// heating); a layer needs more memory than there is; a bad layer that is to end the print;
// a road would leave the bed (told on the first layer, before anything was sent).
// COSTS: at most 2T + 1 layers and 2T partial intersections held (wall_splitter.h), and, with more
// jobs than one, batches_max() layers on their way (ordered_stages.h).
[[nodiscard]] core::Result<PipelineEnd> run_pipeline(Job& job, const PipelineOutputs& outputs,
                                                     PipelineSignals& signals,
                                                     GeometryStatistics& statistics);

}  // namespace host
