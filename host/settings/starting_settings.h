// The settings that a profile and the command line are laid over: rind's defaults, then those of a
// printer.
//
//     --preset NAME          a printer's preset (presets/presets.h); no file of a printer is read
//     --printer NAME         a file that `rind setup` wrote (presets/printer_file.h); without a
//                            name printer.ini, if it is there; "none": none
//     --filament, --quality  presets instead of those that the printer's file names
//
// In this order, the last one counts: the printer's preset, its file's filament and quality, its
// file's settings, then the filament and the quality of the command line.
#pragma once

#include <optional>
#include <string>

#include "core/result.h"                   // Result
#include "host/pipeline/print_settings.h"  // PrintSettings
#include "host/presets/printer_file.h"     // PrinterFile

namespace host {

// As they were typed; empty where nothing was.
struct PrinterRequest {
  std::string printer;
  std::string preset;
  std::string filament;
  std::string quality;
  std::optional<PrinterFile> given = {};  // a printer's file that is not read from the disk
};

struct StartingSettings {
  PrintSettings settings;
  bool bed_known = false;  // a preset or a printer's file says how large the bed is
  std::string port;        // as in the printer's file; may be empty
  int baud = 0;            // 0: it says nothing
};

[[nodiscard]] core::Result<StartingSettings> starting_settings(const PrinterRequest& request);

}  // namespace host
