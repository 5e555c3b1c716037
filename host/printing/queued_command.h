// What passes from the geometry to the link: a command, and where in the print it stands.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/roads/road.h"              // kNoObject
#include "core/units.h"                   // LayerIndex, Length
#include "firmware_link/wire/command.h"   // Command
#include "host/files/content_hash.h"      // kHashStart
#include "host/pipeline/checkpoint.h"     // Checkpoint
#include "host/printing/bounded_queue.h"  // BoundedQueue
#include "host/printing/machine_state.h"  // MachineState

namespace host {

// A pause that is part of the print.
struct PlannedPause {
  const char* event;  // what kind of note tells it
  std::string why;
};

struct QueuedCommand {
  firmware_link::Command command;
  core::LayerIndex layer = 0;    // counted from 1; 0: before the first
  core::Length top;              // of the layer
  int object = core::kNoObject;  // of several, whose it is
  bool lays_road = false;
  double filament_mm = 0;  // in roads, from the print's start to here
  double seconds = 0;      // of motion at full speed, likewise

  // Of the layer; null before the first. The hash is of the commands' texts, from the layer's first
  // to this one.
  std::shared_ptr<const Checkpoint> checkpoint;
  std::uint64_t hash = kHashStart;

  // Why to pause before it; null: no pause.
  std::shared_ptr<const PlannedPause> pause;

  // Of the first command of a resumed print: the machine before it. Null elsewhere.
  std::shared_ptr<const MachineState> before;
};

using CommandQueue = BoundedQueue<QueuedCommand>;

}  // namespace host
