// The plan of a ready G-code file, which is printed as it is.
#pragma once

#include <memory>
#include <string>

#include "core/result.h"             // Result
#include "host/gcode/ready_file.h"   // ReadyFile
#include "host/pipeline/pipeline.h"  // PrintPlan
#include "host/printing/progress.h"  // Reporter
#include "host/settings/options.h"   // Options

namespace host {

// "; the machine's limits are taken to be Marlin's defaults"; "" where its own are known.
[[nodiscard]] std::string assumed_limits_text(const PrintSettings& settings);

// Null: the file is no G-code, but a part. What comes through a pipe is spooled first, to its end.
[[nodiscard]] core::Result<std::shared_ptr<ReadyFile>> open_ready(const Options& options);

// Looks through the whole file, and tells what is known of it. Errors: a line that may not be sent;
// roads beyond a bed or an axis that the user has named.
[[nodiscard]] core::Result<PrintPlan> ready_plan(const Options& options,
                                                 const PrintSettings& settings,
                                                 const std::shared_ptr<ReadyFile>& file,
                                                 Reporter& reporter);

// `rind plan` of it: what it is like, on standard output. Returns the exit code.
[[nodiscard]] int plan_ready(const Options& options, const PrintSettings& settings,
                             const std::shared_ptr<ReadyFile>& file, Reporter& reporter);

}  // namespace host
