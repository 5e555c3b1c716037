#include "host/printing/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "host/system/limits.h"

namespace host {
namespace {

constexpr double kTerminalPeriod_s = 0.1;
constexpr double kPlainPeriod_s = 5;
constexpr double kJsonPeriod_s = 1;

std::size_t terminal_columns() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 20) return 80;
  return size.ws_col;
}

void append_heat(std::string& line, const char* name, std::optional<double> is,
                 std::optional<double> wanted) {
  if (!is) return;
  line += fmt::format(" | {} {:.0f}", name, *is);
  if (wanted) line += fmt::format("/{:.0f}", *wanted);
  line += " C";
}

std::string layer_text(core::LayerIndex layer, core::LayerIndex layers,
                       std::string_view counts = "layer") {
  return layers > 0 ? fmt::format("{} {}/{}", counts, layer, layers)
                    : fmt::format("{} {}", counts, layer);
}

std::string state_before_layer(std::string_view state) {
  return state.empty() ? "" : fmt::format("{} at ", state);
}

double share_done(const ProgressReport& report) {
  if (report.share) return *report.share;
  if (report.layers <= 0) return 0;
  return static_cast<double>(report.layer) / static_cast<double>(report.layers);
}

}  // namespace

std::string duration_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::llround(std::max(0.0, seconds)));
  return fmt::format("{}:{:02}:{:02}", whole / 3'600, whole / 60 % 60, whole % 60);
}

std::string progress_line(const ProgressReport& report) {
  std::string line;
  if (report.preparation) {
    const auto& [step, done, layers, counts] = *report.preparation;
    line = fmt::format("{}, {}", step, layer_text(done, layers, counts));
  } else if (report.state == "heating" || report.state == "starting") {
    line = report.state;
  } else {
    line = fmt::format("{}{} | {:.1f} mm", state_before_layer(report.state),
                       layer_text(report.layer, report.layers), report.height.mm());
    if (report.layers > 0 || report.share) {
      line += fmt::format(" | {:.0f} %", 100 * share_done(report));
    }
  }
  line += report.left_s ? " | " + duration_text(*report.left_s) + " left"
                        : " | " + duration_text(report.elapsed_s);
  if (report.filament_mm > 0) line += fmt::format(" | {:.2f} m", report.filament_mm / 1'000);
  if (report.spool_left_mm) {
    line += fmt::format(" | spool {:.2f} m", *report.spool_left_mm / 1'000);
  }
  append_heat(line, "nozzle", report.nozzle_celsius, report.nozzle_target_celsius);
  append_heat(line, "bed", report.bed_celsius, report.bed_target_celsius);
  if (report.lines_in_flight) line += fmt::format(" | {} in flight", *report.lines_in_flight);
  if (report.queue_share) line += fmt::format(" | queue {:.0f} %", 100 * *report.queue_share);
  return line;
}

Reporter::Reporter(const Options& options)
    : options_(options), terminal_(isatty(STDERR_FILENO) == 1) {}

Reporter::~Reporter() {
  if (shown_columns_ > 0) std::fputc('\n', stderr);
}

void Reporter::clear() {
  const std::lock_guard lock(mutex_);
  clear_line();
}

void Reporter::clear_line() {
  if (shown_columns_ == 0) return;
  // A window that was made narrower meanwhile shows the line in several rows.
  const std::size_t rows_above = (shown_columns_ - 1) / terminal_columns();
  std::fputs("\r", stderr);
  if (rows_above > 0) std::fprintf(stderr, "\x1b[%zuA", rows_above);
  std::fputs("\x1b[J", stderr);
  shown_columns_ = 0;
}

std::string Reporter::json_text(const std::string& name, const EventFields& fields) const {
  nlohmann::ordered_json json = {{"event", name}};
  for (const auto& [key, value] : fields) {
    std::visit([&json, &key = key](const auto& one) { json[key] = one; }, value);
  }
  // Names of files may hold anything.
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void Reporter::json_line(const std::string& name, const EventFields& fields) {
  const std::string text = json_text(name, fields);
  FILE* out = options_.stdout_taken ? stderr : stdout;
  std::fputs(text.c_str(), out);
  std::fflush(out);
}

void Reporter::log_to(std::unique_ptr<LogFile> log) {
  const std::lock_guard lock(mutex_);
  log_ = std::move(log);
}

void Reporter::note(const std::string& name, const std::string& message,
                    const EventFields& fields) {
  const std::lock_guard lock(mutex_);
  if (log_) log_->write(name + ": " + message);
  if (options_.json) {
    EventFields all = {{"message", message}};
    all.insert(all.end(), fields.begin(), fields.end());
    json_line(name, all);
    return;
  }
  if (options_.quiet) return;
  clear_line();
  std::fprintf(stderr, "%s\n", message.c_str());
}

void Reporter::event(const std::string& name, const EventFields& fields) {
  const std::lock_guard lock(mutex_);
  if (options_.json) json_line(name, fields);
}

void Reporter::error(const std::string& message, int exit_code) {
  const std::lock_guard lock(mutex_);
  if (log_) log_->write("error: " + message);
  if (options_.json) {
    json_line("error", {{"message", message}, {"exit_code", std::int64_t{exit_code}}});
    if (options_.stdout_taken) return;
  }
  clear_line();
  std::fprintf(stderr, "rind: %s\n", message.c_str());
}

LastWords Reporter::words_of_error(const std::string& message, int exit_code) const {
  LastWords words;
  if (options_.json) {
    std::string& json = options_.stdout_taken ? words.standard_error : words.standard_output;
    json = json_text("error", {{"message", message}, {"exit_code", std::int64_t{exit_code}}});
    if (options_.stdout_taken) return words;
  }
  words.standard_error = (terminal_ ? "\r\x1b[K" : "") + ("rind: " + message + "\n");
  return words;
}

bool Reporter::progress_due(double now_s) const {
  const std::lock_guard lock(mutex_);
  return show_due(now_s) || log_due(now_s);
}

bool Reporter::log_due(double now_s) const {
  return log_ && (!logged_at_s_ || now_s - *logged_at_s_ >= kLogPeriod_s);
}

bool Reporter::show_due(double now_s) const {
  if (options_.quiet && !options_.json) return false;
  const double period =
      options_.json ? kJsonPeriod_s : (terminal_ ? kTerminalPeriod_s : kPlainPeriod_s);
  return !shown_at_s_ || now_s - *shown_at_s_ >= period;
}

void Reporter::progress(const ProgressReport& report, double now_s) {
  const std::lock_guard lock(mutex_);
  if (log_due(now_s)) {
    logged_at_s_ = now_s;
    log_->write("progress: " + progress_line(report));
  }
  if (!show_due(now_s)) return;
  shown_at_s_ = now_s;
  if (options_.json) {
    EventFields fields = {{"layer", report.layer},
                          {"layers", report.layers},
                          {"height_mm", report.height.mm()},
                          {"share", share_done(report)},
                          {"filament_mm", report.filament_mm},
                          {"elapsed_s", report.elapsed_s}};
    const auto add = [&fields](const char* key, std::optional<double> value) {
      if (value) fields.emplace_back(key, *value);
    };
    add("left_s", report.left_s);
    add("spool_left_mm", report.spool_left_mm);
    add("nozzle_celsius", report.nozzle_celsius);
    add("nozzle_target_celsius", report.nozzle_target_celsius);
    add("bed_celsius", report.bed_celsius);
    add("bed_target_celsius", report.bed_target_celsius);
    if (report.lines_in_flight) {
      fields.emplace_back("lines_in_flight", static_cast<std::int64_t>(*report.lines_in_flight));
    }
    add("queue_share", report.queue_share);
    if (!report.state.empty()) fields.emplace_back("state", std::string(report.state));
    if (report.preparation) {
      fields.emplace_back("preparing", std::string(report.preparation->step));
      fields.emplace_back("prepared_layers", report.preparation->done);
    }
    json_line("progress", fields);
    return;
  }
  std::string line = progress_line(report);
  if (!terminal_) {
    std::fprintf(stderr, "%s\n", line.c_str());
    return;
  }
  // A line that wraps could not be taken back.
  line.resize(std::min(line.size(), terminal_columns() - 1));
  clear_line();
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  shown_columns_ = line.size();
}

}  // namespace host
