// The pipeline from slices to commands, one layer at a time:
//
//     LayerSource ─> OffsetCutter ═> WallSplitter ─> LayerPlanner ═> MotionBuilder ─> MotionEncoder
//       slice          its offsets      T layers later  roads           motions          commands
//                                       wall + inside     │               └──────┬───────┘
//                                           │             │                      │
//     outputs:                           on_layer      on_roads              on_motion
//
// The steps before ═> run on several threads (ordered_stages.h); the result is the same for any
// number. Printing, slicing into a file and planning run this same code and differ
// only in their outputs, so a print equals its preview. Layers that are given out count those of a
// raft, which are laid before the part's first one (raft_stage.h), and those of objects that are
// printed before it. Objects that are printed one after another have a pipeline each, and share the
// last step (pipeline.cpp).
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motions/motion.h"            // Motion
#include "core/result.h"                    // Result
#include "core/roads/road.h"                // Road
#include "core/walls/split_layer.h"         // SplitLayer
#include "firmware_link/wire/command.h"     // Command
#include "host/gcode/ready_file.h"          // ReadyFile
#include "host/output/gcode_writer.h"       // GcodeWriter
#include "host/part/bad_layers.h"           // OnBadLayer
#include "host/part/part_file.h"            // OpenedPart
#include "host/pipeline/checkpoint.h"       // Checkpoint
#include "host/pipeline/hanging_log.h"      // OnFloating
#include "host/pipeline/layer_watch.h"      // SlowLayer
#include "host/pipeline/preparation.h"      // PreparationBox
#include "host/pipeline/print_settings.h"   // PrintSettings
#include "host/pipeline/printed_objects.h"  // PrintedObjects
#include "host/pipeline/statistics.h"       // GeometryStatistics
#include "host/system/warning_box.h"        // WarningBox

namespace host {

// What the commands depend on besides the settings.
struct CommandForm {
  bool arcs = true;  // for arcs = auto: whether round roads become arcs
  firmware_link::Flavor flavor = firmware_link::Flavor::kMarlin;
};

// One of several objects that are printed one after another (host/part/object_sequence.h).
struct PrintTurn {
  int object = 0;
  core::LayerIndex layers_before = 0;  // of the objects before it
  core::LayerIndex layers = 0;         // of the whole print
};

// A part and how it is to be printed.
struct PrintPlan {
  PrintSettings settings;  // REQUIRES: validated, check_user_gcode() fine
  OpenedPart part;         // consumed by the run; of a ready file its summary alone
  std::string part_path;   // for messages
  OnBadLayer on_bad_layer = OnBadLayer::kRepair;
  OnFloating on_floating = OnFloating::kWarn;
  std::string spool_folder{};  // of temporary files for supports; empty: $TMPDIR, or /tmp
  int threads = 1;             // processors that the geometry may use; REQUIRES: 1 … kThreadsMax

  // What the controller understands. Called once, before the motions of the first layer that has
  // roads, and may block until that is known; not if the print is resumed, whose checkpoint has it.
  // Empty: a file, as the settings say.
  std::function<CommandForm()> command_form = nullptr;

  // Resumes a print at the layer of this checkpoint. The layer is computed as in the whole print,
  // from the slices around it; slices below are read and dropped.
  std::optional<Checkpoint> start = std::nullopt;

  // A ready G-code file is printed as it is; there is nothing to slice. Null: a part.
  std::shared_ptr<const ReadyFile> ready = nullptr;

  // The part is one of several. Nothing: it is printed alone, or layer by layer with others.
  std::optional<PrintTurn> turn = std::nullopt;
};

// Receivers of the results. Any may be empty; results without a receiver are not computed.
// Returning false stops the pipeline.
struct PipelineOutputs {
  std::function<bool(const core::SplitLayer&)> on_layer;
  std::function<bool(const core::SplitLayer&, const std::vector<core::Road>&)> on_roads;
  // Before each layer that has roads.
  std::function<void(const Checkpoint&)> on_checkpoint;
  // Before each layer's first motion: the estimated time of all that comes before it.
  std::function<void(double seconds)> on_layer_time;
  // Before a layer at which the print pauses (OnBadLayer::kPause), with the reason.
  std::function<void(const std::string&)> on_pause;
  // A motion, with its command if it needs one.
  std::function<bool(const core::Motion&, const std::optional<firmware_link::Command>&)> on_motion;
  // In place of on_motion, roads of one layer whose motions were made before their turn by any
  // thread (layer_draft.h): their text in pieces, as `writer` would write it. Without a writer, no
  // text is made. Empty: every motion is given out by itself.
  std::function<bool(std::string_view text)> on_roads_text;
  const GcodeWriter* writer = nullptr;  // copied before the first layer
};

// Shared with other threads during the run.
struct PipelineSignals {
  std::function<bool()> stop_asked;  // called on each layer; may be empty
  std::atomic<std::int64_t> slices_cut = 0;
  std::atomic<core::LayerIndex> layers = 0;  // of the print; 0: not known
  // Of a ready file: how long it moves at full speed, and how long it takes; 0: not known.
  std::atomic<double> full_speed_s = 0;
  std::atomic<double> time_s = 0;
  WarningBox warnings;
  PreparationBox preparation;
  PrintedObjects objects;
  // Called while a layer takes long, by a thread of its own (layer_watch.h); may be empty.
  std::function<void(const SlowLayer&)> on_slow_layer;
  double slow_layer_s = kSlowLayer_s;
};

enum class PipelineEnd { kDone, kStopped };

// Runs the part to its end, or until an output or a signal stops the run.
//
// If the part has to be read to its end before its first slice, the heaters are turned on first.
// Errors: those of the source; no road fits anywhere (on_motion has received only heating then); a
// layer needs more memory than there is; a bad layer ends the print; a road would leave the bed (if
// it is in the first layer, before anything was sent).
// COSTS: holds at most 2T + 1 layers and 2T partial intersections (wall_splitter.h), and
// batches_max() layers in the stages if there is more than one thread (ordered_stages.h).
[[nodiscard]] core::Result<PipelineEnd> run_pipeline(PrintPlan& print_plan,
                                                     const PipelineOutputs& outputs,
                                                     PipelineSignals& signals,
                                                     GeometryStatistics& statistics);

}  // namespace host
