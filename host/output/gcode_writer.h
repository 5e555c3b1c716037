// Writes commands as the text of a .gcode file: one line for each command, exactly as it would be
// sent, and the comments of PrusaSlicer, by which its viewer and others colour roads:
//
//     ;LAYER_CHANGE           ;TYPE:External perimeter
//     ;Z:0.4                  ;WIDTH:0.45
//     ;HEIGHT:0.2             G1 X10.5 Y3 E0.0123      a bridge is as high as it is wide: round
//     ;BEFORE_LAYER_CHANGE
//     ;0.4
//
// Without its comments and its pauses, the file is what `rind print` sends.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/motions/motion.h"         // Motion
#include "firmware_link/wire/command.h"  // Command

namespace host {

class GcodeWriter {
 public:
  // Comments say what belongs to which of these objects (PartSummary::objects), as PrusaSlicer's
  // for OctoPrint.
  void name_objects(std::vector<std::string> names) { objects_ = std::move(names); }

  // `pause_gcode`: lines that stand for a pause, which a print makes by itself.
  // REQUIRES: check_user_gcode() was fine.
  explicit GcodeWriter(std::vector<std::string> pause_gcode = {})
      : pause_gcode_(std::move(pause_gcode)) {}

  // Appends the text for a motion and its command (from MotionEncoder).
  // COSTS: at most three short lines besides the command's own.
  void write(const core::Motion& motion, const std::optional<firmware_link::Command>& command,
             std::string& into);

 private:
  void write_road(core::RoadKind kind, core::Length width, core::Length height, std::string& into);

  void write_object(int object, bool starts, std::string& into) const;
  void write_pause(std::string& into) const;

  std::vector<std::string> pause_gcode_;
  std::vector<std::string> objects_;
  std::optional<core::RoadKind> kind_;  // as last written; nullopt at a layer's start
  core::Length width_, height_;
  core::Length layer_height_;
};

// PrusaSlicer's name for the kind, as in its ";TYPE:" comments.
[[nodiscard]] const char* prusa_type_name(core::RoadKind kind);

}  // namespace host
