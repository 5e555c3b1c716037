// Prints a part: geometry on a thread of its own, the link on the caller's, one queue between.
//
//     GeometryThread ──> [ bounded queue ] ──> PrintController ──> port
//     its own thread                           caller's thread
//
// Whatever ends one side ends the other: an error of the part closes the queue and the link brings
// the printer to a safe end; a fault of the link closes the queue and the geometry gives up. The
// link never waits for the geometry: a safe stop takes no longer where a layer takes minutes.
#pragma once

#include <optional>
#include <string>

#include "firmware_link/ports/byte_port.h"   // BytePort
#include "host/pipeline/pipeline.h"          // PrintPlan
#include "host/pipeline/statistics.h"        // GeometryStatistics, LinkStatistics
#include "host/printing/print_control.h"     // PrintControl
#include "host/printing/print_controller.h"  // PrintOptions
#include "host/printing/progress.h"          // Reporter

namespace host {

struct PrintRequest {
  PrintPlan& print_plan;
  firmware_link::BytePort& port;
  PrintControl& control;
  Reporter& reporter;
  PrintOptions options = {};
  double started_s = 0;  // steady_seconds() when the program started
  // How long the geometry may take to end when the link has; it can't be interrupted within a
  // layer. nullopt: as long as it takes. REQUIRES: when it is left behind (PrintOutcome), the
  // program ends without touching the plan, the reporter or the standard library's exit any more.
  std::optional<double> geometry_grace_s = std::nullopt;
};

struct PrintOutcome {
  int exit_code = 0;
  std::string message;  // one line: what was printed, or where and why it ended and what was done
  GeometryStatistics geometry;  // `ended` false: it was left behind, and runs on
  LinkStatistics link;
};

[[nodiscard]] PrintOutcome print_part(const PrintRequest& request);

}  // namespace host
