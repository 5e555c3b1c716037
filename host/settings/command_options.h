// The options that several commands share: the part and how it is read, the port, reports.
#pragma once

#include "host/settings/options.h"  // Options

namespace CLI {
class App;
}

namespace host {

// REQUIRES of all: `options` outlives the command.
void add_part(CLI::App& command, Options& options);
// What of a part's options `rind resume` has, too.
void add_bad_layer(CLI::App& command, Options& options);
void add_floating(CLI::App& command, Options& options);
void add_memory(CLI::App& command, Options& options);
void add_sorted(CLI::App& command, Options& options);
void add_port(CLI::App& command, Options& options);
void add_reports(CLI::App& command, Options& options);

}  // namespace host
