// Which prints can be resumed, and which of them the user means.
#pragma once

#include <string>

#include "core/result.h"             // Result
#include "host/printing/progress.h"  // Reporter
#include "host/settings/options.h"   // Options

namespace host {

// `rind resume` without a name: part, layer, time, journal, and whether the part is unchanged, on
// standard output; as JSON with --json. COSTS: reads each part that is there once.
// Returns the exit code.
[[nodiscard]] int list_journals(const Options& options, Reporter& reporter);

// The journal with that path, or of the part with that path or file name. An error tells what
// there is instead.
[[nodiscard]] core::Result<std::string> journal_named(const std::string& name);

}  // namespace host
