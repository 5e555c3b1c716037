#include "host/printing/queue_filler.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <variant>

#include "firmware_link/wire/line_codec.h"  // encode
#include "host/pipeline/wire_units.h"       // kUnitsPerUm

namespace host {
namespace {

constexpr const char* kOtherPrint =
    "the print that is computed now is not the one that was started: its commands differ; it can't "
    "be resumed";

}  // namespace

QueueFiller::QueueFiller(CommandQueue& queue, const core::Settings& settings,
                         const JournalRecord* resumed)
    : queue_(queue), resumed_(resumed) {
  if (resumed_ == nullptr) return;
  number_ = resumed_->checkpoint.commands;
  next_.filament_mm = resumed_->checkpoint.filament_mm;
  machine_ = state_at(resumed_->checkpoint, settings);
}

void QueueFiller::start_layer(const Checkpoint& checkpoint) {
  next_.checkpoint = std::make_shared<const Checkpoint>(checkpoint);
  next_.hash = kHashStart;
}

void QueueFiller::pause(const std::string& why) {
  next_.pause = std::make_shared<const PlannedPause>(
      PlannedPause{"bad_layer", why + "; resume to print what could be repaired, or else stop"});
}

void QueueFiller::add_line(core::Point to, double speed_mm_s) {
  if (position_ && speed_mm_s > 0) {
    const double dx = static_cast<double>(to.x) - position_->x;
    const double dy = static_cast<double>(to.y) - position_->y;
    next_.seconds += std::hypot(dx, dy) / core::kUnitsPerMm / speed_mm_s;
  }
  position_ = to;
}

void QueueFiller::note(const core::Motion& motion) {
  next_.lays_road = false;
  if (const auto* layer = std::get_if<core::LayerStart>(&motion)) {
    next_.layer = layer->index + 1;
    next_.top = layer->top;
  } else if (const auto* extrude = std::get_if<core::Extrude>(&motion)) {
    next_.lays_road = true;
    next_.filament_mm += extrude->filament_mm;
    add_line(extrude->to, extrude->speed_mm_s);
  } else if (const auto* arc = std::get_if<core::ExtrudeArc>(&motion)) {
    next_.lays_road = true;
    next_.filament_mm += arc->filament_mm;
    next_.seconds += arc->length_mm / arc->speed_mm_s;
    position_ = arc->to;
  } else if (const auto* object = std::get_if<core::ObjectStart>(&motion)) {
    next_.object = object->object;
  } else if (std::holds_alternative<core::ObjectEnd>(motion)) {
    next_.object = core::kNoObject;
  } else if (const auto* travel = std::get_if<core::Travel>(&motion)) {
    add_line(travel->to, travel->speed_mm_s);
  } else if (const auto* wipe = std::get_if<core::Wipe>(&motion)) {
    add_line(wipe->to, wipe->speed_mm_s);
  } else if (const auto* pause = std::get_if<core::Pause>(&motion)) {
    next_.pause = std::make_shared<const PlannedPause>(PlannedPause{
        "planned_pause",
        fmt::format("pause at {:g} mm, as at_height says; resume to go on", pause->height.mm())});
  }
}

bool QueueFiller::take(const core::Motion& motion,
                       const std::optional<firmware_link::Command>& command) {
  note(motion);
  return !command || put(*command);
}

bool QueueFiller::take_ready(const ReadyCommand& command, const FilePlace& behind) {
  next_.layer = behind.layer;
  next_.top = core::Length::from_units(behind.top_um * kUnitsPerUm);
  next_.lays_road = command.lays_road;
  next_.filament_mm = behind.filament_mm;
  next_.seconds = behind.seconds;
  return put(command.meaning.line);
}

bool QueueFiller::put(const firmware_link::Command& command) {
  if (resumed_ != nullptr && number_ == resumed_->sure) {
    if (!finish()) return false;
    next_.before = std::make_shared<const MachineState>(machine_);
    resumed_ = nullptr;
  }
  firmware_link::TextBuffer buffer;
  next_.hash = hash_of("\n", hash_of(firmware_link::encode(command, buffer), next_.hash));
  last_hash_ = next_.hash;
  ++number_;
  if (resumed_ != nullptr) {
    machine_.apply(command);
    next_.pause = nullptr;
    return true;
  }
  next_.command = command;
  seconds_made_.store(next_.seconds);
  const bool queued = queue_.push(next_, sizeof next_);
  next_.before = nullptr;
  next_.pause = nullptr;
  return queued;
}

bool QueueFiller::finish() {
  if (resumed_ == nullptr) return true;
  // The record's hash is of its own layer's commands, up to the last one.
  if (number_ < resumed_->sure || last_hash_ != resumed_->sure_hash) error_ = kOtherPrint;
  return !error_;
}

}  // namespace host
