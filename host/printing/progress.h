// What the program says while it works: one line that is updated on a terminal, a line every few
// seconds elsewhere, JSON lines with --json, nothing but errors with --quiet.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/units.h"                 // LayerIndex, Length
#include "host/files/log_file.h"        // LogFile
#include "host/pipeline/preparation.h"  // Preparation
#include "host/system/stop_signals.h"   // LastWords

namespace host {

// How far a print is. What is not known is not set.
struct ProgressReport {
  core::LayerIndex layer = 0;   // counted from 1
  core::LayerIndex layers = 0;  // 0: not known
  core::Length height;
  double filament_mm = 0;
  std::optional<double> spool_left_mm;
  double elapsed_s = 0;
  std::optional<double> left_s;
  std::optional<double> share;  // of its time; nothing: layers tell it
  std::optional<double> nozzle_celsius, nozzle_target_celsius;
  std::optional<double> bed_celsius, bed_target_celsius;
  std::optional<std::size_t> lines_in_flight;
  std::optional<double> queue_share;  // 0 … 1
  std::optional<Preparation> preparation;
  std::string_view state;  // "starting", "heating", "paused", "resuming"; empty: it prints
};

// "supports: slicing, layer 45/312 | 0:00:02 | nozzle 150/210 bed 60/60 C", before the first layer;
// "heating | 0:00:28 | nozzle 143/210 C | bed 40/60 C"; "paused at layer 45/312 | …";
// "layer 45/312 | 9.0 mm | 14 % | 0:03:20 left | 1.23 m | nozzle 210/210 bed 60/60 C | …"
[[nodiscard]] std::string progress_line(const ProgressReport& report);

// "1:02:03"
[[nodiscard]] std::string duration_text(double seconds);

// One value of a JSON event.
using EventValue = std::variant<std::string, double, std::int64_t, bool>;
using EventFields = std::vector<std::pair<std::string, EventValue>>;

// For any thread.
class Reporter {
 public:
  struct Options {
    bool quiet = false;
    bool json = false;
    bool stdout_taken = false;  // the result goes there: JSON events go to standard error
  };
  explicit Reporter(const Options& options);

  // From now on all is written to the log as well, even when quiet; progress now and then.
  void log_to(std::unique_ptr<LogFile> log);

  ~Reporter();
  Reporter(const Reporter&) = delete;
  Reporter& operator=(const Reporter&) = delete;

  // Something worth a line; with --json {"event": name, "message": …, fields}.
  void note(const std::string& name, const std::string& message, const EventFields& fields = {});

  // For programs that read events: told with --json only.
  void event(const std::string& name, const EventFields& fields);

  // Why it ends badly; told even when quiet.
  void error(const std::string& message, int exit_code);

  // May be called at any time; shows the report when it is due. `now_s` never goes back.
  void progress(const ProgressReport& report, double now_s);

  // True when a progress() at this time would show something, so that a report is worth making.
  [[nodiscard]] bool progress_due(double now_s) const;

  // Removes the progress line, before something else is printed.
  void clear();

  // What error() would say, for a signal handler that can't call it.
  [[nodiscard]] LastWords words_of_error(const std::string& message, int exit_code) const;

 private:
  void clear_line();
  [[nodiscard]] bool show_due(double now_s) const;
  [[nodiscard]] bool log_due(double now_s) const;
  [[nodiscard]] std::string json_text(const std::string& name, const EventFields& fields) const;
  void json_line(const std::string& name, const EventFields& fields);

  mutable std::mutex mutex_;  // for all below, and both outputs
  Options options_;
  std::unique_ptr<LogFile> log_;
  std::optional<double> logged_at_s_;  // progress
  bool terminal_;
  std::size_t shown_columns_ = 0;  // of the line that is updated; 0: none is shown
  std::optional<double> shown_at_s_;
};

}  // namespace host
