#include "host/commands/print_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>
#include <variant>

#include "firmware_link/ports/ports.h"
#include "firmware_link/virtual/virtual_port.h"
#include "host/commands/commands.h"
#include "host/printing/port_clock.h"
#include "host/printing/print_job.h"
#include "host/settings/settings_text.h"  // read_number, trimmed
#include "host/system/exit_codes.h"
#include "host/system/stop_signals.h"

namespace host {
namespace {

using firmware_link::BytePort;

// With nothing to lay and the planner empty for so long, the nozzle leaves the part.
constexpr double kUnderrun_s = 0.3;

// How long the geometry's last layer is waited for when the link has ended.
constexpr double kGeometryGrace_s = 0.1;

bool is_virtual(const Options& options) { return options.port == "virtual"; }

std::unique_ptr<BytePort> open_virtual_port(const Options& options,
                                            const core::Settings& settings) {
  firmware_link::VirtualControllerOptions controller;
  controller.bed_x_mm = settings.bed_x.mm();
  controller.bed_y_mm = settings.bed_y.mm();
  controller.bed_origin_x_mm = settings.bed_origin_x.mm();
  controller.bed_origin_y_mm = settings.bed_origin_y.mm();
  return std::make_unique<firmware_link::VirtualPort>(controller, steady_port_clock(),
                                                      options.virtual_speed);
}

std::unique_ptr<BytePort> opened(const std::string& path, int baud) {
  firmware_link::OpenedPort attempt = firmware_link::open_port(path, baud);
  auto* port = std::get_if<std::unique_ptr<BytePort>>(&attempt);
  return port != nullptr ? std::move(*port) : nullptr;
}

// The same USB device under whatever name it has now, or else the same name.
std::unique_ptr<BytePort> reopened(const Options& options, const std::string& usb) {
  if (!usb.empty()) {
    for (const firmware_link::PortDescription& port : firmware_link::list_ports()) {
      if (port.usb == usb) return opened(port.path, options.baud);
    }
    return nullptr;
  }
  return opened(options.port, options.baud);
}

LostPortOptions lost_port(const Options& options, const std::string& usb, Controls& controls,
                          std::unique_ptr<BytePort>& port) {
  LostPortOptions lost;
  if (options.on_lost_port == OnLostPort::kStop || is_virtual(options)) return lost;
  lost.wait_s = options.lost_port_wait_s;
  lost.reopen = [&options, &port, usb] {
    port.reset();
    return reopened(options, usb);
  };
  lost.takes_height = options.yes;
  lost.nozzle_height = [&options, &controls](std::int64_t z_um) -> std::optional<std::int64_t> {
    if (options.yes) return z_um;
    return ask_nozzle_height(controls, z_um);
  };
  return lost;
}

// How to go on with a print that ended early, or that nothing is left to do so.
void tell_resumable(const Options& options, const JournalKeeper& keeper, Reporter& reporter) {
  const std::string path = keeper.resumable_path();
  if (!path.empty()) {
    reporter.note("resumable",
                  fmt::format("to go on with it: rind resume {} --port {}", path, options.port),
                  {{"journal", path}});
    return;
  }
  const bool kept_by_itself = !is_virtual(options) || !options.journal.empty();
  reporter.note("not_resumable",
                kept_by_itself
                    ? "there is no journal of it: it can't be gone on with"
                    : "there is no journal of it, because the virtual controller keeps one only "
                      "when --journal names it: it can't be gone on with");
}

void tell_end(const Options& options, const PrintOutcome& outcome, const JournalKeeper& keeper,
              Reporter& reporter) {
  report_defects(outcome.geometry.defects, reporter);
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
  const auto begins = [&name](const char* with) { return name.rfind(with, 0) == 0; };
  const bool paced = begins("ttyUSB") || begins("ttyS") || begins("ttyAMA");
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

std::optional<std::int64_t> ask_nozzle_height(Controls& controls, std::int64_t z_um) {
  const std::string question = fmt::format(
      "The controller may have forgotten where the nozzle is. It will be heated, lifted, and X and "
      "Y will be homed; Z will not, the part is in the way.\nMake sure that the nozzle is not "
      "below the part's top, and that its way up and to the end stops is free.\nHow high above the "
      "bed is it now, in mm? Enter for {:.3f}, where it was left; n for no, stop:",
      static_cast<double>(z_um) / 1'000);
  while (true) {
    const std::optional<std::string> answer =
        controls.ask(question, [] { return stop_signal_count() > 0; });
    if (!answer) return std::nullopt;
    const std::string_view text = trimmed(*answer);
    if (text.empty()) return z_um;
    if (text == "n" || text == "no") return std::nullopt;
    const core::Result<double> height = read_number(text, "mm");
    if (height.ok() && height.value() >= 0 && height.value() < 1e7) {
      return std::llround(height.value() * 1'000);
    }
  }
}

MachineSpace told_space(const core::Settings& settings, const Options& told) {
  MachineSpace space = space_of(settings);
  const core::Settings by_default;
  const bool named =
      std::any_of(told.assignments.begin(), told.assignments.end(),
                  [](const auto& pair) { return pair.first == "bed_x" || pair.first == "bed_y"; });
  space.guessed = !named && space.bed_x == by_default.bed_x && space.bed_y == by_default.bed_y;
  return space;
}

int run_print(const Options& options, Job& job, JournalKeeper& keeper, RunExtras extras,
              double began_s, Reporter& reporter) {
  std::unique_ptr<BytePort> port;
  if (is_virtual(options)) {
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
    port = std::get<std::unique_ptr<BytePort>>(std::move(attempt));
  }

  set_at_stake(true);
  PrintOutcome outcome;
  {
    Controls controls(options.part != "-");
    PrintRequest request{job, *port, reporter, stop_urgency, began_s};
    request.geometry_grace_s = kGeometryGrace_s;
    request.link.request = [&controls] { return controls.next(); };
    request.link.journal = [&keeper] { return keeper.journal(); };
    request.link.may_begin = [&keeper, &reporter] { return keeper.reserve(reporter); };
    request.link.hot_s = options.pause_heat_s;
    // A virtual controller's seconds may be others than geometry's.
    request.link.underrun_s = is_virtual(options) && options.virtual_speed != 1 ? 0 : kUnderrun_s;
    request.link.lost_port = lost_port(options, extras.usb, controls, port);
    request.link.space = extras.space;
    request.link.resumption = std::move(extras.resumption);
    if (controls.has_keys()) reporter.note("keys", key_help());
    outcome = print_part(request);
  }
  set_at_stake(false);
  keeper.drop_if_empty();
  tell_end(options, outcome, keeper, reporter);
  const int exit_code =
      save_statistics(options, outcome.geometry, &outcome.link, outcome.exit_code, reporter);
  if (!outcome.geometry.ended) {
    // The geometry still computes, and uses what lies below on the stack: nothing of it goes.
    port.reset();
    reporter.clear();
    _exit(exit_code);
  }
  return exit_code;
}

}  // namespace host
