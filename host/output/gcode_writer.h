// Commands and the marks between them as the text of a .gcode file: one line a command, exactly as
// it would be sent, and PrusaSlicer's comments, which its viewer and others colour roads by:
//
//     ;LAYER_CHANGE           ;TYPE:External perimeter
//     ;Z:0.4                  ;WIDTH:0.45
//     ;HEIGHT:0.2             G1 X10.5 Y3 E0.0123
//
// Stripped of comments, the file is what `rind print` sends.
#pragma once

#include <optional>
#include <string>

#include "core/motions/motion.h"         // Motion
#include "firmware_link/wire/command.h"  // Command

namespace host {

class GcodeWriter {
 public:
  // Appends what a motion and its command (from MotionEncoder) are in the file.
  // COSTS: at most three short lines more than the command's own.
  void write(const core::Motion& motion, const std::optional<firmware_link::Command>& command,
             std::string& into);

 private:
  std::optional<core::RoadKind> kind_;  // as last written; nothing after a layer's begin
  core::Length width_;
};

// ";TYPE:" as PrusaSlicer names it.
[[nodiscard]] const char* prusa_type_name(core::RoadKind kind);

}  // namespace host
