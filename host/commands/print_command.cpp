#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "firmware_link/ports/ports.h"
#include "host/commands/commands.h"
#include "host/commands/print_run.h"
#include "host/commands/spool_check.h"
#include "host/printing/journal_directory.h"  // choose_journal
#include "host/settings/settings_table.h"
#include "host/system/exit_codes.h"
#include "host/system/stage_clock.h"
#include "host/system/stop_signals.h"
#include "host/system/text.h"  // trimmed
#include "host/system/version.h"

namespace host {
namespace {

using core::Result;

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

// Of the printer's file, where the command line names no other.
core::Status take_printers_port(Options& options) {
  const Result<StartingSettings> start = starting_settings(options.settings.printer);
  if (!start.ok()) return start.error();
  LinkOptions& link = options.link;
  if (link.port.empty()) link.port = start.value().port;
  if (!link.baud_told && start.value().baud > 0) link.baud = start.value().baud;
  return {};
}

JournalHead head_of(const Options& options, const PrintPlan& print_plan, const std::string& usb) {
  JournalHead head;
  head.version = kVersion;
  std::error_code error;
  head.part = std::filesystem::absolute(options.part.path, error).string();
  for (const std::string& path : options.part.more_paths) {
    head.more_parts.push_back(std::filesystem::absolute(path, error).string());
  }
  head.part_title = print_plan.part_path;
  for (const SettingRow& row : describe_settings(print_plan.settings)) {
    head.settings.emplace_back(row.key, row.value);
  }
  head.on_bad_layer = bad_layer_word(print_plan.on_bad_layer);
  head.on_floating = floating_word(print_plan.on_floating);
  head.port = options.link.port;
  head.usb = usb;
  head.baud = options.link.baud;
  head.boot = boot_name();
  // As many digits as it will have when the part has been read.
  for (const std::string& path : part_paths(options)) {
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    head.part_bytes += error ? 0 : static_cast<std::int64_t>(bytes);
  }
  return head;
}

// Has the part's content hashed before the rest of it is read.
void hash_part(const Options& options, PrintPlan& print_plan, JournalKeeper& keeper) {
  if (print_plan.ready) return keeper.part_known(print_plan.ready->summary().content);
  const auto hash = [paths = part_paths(options), &keeper]() -> core::Status {
    const core::Result<FileContent> content = contents_of(paths);
    if (!content.ok()) return content.error();
    keeper.part_known(content.value());
    return {};
  };
  if (!print_plan.part.read_rest) {
    (void)hash();  // a small one; if it can't be read again, there is no journal
    return;
  }
  print_plan.part.read_rest = [hash,
                               rest = print_plan.part.read_rest]() -> core::Result<PartSummary> {
    if (const core::Status hashed = hash(); !hashed.ok()) return hashed.error();
    return rest();
  };
}

// The journal that the user named, and the interrupted print in it.
Result<JournalChoice> named_journal(const std::string& path) {
  const JournalLook look = look_at_journal(path);
  if (look.standing == JournalStanding::kForeign) {
    return core::Error{core::ErrorCode::kUnreadable, look.why};
  }
  JournalChoice choice{path, {}};
  std::optional<FoundJournal> found = find_journal(path);
  if (!found) return choice;
  if (found->standing == JournalStanding::kHeld) {
    return core::Error{core::ErrorCode::kUnreadable,
                       path + ": another rind is printing with this journal; name another one"};
  }
  choice.interrupted.push_back(std::move(*found));
  return choice;
}

// Which journal the print gets, or why it gets none.
Result<JournalChoice> wanted_journal(const Options& options, Reporter& reporter) {
  const bool named = !options.print.journal.empty();
  if (options.print.no_journal || (options.link.port == "virtual" && !named))
    return JournalChoice{};
  if (!rereadable(options)) {
    reporter.note("warning", "a part from a pipe can't be read again: this print can't be resumed");
    return JournalChoice{};
  }
  if (named) return named_journal(options.print.journal);
  if (journal_directory().empty()) {
    reporter.note("warning",
                  "no directory for a journal ($HOME is not set): name one by --journal");
  }
  return choose_journal(options.part.path);
}

std::string interrupted_text(const Options& options, const FoundJournal& journal) {
  if (!journal.content) return journal.why;
  const JournalRecord& record = journal.content->record;
  const bool same = is_of_part(journal, options.part.path);
  return fmt::format("{}: {} print was interrupted at {}, {} ({})",
                     same ? part_title(options.part.path) : journal.path,
                     same ? "a" : "of " + journal.content->head.part_title + " a",
                     layer_text(record), time_text(journal.written), state_text(record.state));
}

int resume_instead(const Options& told, const FoundJournal& journal, Reporter& reporter) {
  Options options = told;
  options.subcommand = Subcommand::kResume;
  options.print.journal = journal.path;
  return resume_command(options, reporter);
}

enum class InterruptedAnswer { kPrintAgain, kResume, kStop };

// What is done about an interrupted print of the part: as the command line says, or its user.
InterruptedAnswer ask_about(const Options& options, const FoundJournal& journal,
                            Reporter& reporter) {
  if (options.print.anew) return InterruptedAnswer::kPrintAgain;
  const std::string what = interrupted_text(options, journal);
  if (!options.print.yes) {
    Controls controls(false);
    const std::optional<std::string> answer = controls.ask(
        what + "\nr to resume it, a to print the part again and set its journal aside, s to stop:",
        [] { return stop_signal_count() > 0; });
    if (answer && trimmed(*answer) == "r") return InterruptedAnswer::kResume;
    if (answer && trimmed(*answer) == "a") return InterruptedAnswer::kPrintAgain;
    if (answer || stop_signal_count() > 0) return InterruptedAnswer::kStop;
  }
  reporter.error(fmt::format("{}; resume it by: rind resume {} --port {}; or print it from the "
                             "start with --anew, which sets that journal aside as {}",
                             what, journal.path, options.link.port, set_aside_name(journal.path)),
                 kExitUsage);
  return InterruptedAnswer::kStop;
}

// Nothing is written before the controller has answered.
void plan_journal(const Options& options, const JournalChoice& choice, const std::string& usb,
                  PrintPlan& print_plan, JournalKeeper& keeper) {
  if (choice.path.empty() && choice.interrupted.empty()) return;
  JournalPlan plan;
  plan.path = choice.interrupted.empty() ? choice.path : choice.interrupted.front().path;
  for (const FoundJournal& found : choice.interrupted) {
    if (found.path != plan.path) plan.set_aside.push_back(found.path);
  }
  plan.head = head_of(options, print_plan, usb);
  plan.named = !options.print.journal.empty();
  plan.sets_aside = !choice.interrupted.empty();
  keeper.plan(std::move(plan));
  hash_part(options, print_plan, keeper);
}

}  // namespace

int print_command(const Options& told, Reporter& reporter) {
  const double started_s = steady_seconds();
  Options options = told;
  if (core::Status taken = take_printers_port(options); !taken.ok()) {
    return fail(taken.error(), reporter);
  }
  if (options.link.port.empty()) {
    reporter.error(no_port_message(), kExitUsage);
    return kExitUsage;
  }
  if (const std::string mistake = firmware_link::port_name_mistake(options.link.port);
      !mistake.empty()) {
    reporter.error(mistake, kExitUsage);
    return kExitUsage;
  }
  if (const std::optional<int> ended = check_spool(options, reporter)) return *ended;
  core::Result<PrintPlan> opened = open_print_plan(options, reporter);
  if (!opened.ok()) return fail(opened.error(), reporter);
  PrintPlan& print_plan = opened.value();
  double& segment_time_min_ms = print_plan.settings.segment_time_min_ms;
  if (segment_time_min_ms == 0)
    segment_time_min_ms = line_time_ms(options.link.port, options.link.baud);
  const Result<std::optional<double>> left_mm = spool_left_mm(options, print_plan.settings);
  if (!left_mm.ok()) return fail(left_mm.error(), reporter);
  const std::string usb = options.link.port == "virtual" ? "" : usb_of(options.link.port);
  const Result<JournalChoice> choice = wanted_journal(options, reporter);
  if (!choice.ok()) return fail(choice.error(), reporter);
  if (!choice.value().interrupted.empty()) {
    switch (ask_about(options, choice.value().interrupted.front(), reporter)) {
      case InterruptedAnswer::kPrintAgain:
        break;
      case InterruptedAnswer::kResume:
        return resume_instead(options, choice.value().interrupted.front(), reporter);
      case InterruptedAnswer::kStop:
        return stop_signal_count() > 0 ? stopped(options, reporter) : kExitUsage;
    }
  }
  JournalKeeper keeper;
  plan_journal(options, choice.value(), usb, print_plan, keeper);
  return run_print(options, print_plan, keeper,
                   {usb,
                    space_in(print_plan.settings, options),
                    {},
                    counted_down_mm(left_mm.value(), print_plan)},
                   started_s, reporter);
}

}  // namespace host
