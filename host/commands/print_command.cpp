#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "firmware_link/ports.h"
#include "host/commands/commands.h"
#include "host/commands/print_run.h"
#include "host/exit_codes.h"
#include "host/pipeline/stage_clock.h"
#include "host/settings/settings_table.h"
#include "host/version.h"

namespace host {
namespace {

std::string no_port_message() {
  std::string message = "no port named; ";
  const std::vector<firmware_link::PortDescription> ports = firmware_link::list_ports();
  message += ports.empty() ? "no serial port was found" : "there are:";
  for (const firmware_link::PortDescription& port : ports) {
    message += "\n  --port " + port.path + "  " + port.description +
               (port.usb.empty() ? "" : "  " + port.usb);
  }
  return message + "\n  --port virtual  a controller inside this program; nothing real is printed";
}

JournalHead head_of(const Options& options, const Job& job, const std::string& usb) {
  JournalHead head;
  head.version = kVersion;
  std::error_code error;
  head.part = std::filesystem::absolute(options.part, error).string();
  head.part_title = job.part_path;
  for (const SettingRow& row : describe_settings(job.settings)) {
    head.settings.emplace_back(row.key, row.value);
  }
  head.on_bad_layer = bad_layer_word(job.on_bad_layer);
  head.port = options.port;
  head.usb = usb;
  head.baud = options.baud;
  head.boot = boot_name();
  return head;
}

// Has the part's content summed up before the rest of it is read.
void sum_part(const Options& options, Job& job, JournalKeeper& keeper) {
  const auto sum = [path = options.part, &keeper]() -> core::Status {
    const core::Result<FileContent> content = content_of(path);
    if (!content.ok()) return content.error();
    keeper.part_known(content.value());
    return {};
  };
  if (!job.part.read_rest) {
    (void)sum();  // a small one; if it can't be read again, there is no journal
    return;
  }
  job.part.read_rest = [sum, rest = job.part.read_rest]() -> core::Result<PartSummary> {
    if (const core::Status summed = sum(); !summed.ok()) return summed.error();
    return rest();
  };
}

// A journal, if one is wanted and can be kept.
core::Status plan_journal(const Options& options, Job& job, const std::string& usb,
                          JournalKeeper& keeper, Reporter& reporter) {
  const bool told = !options.journal.empty();
  if (options.no_journal || (options.port == "virtual" && !told)) return {};
  std::error_code error;
  if (options.part == "-" || !std::filesystem::is_regular_file(options.part, error)) {
    reporter.note("warning", "a part from a pipe can't be read again: this print can't be resumed");
    return {};
  }
  const std::string path = told ? options.journal : default_journal_path(options.part);
  if (path.empty()) {
    reporter.note("warning", "no place for a journal ($HOME is not set): name one by --journal");
    return {};
  }
  if (core::Status planned = keeper.plan(path, head_of(options, job, usb)); !planned.ok()) {
    if (told) return planned;
    reporter.note("warning", planned.error().message + "; this print can't be resumed");
    return {};
  }
  sum_part(options, job, keeper);
  return {};
}

}  // namespace

int print_command(const Options& options, Reporter& reporter) {
  const double began_s = steady_seconds();
  if (options.port.empty()) {
    reporter.error(no_port_message(), kExitUsage);
    return kExitUsage;
  }
  core::Result<Job> opened = open_job(options, reporter);
  if (!opened.ok()) return fail(opened.error(), reporter);
  Job& job = opened.value();
  double& segment_time_min_ms = job.settings.segment_time_min_ms;
  if (segment_time_min_ms == 0) segment_time_min_ms = line_time_ms(options.port, options.baud);
  const std::string usb = options.port == "virtual" ? "" : usb_of(options.port);
  JournalKeeper keeper;
  if (core::Status planned = plan_journal(options, job, usb, keeper, reporter); !planned.ok()) {
    return fail(planned.error(), reporter);
  }
  return run_print(options, job, keeper, std::nullopt, usb, began_s, reporter);
}

}  // namespace host
