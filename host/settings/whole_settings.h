// Combines all settings of a run: the printer's, the profile, then the settings typed after it,
// then the placeholders in the user's G-code.
//
// Settings of a profile that rind does not support are named. If the bed or the start and end
// G-code could not be read, that is an error, unless the user does without them (`lax`) or sets
// them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"                       // Result
#include "host/pipeline/print_settings.h"      // PrintSettings
#include "host/settings/gcode_placeholders.h"  // GcodeOrigin
#include "host/settings/placeholder_values.h"  // PartFacts
#include "host/settings/settings_file.h"       // LoadedSettings
#include "host/settings/starting_settings.h"   // PrinterRequest

namespace host {

// The choice from a bundle that the profile's content offers; it is then taken out of `printer`,
// and no printer's file is read.
[[nodiscard]] ProfileChoice choice_for(std::string_view profile, PrinterRequest& printer);

struct SettingsRequest {
  std::string profile;  // a file; empty: none
  bool lax = false;
  std::vector<std::pair<std::string, std::string>> assignments;  // in the order they were typed
  PrinterRequest printer = {};  // what the profile and the assignments are laid over
};

// G-code whose placeholders ask for what only a part gives (max_layer_z).
struct PendingGcode {
  std::string key;
  std::string place;  // "file:line"; empty for the user's own
  std::vector<std::string> lines;
  GcodeOrigin origin = GcodeOrigin::kProfile;
};

struct WholeSettings {
  PrintSettings settings;             // ENSURES: validate_settings() is fine
  bool bed_known = false;             // somebody has said how large the bed is
  std::vector<std::string> notes;     // what the profile's print would have and this one has not
  std::vector<PendingGcode> pending;  // not in `settings` before fill_for_part()
  std::shared_ptr<const LoadedSettings> profile;  // null without one
};

[[nodiscard]] core::Result<WholeSettings> whole_settings(const SettingsRequest& request);

// Fills in what waits for a part. Nothing pends afterwards.
core::Status fill_for_part(const SettingsRequest& request, const PartFacts& part,
                           WholeSettings& whole);

}  // namespace host
