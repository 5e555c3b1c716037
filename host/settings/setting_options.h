// The options that every command with settings has: --profile, --set, and the short ways to set
// one.
#pragma once

#include "host/settings/options.h"  // Options

namespace CLI {
class App;
}

namespace host {

// `options` outlives the command.
void add_settings(CLI::App& command, Options& options);

}  // namespace host
