// What `print` and `resume` have in common, once the plan is known: port, journal, keys, the
// print itself, and its end.
#pragma once

#include <optional>
#include <string>

#include "host/commands/journal_keeper.h"  // JournalKeeper
#include "host/pipeline/pipeline.h"        // PrintPlan
#include "host/printing/machine_space.h"   // MachineSpace
#include "host/printing/print_recovery.h"  // Resumption
#include "host/printing/progress.h"        // Reporter
#include "host/settings/options.h"         // Options

namespace host {

// Which USB device a port is, as `rind ports` tells; empty: none, or not known.
[[nodiscard]] std::string usb_of(const std::string& port);

// How long a usual move's line takes through a serial port at that baud, with a little to spare. 0
// where the baud does not say how fast the port is: USB devices without a serial chip (ttyACM),
// pseudo-terminals, networks, the virtual controller.
[[nodiscard]] double line_time_ms(const std::string& port, int baud);

// Where the machine can move by the settings. It is guessed where neither the command line nor a
// profile says more than the defaults.
[[nodiscard]] MachineSpace space_in(const core::Settings& settings, const Options& options);

// What of a print is not in its options. REQUIRES: options.link.port is not empty.
struct RunExtras {
  std::string usb;  // of the port (usb_of)
  MachineSpace space;
  std::optional<Resumption> resumption;
  std::optional<double> spool_left_mm = std::nullopt;  // nothing: nobody has said so
};
[[nodiscard]] int run_print(const Options& options, PrintPlan& print_plan, JournalKeeper& keeper,
                            const RunExtras& extras, double started_s, Reporter& reporter);

}  // namespace host
