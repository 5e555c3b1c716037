// The pipeline's last step: the roads of one layer after another become motions and commands.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/motions/laid_layer.h"        // LaidLayer
#include "core/motions/motion_builder.h"    // MotionBuilder
#include "core/roads/road.h"                // Road
#include "core/roads/seams.h"               // SeamMemory
#include "core/roads/travel_space.h"        // TravelSpace
#include "core/settings.h"                  // Settings
#include "core/slices/slice.h"              // Slice
#include "core/units.h"                     // Length
#include "host/gcode/command_clock.h"       // CommandClock
#include "host/part/opened_part.h"          // PartObject
#include "host/pipeline/checkpoint.h"       // Checkpoint
#include "host/pipeline/layer_draft.h"      // LayerDraft
#include "host/pipeline/motion_encoder.h"   // MotionEncoder
#include "host/pipeline/object_map.h"       // ObjectMap
#include "host/pipeline/pipeline.h"         // CommandForm, PipelineOutputs
#include "host/pipeline/printed_objects.h"  // PrintedObjects
#include "host/pipeline/statistics.h"       // GeometryStatistics
#include "host/system/warning_box.h"        // WarningBox

namespace host {

class CommandStage {
 public:
  // `form`: as PrintPlan::command_form. `refused`: set once an output wants no more; nothing is
  // sent then. All but the settings outlive it.
  CommandStage(const core::Settings& settings, const std::function<CommandForm()>& form,
               const PipelineOutputs& outputs, std::atomic<bool>& refused);

  // REQUIRES: nothing was sent.
  void resume_from(const Checkpoint& start);

  // What is printed, if it is several objects. REQUIRES: before the first layer, behind
  // resume_from().
  // `printed` gets their names, and says which are not laid any more; it outlives the stage.
  void tell_objects(std::vector<PartObject> objects, PrintedObjects& printed);

  // Once; nothing when it was done already.
  void preheat();

  // Before the first layer of one of several objects that are laid one after another; the layers of
  // those before it. And behind its last one, if others follow.
  void begin_object(core::LayerIndex layers_before) { layers_before_ = layers_before; }
  void leave_object() { builder_.leave_object(sink_); }

  // How a layer is laid, by any thread, before its turn. Of the slice, all but the region counts.
  // Nothing where only its turn tells: a spiral, or before it is known whether there are arcs.
  [[nodiscard]] std::optional<core::LaidLayer> prepared(const core::Slice& slice,
                                                        const std::vector<core::Road>& roads) const;

  // Its roads as commands and text (layer_draft.h), by any thread. Null where only its turn tells.
  // `place` and `space` as for the layer; `laid`: prepared() for it.
  [[nodiscard]] std::shared_ptr<const LayerDraft> draft(core::LayerPlace place,
                                                        const core::LaidLayer& laid,
                                                        const core::TravelSpace* space) const;
  // Before any thread makes one; behind tell_objects().
  void allow_drafts();

  // The next layer up, counted from the print's first.
  struct NextLayer {
    const core::Slice& slice;
    const std::vector<core::Road>& roads;
    const core::LaidLayer* laid = nullptr;     // of these roads; null: not prepared
    const core::SeamMemory& seams_before;      // of the layers below
    const core::TravelSpace* space = nullptr;  // where travel stays in the part; null: straight
    const LayerDraft* draft = nullptr;         // of these roads; null: none
  };
  void layer(const NextLayer& next);

  void finish() { builder_.finish(sink_); }
  // A warning about the first action that was never due (core/motions/height_actions.h).
  void tell_missed(const std::string& part, WarningBox& warnings) const;

  // Printing time of what was given so far, as it comes to rest. COSTS: O(core::kLookAheadMoves).
  [[nodiscard]] double seconds() const { return clock_.seconds(); }

  // Filament, arcs and time.
  void tell(GeometryStatistics& statistics) const;

 private:
  // Tells whose roads they are; leaves out those of objects that nobody wants any more.
  [[nodiscard]] std::vector<core::Road> wanted(std::vector<core::Road> roads,
                                               core::LayerIndex layer) const;
  void lay(const NextLayer& next);
  [[nodiscard]] bool take(const LayerDraft& draft);
  void decide_form();
  void note_arcs();
  // A motion of the object at hand; and as one of the print, whose layers are counted through.
  void send(const core::Motion& motion);
  void pass_on(const core::Motion& motion);

  const core::Settings settings_;
  const std::function<CommandForm()>& form_;
  const PipelineOutputs& outputs_;
  std::atomic<bool>& refused_;
  core::MotionBuilder builder_;
  CommandClock clock_;
  MotionEncoder encoder_;
  core::MotionBuilder::Sink sink_;
  CommandForm of_files_;
  bool form_decided_ = false;
  std::atomic<bool> arcs_decided_ = false, arcs_ = false;  // of builder_, for all threads
  std::vector<PartObject> objects_;
  ObjectMap map_{{}};
  PrintedObjects* printed_ = nullptr;
  core::LayerIndex layers_before_ = 0;
  std::int64_t commands_ = 0;  // of the whole print
  double filament_before_mm_ = 0;

  // What drafts start from, for all threads.
  std::optional<MotionEncoder> draft_encoder_;
  std::optional<GcodeWriter> draft_writer_;
  mutable std::mutex draft_mutex_;  // for the clock
  std::optional<CommandClock> draft_clock_;
};

}  // namespace host
