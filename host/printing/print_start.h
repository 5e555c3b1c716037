// Whether a print may start, and how much space the machine has for it: as the settings say, and as
// the controller tells, which is believed (machine_space.h).
#pragma once

#include <string>

#include "core/geometry.h"                // Box
#include "core/result.h"                  // Status
#include "core/settings.h"                // Settings
#include "core/units.h"                   // Length
#include "firmware_link/wire/command.h"   // Move
#include "firmware_link/wire/instant.h"   // Instant
#include "host/printing/machine_space.h"  // MachineSpace
#include "host/printing/park_moves.h"     // ParkMoves
#include "host/printing/printer_link.h"   // PrinterLink
#include "host/printing/progress.h"       // Reporter

namespace host {

// The part that is printed, counted from the bed's front left corner.
struct PartExtent {
  core::Box box;        // empty: not known
  core::Length height;  // 0: not known
};

class PrintStart {
 public:
  PrintStart(const core::Settings& settings, const MachineSpace& space, const PartExtent& part);

  // Asks the controller how far its axes go, where it can be asked. True once it has had its chance
  // to answer. REQUIRES: the session is streaming.
  [[nodiscard]] bool travel_asked(PrinterLink& link, firmware_link::Instant now);

  // Takes what it has answered. An error: the part does not fit.
  [[nodiscard]] core::Status take_travel(const firmware_link::Session& session, Reporter& reporter);

  // The settings, with the space that there is.
  [[nodiscard]] const core::Settings& machine() const { return machine_; }
  [[nodiscard]] const ParkMoves& park_moves() const { return park_moves_; }

 private:
  core::Settings settings_;
  MachineSpace space_;
  PartExtent part_;
  core::Settings machine_;
  ParkMoves park_moves_;
  int questions_ = 0;
};

}  // namespace host
