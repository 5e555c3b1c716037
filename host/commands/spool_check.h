// Whether the filament that is left on the spool is enough for a print.
//
// What a print needs is known when all of it has been planned. So a print that is told what is left
// is planned as a whole, as by `rind plan`, before anything is heated; a part from a pipe can't be.
#pragma once

#include <optional>
#include <string>

#include "core/result.h"             // Result
#include "core/settings.h"           // Settings
#include "host/pipeline/pipeline.h"  // PrintPlan
#include "host/printing/progress.h"  // Reporter
#include "host/settings/options.h"   // Options

namespace host {

struct SpoolCheck {
  double left_mm = 0;
  double needed_mm = 0;
  bool until_change = false;  // it is what is needed up to an M600, which asks for a new spool

  [[nodiscard]] bool enough() const { return needed_mm <= left_mm; }
};

// What is needed of the spool at hand. `to_change_mm`: of `needed_mm`, up to the first M600.
// `used_mm`: what was used before, by a print that is resumed.
[[nodiscard]] SpoolCheck spool_check(double left_mm, double needed_mm,
                                     std::optional<double> to_change_mm, double used_mm = 0);

// "12.00 m are left: enough, 2.18 m stay on the spool"; with until_change, "…, when M600 asks for
// another one".
[[nodiscard]] std::string spool_text(const SpoolCheck& check);

// What is left on the spool, in mm; nothing: nobody has said so. Errors: those of spool_mm().
[[nodiscard]] core::Result<std::optional<double>> spool_left_mm(const Options& options,
                                                                const core::Settings& settings);

// Tells whether the spool is enough for the print that the options describe; a person is asked
// where it is not. Nothing: the print may begin; else its exit code. Nothing is told without
// --spool-left. `used_mm`: of a print that is resumed, the filament that was in roads when its
// layer began; what stands before them in start G-code counts as if it came again, so a little
// more is taken to be needed than is.
// COSTS: the time and memory of `rind plan`.
[[nodiscard]] std::optional<int> check_spool(const Options& options, Reporter& reporter,
                                             double used_mm = 0);

// What of it is counted down while it is printed: nothing where M600 asks for another spool.
[[nodiscard]] std::optional<double> counted_down_mm(std::optional<double> left_mm,
                                                    const PrintPlan& print_plan);

// All of them can be read twice.
[[nodiscard]] bool rereadable(const Options& options);

}  // namespace host
