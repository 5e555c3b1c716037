#include "host/pipeline/command_stage.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "host/gcode/flavor_of.h"
#include "host/pipeline/user_gcode.h"  // with_own_modes

namespace host {
CommandStage::CommandStage(const core::Settings& settings, const std::function<CommandForm()>& form,
                           const PipelineOutputs& outputs, std::atomic<bool>& refused)
    : settings_(settings),
      form_(form),
      outputs_(outputs),
      refused_(refused),
      builder_(with_own_modes(settings)),
      clock_(settings),
      encoder_(settings),
      sink_([this](const core::Motion& motion) { send(motion); }),
      of_files_{true, flavor_of(settings.gcode_flavor)} {
  if (!form_ && builder_.arcs_undecided()) builder_.decide_arcs(of_files_.arcs);
  note_arcs();
}

void CommandStage::resume_from(const Checkpoint& start) {
  builder_.resume_from(start.motions);
  note_arcs();
  encoder_.resume_from(start.encoder);
  form_decided_ = true;
  commands_ = start.commands;
  filament_before_mm_ = start.filament_mm;
}

void CommandStage::tell_objects(std::vector<PartObject> objects, PrintedObjects& printed) {
  objects_ = std::move(objects);
  map_ = ObjectMap(objects_);
  printed_ = &printed;
  std::vector<std::string> names;
  for (const PartObject& object : objects_) names.push_back(object.name);
  printed.set_names(std::move(names));
  if (form_decided_) {
    encoder_.set_labels(ObjectLabels(objects_, settings_, encoder_.state().flavor));
  }
}

std::vector<core::Road> CommandStage::wanted(std::vector<core::Road> roads,
                                             core::LayerIndex layer) const {
  map_.mark(roads);
  printed_->begin_layer(layer);
  std::erase_if(roads,
                [&](const core::Road& road) { return printed_->left_out(road.object, layer); });
  return roads;
}

void CommandStage::note_arcs() {
  if (builder_.arcs_undecided()) return;
  arcs_ = builder_.state().arcs.value();
  arcs_decided_ = true;
}

std::optional<core::LaidLayer> CommandStage::prepared(const core::Slice& slice,
                                                      const std::vector<core::Road>& roads) const {
  if (roads.empty() || roads.front().spiral || !arcs_decided_) return std::nullopt;
  core::Slice of_object = slice;
  of_object.index -= layers_before_;
  const core::LayerLaying& laying = builder_.laying();
  const core::LayerPace pace =
      laying.pace(of_object, laying.actions_below(slice.bottom), arcs_.load());
  if (objects_.empty()) return laying.lay(of_object, roads, pace, std::nullopt);
  std::vector<core::Road> marked = roads;
  map_.mark(marked);
  return laying.lay(of_object, marked, pace, std::nullopt);
}

void CommandStage::allow_drafts() {
  if (!outputs_.on_roads_text || form_) return;
  decide_form();
  draft_encoder_ = MotionEncoder(settings_);
  draft_encoder_->set_flavor(encoder_.state().flavor);
  draft_encoder_->set_labels(ObjectLabels(objects_, settings_, encoder_.state().flavor));
  // As it is behind the start G-code, which may say how to move.
  CommandClock clock = clock_;
  MotionEncoder encoder = encoder_;
  builder_.show_preamble([&](const core::Motion& motion) {
    if (const auto command = encoder.encode(motion)) clock.add_time(*command);
  });
  draft_clock_ = clock;
  if (outputs_.writer != nullptr) draft_writer_ = *outputs_.writer;
}

std::shared_ptr<const LayerDraft> CommandStage::draft(core::LayerPlace place,
                                                      const core::LaidLayer& laid,
                                                      const core::TravelSpace* space) const {
  if (!draft_encoder_) return nullptr;
  place.index -= layers_before_;
  const CommandClock clock = [this] {
    const std::lock_guard lock(draft_mutex_);
    return *draft_clock_;
  }();
  return draft_of(builder_.laying().settings_of(laid.pace), place, laid, space,
                  {*draft_encoder_, clock, draft_writer_ ? &*draft_writer_ : nullptr});
}

// Whether the draft's roads were given out; the builder follows.
bool CommandStage::take(const LayerDraft& draft) {
  if (!fits(draft, encoder_.state())) return false;
  std::optional<CommandClock> clock = clock_behind(draft, clock_);
  if (!clock) return false;
  clock_ = *std::move(clock);
  MotionEncoder::State state = encoder_.state();
  const bool goes_on = fill_in(draft, state, clock_, [this](std::string_view text) {
    return !refused_ && outputs_.on_roads_text(text);
  });
  if (!goes_on) refused_ = true;
  encoder_.resume_from(state);
  commands_ += draft.commands;
  return true;
}

void CommandStage::layer(const NextLayer& next) {
  if (objects_.empty()) return lay(next);
  const std::vector<core::Road> roads = wanted(next.roads, next.slice.index);
  const bool all = roads.size() == next.roads.size();
  lay({next.slice, roads, all ? next.laid : nullptr, next.seams_before, next.space, next.draft});
}

void CommandStage::lay(const NextLayer& next) {
  const core::Slice& slice = next.slice;
  if (next.roads.empty()) return;
  decide_form();
  if (outputs_.on_checkpoint && !refused_) {
    outputs_.on_checkpoint({slice.index, slice.bottom, commands_,
                            filament_before_mm_ + total_mm(builder_.totals().filament_mm),
                            builder_.state(), encoder_.state(), next.seams_before});
  }
  core::Slice of_object = slice;
  of_object.index -= layers_before_;
  if (next.laid != nullptr && builder_.suits(*next.laid, of_object)) {
    const LayerDraft* draft = next.draft;
    const bool drafted = draft != nullptr && draft->height == slice.height;
    builder_.prepared_layer(of_object, *next.laid, sink_, next.space,
                            drafted ? &draft->body : nullptr, [&] { return take(*draft); });
  } else {
    builder_.layer(of_object, next.roads, sink_, next.space);
  }
  if (draft_clock_) {
    const std::lock_guard lock(draft_mutex_);
    draft_clock_ = clock_;
  }
}

void CommandStage::preheat() {
  if (!builder_.state().preheated) builder_.preheat(sink_);
}

void CommandStage::decide_form() {
  if (std::exchange(form_decided_, true)) return;
  const CommandForm form = form_ ? form_() : of_files_;
  encoder_.set_flavor(form.flavor);
  const ObjectLabels labels(objects_, settings_, form.flavor);
  builder_.tell_objects(labels.definitions());
  encoder_.set_labels(labels);
  clock_.set_flavor(form.flavor);
  if (builder_.arcs_undecided()) builder_.decide_arcs(form.arcs);
  note_arcs();
}

void CommandStage::send(const core::Motion& motion) {
  if (refused_) return;
  const auto* layer = std::get_if<core::LayerStart>(&motion);
  if (layer == nullptr) return pass_on(motion);
  if (outputs_.on_layer_time) outputs_.on_layer_time(clock_.seconds());
  pass_on(core::LayerStart{layer->index + layers_before_, layer->top, layer->height});
}

void CommandStage::pass_on(const core::Motion& motion) {
  const std::optional<firmware_link::Command> command = encoder_.encode(motion);
  if (command) {
    ++commands_;
    clock_.add(*command, filament_mm_of(motion));
  }
  if (!outputs_.on_motion(motion, command)) refused_ = true;
}

void CommandStage::tell_missed(const std::string& part, WarningBox& warnings) const {
  const std::optional<core::Length> height = builder_.next_action();
  if (!height) return;
  warnings.put(
      fmt::format("{}: at_height: no layer starts at {:g} mm or above; nothing was done there",
                  part, height->mm()));
}

void CommandStage::tell(GeometryStatistics& statistics) const {
  statistics.filament_mm = builder_.totals().filament_mm;
  statistics.arcs = builder_.totals().arcs;
  statistics.needed = {clock_.needed_mm(), clock_.needed_to_change_mm()};
  statistics.time_s = clock_.seconds();
}

}  // namespace host
