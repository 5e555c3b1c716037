// Combines all settings of a run: the profile, then the settings typed after it, then the
// placeholders in the user's G-code.
//
// Settings of a profile that rind does not support are named. If the bed or the start and end
// G-code could not be read, that is an error, unless the user does without them (`lax`) or sets
// them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/result.h"                   // Result
#include "host/pipeline/print_settings.h"  // PrintSettings

namespace host {

struct SettingsRequest {
  std::string profile;  // a file; empty: none
  bool lax = false;
  std::vector<std::pair<std::string, std::string>> assignments;  // in the order they were typed
};

struct WholeSettings {
  PrintSettings settings;          // ENSURES: validate_settings() is fine
  std::vector<std::string> notes;  // what the profile's print would have and this one has not
};

[[nodiscard]] core::Result<WholeSettings> whole_settings(const SettingsRequest& request);

}  // namespace host
