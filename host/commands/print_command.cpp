#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "firmware_link/ports.h"
#include "firmware_link/virtual/virtual_port.h"
#include "host/commands/commands.h"
#include "host/exit_codes.h"
#include "host/port_clock.h"
#include "host/print_job.h"
#include "host/stop_signals.h"

namespace host {
namespace {

std::unique_ptr<firmware_link::BytePort> open_virtual_port(const Options& options,
                                                           const core::Settings& settings) {
  firmware_link::VirtualControllerOptions controller;
  controller.bed_x_mm = settings.bed_x.mm();
  controller.bed_y_mm = settings.bed_y.mm();
  return std::make_unique<firmware_link::VirtualPort>(controller, steady_port_clock(),
                                                      options.virtual_speed);
}

std::string no_port_message() {
  std::string message = "no port named; ";
  const std::vector<firmware_link::PortDescription> ports = firmware_link::list_ports();
  message += ports.empty() ? "no serial port was found" : "there are:";
  for (const firmware_link::PortDescription& port : ports) {
    message += "\n  --port " + port.path + "  " + port.description +
               (port.usb.empty() ? "" : "  " + port.usb);
  }
  return message + "\n  --port virtual  a controller inside this program; nothing real is printed";
}

}  // namespace

int print_command(const Options& options, Reporter& reporter) {
  const double began_s = steady_seconds();
  if (options.port.empty()) {
    reporter.error(no_port_message(), kExitUsage);
    return kExitUsage;
  }
  core::Result<Job> opened = open_job(options, reporter);
  if (!opened.ok()) return fail(opened.error(), reporter);
  Job& job = opened.value();

  std::unique_ptr<firmware_link::BytePort> port;
  if (options.port == "virtual") {
    port = open_virtual_port(options, job.settings);
    reporter.note(
        "virtual",
        "printing to the virtual controller inside this program: nothing real is printed");
  } else {
    firmware_link::OpenedPort attempt = firmware_link::open_port(options.port, options.baud);
    if (const auto* error = std::get_if<firmware_link::PortError>(&attempt)) {
      reporter.error(options.port + ": " + error->cause + "; " + error->remedy, kExitLinkFault);
      return kExitLinkFault;
    }
    port = std::get<std::unique_ptr<firmware_link::BytePort>>(std::move(attempt));
  }

  set_at_stake(true);
  const PrintOutcome outcome = print_part({job, *port, reporter, stop_signal_count, began_s});
  set_at_stake(false);
  report_defects(outcome.geometry.defects, reporter);
  if (outcome.exit_code == kExitDone) {
    reporter.note("done", outcome.message,
                  {{"layers", outcome.geometry.layers},
                   {"filament_mm", total_mm(outcome.geometry.filament_mm)},
                   {"stalls", outcome.link.stalls},
                   {"resends", outcome.link.resends}});
  } else {
    reporter.error(outcome.message, outcome.exit_code);
  }
  return save_statistics(options, outcome.geometry, &outcome.link, outcome.exit_code, reporter);
}

}  // namespace host
