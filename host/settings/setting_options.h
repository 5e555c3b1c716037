// The options of every command with settings: --profile, --set, and shortcuts for single settings.
#pragma once

#include "host/settings/options.h"  // Options

namespace CLI {
class App;
}

namespace host {

// REQUIRES: `options` outlives the command.
void add_settings(CLI::App& command, Options& options);

}  // namespace host
