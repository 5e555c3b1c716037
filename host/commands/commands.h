// The subcommands, one in each file, and their common start. Each shows its own messages and
// returns the exit code.
#pragma once

#include <string>
#include <vector>

#include "core/result.h"                   // Result
#include "host/pipeline/pipeline.h"        // PrintPlan
#include "host/pipeline/print_settings.h"  // PrintSettings
#include "host/pipeline/statistics.h"
#include "host/printing/progress.h"        // Reporter
#include "host/settings/options.h"         // Options
#include "host/settings/whole_settings.h"  // WholeSettings

namespace host {

int print_command(const Options& options, Reporter& reporter);
int resume_command(const Options& options, Reporter& reporter);
int slice_command(const Options& options, Reporter& reporter);
int plan_command(const Options& options, Reporter& reporter);
int show_command(const Options& options, Reporter& reporter);
int ports_command(const Options& options, Reporter& reporter);
int settings_command(const Options& options, Reporter& reporter);
int formats_command(const Options& options, Reporter& reporter);
int presets_command(const Options& options, Reporter& reporter);
int setup_command(const Options& options, Reporter& reporter);
int test_command(const Options& options, Reporter& reporter);
int tell_command(const Options& options, Reporter& reporter);

// Printer, profile, then the command line's assignments, then the check that all fit together.
// G-code that waits for the part is not in the settings.
[[nodiscard]] core::Result<WholeSettings> load_settings_of(const Options& options,
                                                           Reporter& reporter);

// Settings and part, both checked; but a print may have the rest of its part still to read
// (OpenedPart::read_rest). `on_facet` sees the facets (OpenOptions) if the settings ask for
// thumbnails.
[[nodiscard]] core::Result<PrintPlan> open_print_plan(const Options& options, Reporter& reporter,
                                                      FacetObserver on_facet = {});

// Stops at a stop signal, and shows what goes on in the pipeline before its layers.
void connect_signals(PipelineSignals& signals, Reporter& reporter);

// What the pipeline warned of.
void report_warnings(PipelineSignals& signals, Reporter& reporter);

// What was mended in the part, if anything.
void report_defects(const DefectLog& defects, Reporter& reporter);

// What hangs in the air, if anything.
void report_hanging(const HangingLog& hanging, Reporter& reporter);

// Writes --stats, if asked for. Returns `exit_code`, or why the file could not be written.
[[nodiscard]] int save_statistics(const Options& options, const GeometryStatistics& geometry,
                                  const LinkStatistics* link, int exit_code, Reporter& reporter);

// A whole file, or none (OutputFile); after a stop signal, too.
[[nodiscard]] core::Status write_output(const std::string& path, const std::string& text);

// To standard output, where the text is what the command is for. Returns the exit code.
[[nodiscard]] int show_result(const std::string& text, Reporter& reporter);

// Reports that a stop signal ended the command, and returns its exit code.
[[nodiscard]] int stopped(const Options& options, Reporter& reporter);
[[nodiscard]] std::string stopped_message(const Options& options);

// Reports an error of the part, a setting or a file, and returns its exit code; after a stop signal
// that it was stopped.
[[nodiscard]] int fail(const core::Error& error, Reporter& reporter);

// "0.2 mm", or "0.07 to 0.3 mm": how high the layers of a mesh are.
[[nodiscard]] std::string layer_words(const core::Settings& settings, const PartSummary& summary);

// What the part is called, or its name without its folder.
[[nodiscard]] std::string title_of(const PartOptions& part);
// The part's name without its folder, for titles.
[[nodiscard]] std::string part_title(const std::string& path);

// Of all parts that are printed together.
[[nodiscard]] std::vector<std::string> part_paths(const Options& options);

}  // namespace host
