// What several objects are called, for the controller: commands that say which of them is printed.
//
//     Marlin           M486 S0                           M486 S-1
//     RepRapFirmware   the same
//     Klipper          EXCLUDE_OBJECT_START NAME=part_1  EXCLUDE_OBJECT_END NAME=part_1
//
// Sources: PrusaSlicer's and Klipper's documentation of these commands.
#pragma once

#include <string>
#include <vector>

#include "core/settings.h"               // Settings
#include "firmware_link/wire/command.h"  // Flavor
#include "host/part/opened_part.h"       // PartObject

namespace host {

class ObjectLabels {
 public:
  // None: what is printed is not told.
  ObjectLabels() = default;
  // As the settings and the firmware want it.
  ObjectLabels(const std::vector<PartObject>& objects, const core::Settings& settings,
               firmware_link::Flavor flavor);

  // Lines that name all objects, to be sent before the first of them.
  [[nodiscard]] const std::vector<std::string>& definitions() const { return definitions_; }

  // The line that says that this object follows, or that it ends; empty: nothing is told.
  [[nodiscard]] std::string start(int object) const;
  [[nodiscard]] std::string end(int object) const;

 private:
  firmware_link::Flavor flavor_ = firmware_link::Flavor::kMarlin;
  std::vector<std::string> names_;  // empty: nothing is told
  std::vector<std::string> definitions_;
};

}  // namespace host
