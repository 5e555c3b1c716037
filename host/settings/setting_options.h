// The options of commands with settings: --profile, --set, shortcuts for single settings; and those
// that choose a printer.
#pragma once

#include "host/settings/options.h"  // Options

namespace CLI {
class App;
}

namespace host {

// REQUIRES: `options` outlives the command.
void add_settings(CLI::App& command, Options& options);

// What of them `rind setup` has: --preset, --printer, --filament, --quality; --set.
void add_printer(CLI::App& command, Options& options);
void add_assignments(CLI::App& command, Options& options);

}  // namespace host
