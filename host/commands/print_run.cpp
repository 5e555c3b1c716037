#include "host/commands/print_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>
#include <variant>

#include "firmware_link/ports/ports.h"
#include "firmware_link/virtual/virtual_port.h"
#include "host/commands/commands.h"
#include "host/commands/program_control.h"
#include "host/printing/port_clock.h"
#include "host/printing/print_part.h"
#include "host/printing/virtual_machine.h"
#include "host/system/exit_codes.h"
#include "host/system/limits.h"
#include "host/system/stop_signals.h"

namespace host {
namespace {

using firmware_link::BytePort;

// How long the geometry may take for its last layer when the link has ended.
constexpr double kGeometryGrace_s = 0.1;

bool is_virtual(const Options& options) { return options.link.port == "virtual"; }

std::unique_ptr<BytePort> open_virtual_port(const Options& options,
                                            const core::Settings& settings) {
  return std::make_unique<firmware_link::VirtualPort>(
      virtual_machine(settings), steady_port_clock(), options.link.virtual_speed);
}

// How to resume a print that ended early, or why it can't be resumed.
void tell_resumable(const Options& options, const JournalKeeper& keeper, Reporter& reporter) {
  const std::string path = keeper.resumable_path();
  if (!path.empty()) {
    reporter.note("resumable",
                  fmt::format("to resume it: rind resume {} --port {}", path, options.link.port),
                  {{"journal", path}});
    return;
  }
  const bool kept_by_default = !is_virtual(options) || !options.print.journal.empty();
  reporter.note("not_resumable",
                kept_by_default
                    ? "there is no journal of it: it can't be resumed"
                    : "there is no journal of it, because the virtual controller keeps one only "
                      "when --journal names it: it can't be resumed");
}

void tell_end(const Options& options, const PrintOutcome& outcome, const JournalKeeper& keeper,
              Reporter& reporter) {
  report_defects(outcome.geometry.defects, reporter);
  report_hanging(outcome.geometry.hanging, reporter);
  if (outcome.exit_code == kExitDone) {
    reporter.note("done", outcome.message,
                  {{"layers", outcome.geometry.layers},
                   {"filament_mm", total_mm(outcome.geometry.filament_mm)},
                   {"stalls", outcome.link.stalls},
                   {"resends", outcome.link.resends},
                   {"parks", outcome.link.parks},
                   {"recoveries", outcome.link.recoveries}});
    return;
  }
  reporter.error(outcome.message, outcome.exit_code);
  tell_resumable(options, keeper, reporter);
}

}  // namespace

double line_time_ms(const std::string& port, int baud) {
  constexpr double kLineBits = 360;  // a move in a circle's perimeter: 35 bytes and its end
  constexpr double kUse = 0.9;       // of the line; the rest is for repeats and questions
  std::error_code error;
  const std::filesystem::path real = std::filesystem::weakly_canonical(port, error);
  const std::string name = real.filename().string();
  const auto starts_with = [&name](const char* with) { return name.rfind(with, 0) == 0; };
  const bool paced = starts_with("ttyUSB") || starts_with("ttyS") || starts_with("ttyAMA");
  return paced && baud > 0 ? 1'000 * kLineBits / kUse / baud : 0;
}

std::string usb_of(const std::string& port) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::weakly_canonical(port, error);
  for (const firmware_link::PortDescription& each : firmware_link::list_ports()) {
    if (each.path == real.string()) return each.usb;
  }
  return {};
}

MachineSpace space_in(const core::Settings& settings, const Options& options) {
  MachineSpace space = space_of(settings);
  const core::Settings by_default;
  const bool named =
      std::any_of(options.settings.assignments.begin(), options.settings.assignments.end(),
                  [](const auto& pair) { return pair.first == "bed_x" || pair.first == "bed_y"; });
  space.guessed = !named && space.bed_x == by_default.bed_x && space.bed_y == by_default.bed_y;
  return space;
}

int run_print(const Options& options, PrintPlan& print_plan, JournalKeeper& keeper,
              const RunExtras& extras, double started_s, Reporter& reporter) {
  std::unique_ptr<BytePort> port;
  if (is_virtual(options)) {
    port = open_virtual_port(options, print_plan.settings);
    reporter.note(
        "virtual",
        "printing to the virtual controller inside this program: nothing real is printed");
  } else {
    firmware_link::OpenedPort attempt =
        firmware_link::open_port(options.link.port, options.link.baud);
    if (const auto* error = std::get_if<firmware_link::PortError>(&attempt)) {
      reporter.error(options.link.port + ": " + error->cause + "; " + error->remedy,
                     kExitLinkFault);
      return kExitLinkFault;
    }
    port = std::get<std::unique_ptr<BytePort>>(std::move(attempt));
  }

  set_at_stake(true);
  PrintOutcome outcome;
  {
    Controls controls(options.part.path != "-");
    ProgramControl control({options, controls, keeper, port, reporter}, extras.usb);
    PrintRequest request{print_plan, *port, control, reporter};
    request.started_s = started_s;
    request.geometry_grace_s = kGeometryGrace_s;
    request.options.hot_s = options.print.pause_heat_s;
    // A virtual controller's seconds may be others than geometry's.
    request.options.underrun_s =
        is_virtual(options) && options.link.virtual_speed != 1 ? 0 : kUnderrun_s;
    const bool waits = options.link.on_lost_port != OnLostPort::kStop && !is_virtual(options);
    request.options.lost_port_wait_s = waits ? options.link.lost_port_wait_s : 0;
    request.options.space = extras.space;
    request.options.spool_left_mm = extras.spool_left_mm;
    request.options.resumption = extras.resumption;
    if (controls.has_keys()) reporter.note("keys", key_help());
    outcome = print_part(request);
  }
  set_at_stake(false);
  keeper.drop_if_empty();
  tell_end(options, outcome, keeper, reporter);
  const int exit_code =
      save_statistics(options, outcome.geometry, &outcome.link, outcome.exit_code, reporter);
  if (!outcome.geometry.ended) {
    // The geometry still computes, and uses objects on this stack: none of them may be destroyed.
    port.reset();
    reporter.clear();
    _exit(exit_code);
  }
  return exit_code;
}

}  // namespace host
