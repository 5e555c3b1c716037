#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "host/commands/commands.h"
#include "host/commands/print_run.h"
#include "host/commands/program_control.h"    // ask_nozzle_height
#include "host/commands/resume_choice.h"      // list_journals, journal_named
#include "host/commands/spool_check.h"        // check_spool
#include "host/presets/printer_file.h"        // kNoPrinter
#include "host/printing/journal_directory.h"  // layer_text, state_text
#include "host/settings/settings_file.h"      // load_settings
#include "host/settings/settings_table.h"
#include "host/system/exit_codes.h"
#include "host/system/stage_clock.h"
#include "host/system/stop_signals.h"
#include "host/system/version.h"

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;

constexpr const char* kPrintAgain = "; print the part from the start";

// The journal's settings, if this program still knows them all.
Result<PrintSettings> settings_in(const JournalHead& head) {
  PrintSettings settings;
  for (const auto& [key, value] : head.settings) {
    if (Status set = set_setting(settings, key, value); !set.ok()) return set.error();
  }
  if (Status valid = validate_settings(settings); !valid.ok()) return valid.error();
  return settings;
}

// Whether the setting decides only where the nozzle may be parked, and no command of the print.
bool is_of_space(const std::string& key) {
  return key == "bed_x" || key == "bed_y" || key == "bed_shape" || key == "axis_z";
}

// The print's settings, and over them those that the user names again. These must be equal, but for
// the machine's space.
Result<PrintSettings> settings_with(const Options& options, const JournalHead& head) {
  Result<PrintSettings> of_print = settings_in(head);
  if (!of_print.ok()) return of_print.error();
  PrintSettings told = of_print.value();
  if (!options.settings.profile.empty()) {
    const Result<std::string> text = profile_text(options.settings.profile);
    if (!text.ok()) return text.error();
    PrinterRequest printer = options.settings.printer;
    const ProfileChoice choice = choice_for(text.value(), printer);
    const Result<LoadedSettings> loaded =
        read_settings(text.value(), options.settings.profile, told, choice);
    if (!loaded.ok()) return loaded.error();
    told = loaded.value().settings;
  }
  for (const auto& [key, value] : options.settings.assignments) {
    if (Status set = set_setting(told, key, value); !set.ok()) return set.error();
  }
  const std::vector<SettingRow> rows = describe_settings(told);
  const std::vector<SettingRow> rows_of_print = describe_settings(of_print.value());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].value == rows_of_print[i].value || is_of_space(rows[i].key)) continue;
    // The print's came from the port's baud.
    const bool by_baud = rows[i].key == "segment_time_min_ms" && told.segment_time_min_ms == 0;
    if (by_baud) continue;
    return Error{ErrorCode::kBadSetting,
                 fmt::format("{} was {} when the print started and is {} now: the print can't be "
                             "resumed; leave the settings out, the journal has them",
                             rows[i].key, rows_of_print[i].value, rows[i].value)};
  }
  return told;
}

// A bed that the user names now must hold the part at its position.
Status check_space(const MachineSpace& space, const PartSummary& part) {
  const bool higher = space.axis_z > core::Length() && part.height > space.axis_z;
  if (part.box.empty() || (core::Length::from_units(part.box.max.x) <= space.bed_x &&
                           core::Length::from_units(part.box.max.y) <= space.bed_y && !higher)) {
    return {};
  }
  return Error{ErrorCode::kOutOfBounds,
               fmt::format("the part lies as far as X {:g}, Y {:g} mm and is {:g} mm high, which "
                           "bed_x = {:g}, bed_y = {:g}, axis_z = {:g} mm do not hold; leave them "
                           "out, or name the printer's own",
                           core::Length::from_units(part.box.max.x).mm(),
                           core::Length::from_units(part.box.max.y).mm(), part.height.mm(),
                           space.bed_x.mm(), space.bed_y.mm(), space.axis_z.mm())};
}

Status check_parts(const Options& options, const JournalHead& head) {
  const std::string& path = options.part.path;
  const Result<FileContent> content = contents_of(part_paths(options));
  if (!content.ok()) return content.error();
  if (content.value().hash == head.part_hash && content.value().bytes == head.part_bytes) return {};
  return Error{ErrorCode::kBadPart, path + ": the part has changed since the print started (" +
                                        std::to_string(content.value().bytes) + " bytes, it had " +
                                        std::to_string(head.part_bytes) + ")" + kPrintAgain};
}

// How high the nozzle is, as its user sees it.
Result<std::int64_t> nozzle_height(const Options& options, const JournalRecord& record,
                                   Reporter& reporter) {
  if (options.print.nozzle_height_mm) return std::llround(*options.print.nozzle_height_mm * 1'000);
  if (record.height_in_doubt) {
    const std::string doubt = "the nozzle was moving up or down when the print was interrupted";
    if (options.print.yes) {
      return Error{ErrorCode::kBadSetting,
                   doubt +
                       ", so only its user can see where it is: measure it, and say "
                       "--nozzle-height MM"};
    }
    reporter.note("warning", doubt + ": do not rely on where it was sent, but measure it");
  }
  if (options.print.yes) return record.nozzle_z_um;
  Controls controls(false);
  const std::optional<std::int64_t> told = ask_nozzle_height(controls, record.nozzle_z_um);
  if (told) return *told;
  return Error{ErrorCode::kBadSetting,
               "nobody said where the nozzle is, so nothing is moved; run this at a terminal, or "
               "look at the printer and say --yes, with --nozzle-height MM if it was moved"};
}

// The plan as it was, checked against the journal.
Result<PrintPlan> plan_of(Options& options, const JournalHead& head, Reporter& reporter) {
  if (head.version != kVersion) {
    return Error{ErrorCode::kBadSetting, "the print was started by rind " + head.version +
                                             ", this is " + kVersion +
                                             ", which may lay other roads; use that one"};
  }
  if (options.part.path.empty()) options.part.path = head.part;
  options.part.more_paths = head.more_parts;
  if (Status same = check_parts(options, head); !same.ok()) return same.error();
  const Result<PrintSettings> settings = settings_in(head);
  if (!settings.ok()) return settings.error();
  options.settings = SettingsRequest();
  options.settings.printer.printer = kNoPrinter;  // the journal has all settings
  options.settings.assignments = head.settings;
  if (!options.print.bad_layer_told) options.part.on_bad_layer = bad_layer_of(head.on_bad_layer);
  if (!options.print.floating_told) options.part.on_floating = floating_of(head.on_floating);
  return open_print_plan(options, reporter);
}

}  // namespace

int resume_command(const Options& told, Reporter& reporter) {
  const double started_s = steady_seconds();
  Options options = told;
  if (options.print.journal.empty()) return list_journals(options, reporter);
  const Result<std::string> which = journal_named(options.print.journal);
  if (!which.ok()) {
    reporter.error(which.error().message, kExitUsage);
    return kExitUsage;
  }
  options.print.journal = which.value();

  Result<Journal> journal = Journal::reopen(options.print.journal);
  if (!journal.ok()) return fail(journal.error(), reporter);
  const Result<JournalContent> read = read_journal(options.print.journal);
  if (!read.ok()) return fail(read.error(), reporter);
  const JournalHead& head = read.value().head;
  const JournalRecord& record = read.value().record;
  if (options.link.port.empty()) options.link.port = head.port;
  if (!options.link.baud_told) options.link.baud = head.baud;

  const Result<PrintSettings> named = settings_with(options, head);
  if (!named.ok()) return fail(named.error(), reporter);
  const MachineSpace space = space_in(named.value(), options);
  Result<PrintPlan> print_plan = plan_of(options, head, reporter);
  if (!print_plan.ok()) return fail(print_plan.error(), reporter);
  if (Status fits = check_space(space, print_plan.value().part.summary); !fits.ok()) {
    return fail(fits.error(), reporter);
  }
  reporter.note(
      "resuming",
      fmt::format("{}: {}, at {}", head.part_title, state_text(record.state), layer_text(record)),
      {{"layer", record.checkpoint.layer + 1}});
  const Result<std::optional<double>> left_mm = spool_left_mm(options, print_plan.value().settings);
  if (!left_mm.ok()) return fail(left_mm.error(), reporter);
  const double used_mm = record.checkpoint.filament_mm;
  if (const std::optional<int> ended = check_spool(options, reporter, used_mm)) return *ended;
  const Result<std::int64_t> z_um = nozzle_height(options, record, reporter);
  if (!z_um.ok() && stop_signal_count() > 0) return stopped(options, reporter);
  if (!z_um.ok()) {
    reporter.error(z_um.error().message, kExitUsage);
    return kExitUsage;
  }
  JournalKeeper keeper;
  keeper.take_up(std::move(journal).value());
  Resumption resumption{record, boot_name() == head.boot, z_um.value()};
  const std::string usb = options.link.port == "virtual" ? "" : usb_of(options.link.port);
  return run_print(options, print_plan.value(), keeper,
                   {usb, space, resumption, counted_down_mm(left_mm.value(), print_plan.value())},
                   started_s, reporter);
}

}  // namespace host
