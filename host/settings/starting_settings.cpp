#include "host/settings/starting_settings.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "host/presets/presets.h"
#include "host/presets/printer_file.h"
#include "host/settings/settings_file.h"
#include "host/system/text.h"  // lower_case

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;

// The name without what people add to it: "0.2mm" is "0.2", "PETG" is "petg".
std::string plain_name(PresetKind kind, const std::string& typed) {
  std::string name = typed;
  if (kind == PresetKind::kQuality && name.size() > 2 && name.ends_with("mm")) {
    name.resize(name.size() - 2);
  }
  return lower_case(name);
}

class Start {
 public:
  // Lays a preset's settings over what is there. Empty: none.
  Status lay(PresetKind kind, const std::string& name) {
    if (name.empty()) return {};
    const Result<Preset> preset = find_preset(kind, plain_name(kind, name));
    if (!preset.ok()) return preset.error();
    const std::string& own_name = preset.value().name;
    if (kind == PresetKind::kPrinter) start_.settings.printer_name = own_name;
    if (kind == PresetKind::kFilament) start_.settings.filament_name = own_name;
    return lay(preset.value().settings, fmt::format("preset {}", own_name));
  }

  Status lay(std::string_view settings, const std::string& name) {
    Result<LoadedSettings> loaded = read_settings(settings, name, start_.settings);
    if (!loaded.ok()) return loaded.error();
    start_.settings = std::move(loaded.value().settings);
    start_.bed_known = start_.bed_known || loaded.value().bed_told;
    return {};
  }

  Status lay(const PrinterFile& printer, const PrinterRequest& request) {
    start_.port = printer.port;
    start_.baud = printer.baud;
    if (Status laid = lay(PresetKind::kPrinter, printer.preset); !laid.ok()) {
      return Error{laid.error().code, printer.path + ": " + laid.error().message};
    }
    for (const auto& [kind, of_file, typed] :
         {std::tuple(PresetKind::kFilament, &printer.filament, &request.filament),
          std::tuple(PresetKind::kQuality, &printer.quality, &request.quality)}) {
      if (!typed->empty()) continue;
      if (Status laid = lay(kind, *of_file); !laid.ok()) {
        return Error{laid.error().code, printer.path + ": " + laid.error().message};
      }
    }
    return lay(printer.settings, printer.path);
  }

  StartingSettings& settings() { return start_; }

 private:
  StartingSettings start_;
};

}  // namespace

Result<StartingSettings> starting_settings(const PrinterRequest& request) {
  Start start;
  if (!request.preset.empty()) {
    if (!request.printer.empty() && request.printer != kNoPrinter) {
      return Error{ErrorCode::kBadSetting,
                   "--preset and --printer both say which printer it is: leave one of them out"};
    }
    if (Status laid = start.lay(PresetKind::kPrinter, request.preset); !laid.ok()) {
      return laid.error();
    }
  } else {
    const Result<std::optional<PrinterFile>> printer =
        request.given ? request.given : find_printer(request.printer);
    if (!printer.ok()) return printer.error();
    if (printer.value()) {
      if (Status laid = start.lay(*printer.value(), request); !laid.ok()) return laid.error();
    }
  }
  Status laid = start.lay(PresetKind::kFilament, request.filament);
  if (laid.ok()) laid = start.lay(PresetKind::kQuality, request.quality);
  if (!laid.ok()) return laid.error();
  return std::move(start.settings());
}

}  // namespace host
