// All settings of a run: the profile, what was typed after it, and the user's G-code filled in.
//
// What a profile asks for and rind does not do is named. What a print can't do without and that
// could not be read, the bed and the start and end G-code, is an error, unless the user takes what
// is left (`lax`) or has set it otherwise.
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
  std::vector<std::string> notes;  // what the profile's print has and this one has not
};

[[nodiscard]] core::Result<WholeSettings> whole_settings(const SettingsRequest& request);

}  // namespace host
