#include "host/printing/print_part.h"

#include <fmt/format.h>

#include <exception>
#include <utility>

#include "host/printing/geometry_thread.h"
#include "host/system/exit_codes.h"
#include "host/system/stage_clock.h"  // steady_seconds

namespace host {
namespace {

std::string where(const LinkOutcome& link, core::LayerIndex layers) {
  if (link.layer == 0) return "before the first road";
  const std::string of = layers > 0 ? fmt::format(" of {}", layers) : "";
  return fmt::format("at layer {}{}, height {:.2f} mm", link.layer, of, link.height.mm());
}

std::string told(const std::string& message, const std::string& measures) {
  return measures.empty() ? message : message + "; " + measures;
}

// A resumed print has laid the rest.
std::string done_text(const GeometryStatistics& statistics, core::LayerIndex layers, bool resumed,
                      double took_s) {
  const std::string of = resumed && layers > 0 ? fmt::format(" of {}", layers) : "";
  return fmt::format("printed {}{}{} layers, {:.2f} m of filament in {}",
                     resumed ? "the rest: " : "", statistics.layers, of,
                     total_mm(statistics.filament_mm) / 1'000, duration_text(took_s));
}

void conclude(const LinkOutcome& link, const GeometryOutcome& geometry, core::LayerIndex layers,
              PrintOutcome& outcome) {
  switch (link.end) {
    case LinkEnd::kDone:
      outcome.exit_code = kExitDone;
      return;
    case LinkEnd::kUserStopped:
    case LinkEnd::kUserHalted:
      outcome.exit_code = kExitStopped;
      outcome.message = told("stopped " + where(link, layers), link.measures);
      return;
    case LinkEnd::kGeometryEnded:
      outcome.exit_code = kExitBadInput;
      outcome.message = geometry.error.value_or("the geometry ended early");
      if (link.layer > 0 || !link.measures.empty()) {
        outcome.message = told(outcome.message + "; stopped " + where(link, layers), link.measures);
      }
      return;
    case LinkEnd::kRefused:
      outcome.exit_code = kExitBadInput;
      outcome.message = told(link.reason, link.measures);
      return;
    case LinkEnd::kFaulted:
      outcome.exit_code = kExitLinkFault;
      outcome.message = told(link.reason + "; stopped " + where(link, layers), link.measures);
      return;
  }
}

}  // namespace

PrintOutcome print_part(const PrintRequest& request) {
  const std::optional<Resumption>& resumption = request.options.resumption;
  // Before the thread starts, which may read more of the part.
  const PartExtent part{request.print_plan.part.summary.box,
                        request.print_plan.part.summary.height};
  GeometryThread thread(request.print_plan, resumption ? &resumption->record : nullptr,
                        request.reporter);
  PrintOptions options = request.options;
  const ReadyFile* ready = request.print_plan.ready.get();
  options.count_filament = ready == nullptr || ready->summary().counts_filament;
  PrintController controller(request.print_plan.settings, options, part,
                             {request.port, thread, request.control, request.reporter},
                             request.started_s);
  LinkOutcome link;
  try {
    link = controller.run();
  } catch (const std::exception& error) {
    // The session's state is not to be trusted any more; its controller is made safe from outside.
    link = controller.emergency(error.what());
  }
  GeometryOutcome geometry = thread.end(request.geometry_grace_s);
  for (const std::string& warning : thread.signals().warnings.take()) {
    request.reporter.note("warning", warning);
  }

  PrintOutcome outcome;
  conclude(link, geometry, thread.signals().layers.load(), outcome);
  if (link.end == LinkEnd::kDone) {
    outcome.message = done_text(geometry.statistics, thread.signals().layers.load(),
                                resumption.has_value(), steady_seconds() - request.started_s);
  }
  outcome.geometry = std::move(geometry.statistics);
  outcome.link = controller.statistics();
  return outcome;
}

}  // namespace host
