// Whether the filament that is left on the spool is enough for a print.
//
// What a print needs is known when all of it has been planned. So a print that is told what is left
// is planned as a whole, as by `rind plan`, before anything is heated; a part from a pipe can't be.
#pragma once

#include <optional>
#include <string>

#include "core/result.h"             // Result
#include "core/settings.h"           // Settings
#include "host/printing/progress.h"  // Reporter
#include "host/settings/options.h"   // Options

namespace host {

struct SpoolCheck {
  double left_mm = 0;
  double needed_mm = 0;

  [[nodiscard]] bool enough() const { return needed_mm <= left_mm; }
};

// "12.00 m are left: enough, 2.18 m stay on the spool"
[[nodiscard]] std::string spool_text(const SpoolCheck& check);

// What is left on the spool, in mm; nothing: nobody has said so. Errors: those of spool_mm().
[[nodiscard]] core::Result<std::optional<double>> spool_left_mm(const Options& options,
                                                                const core::Settings& settings);

// Tells whether the spool is enough for the print that the options describe; a person is asked
// where it is not. Nothing: the print may begin; else its exit code. Nothing is told without
// --spool-left.
// COSTS: the time and memory of `rind plan`.
[[nodiscard]] std::optional<int> check_spool(const Options& options, Reporter& reporter);

// All of them can be read twice.
[[nodiscard]] bool rereadable(const Options& options);

}  // namespace host
