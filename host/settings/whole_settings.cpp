#include "host/settings/whole_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "firmware_link/wire/command.h"           // blank_or_comment
#include "firmware_link/wire/refused_commands.h"  // refused_in
#include "host/pipeline/user_gcode.h"             // allowed_commands
#include "host/settings/gcode_placeholders.h"
#include "host/settings/profile_report.h"
#include "host/settings/prusa_supports.h"
#include "host/settings/settings_file.h"
#include "host/settings/settings_table.h"
#include "host/settings/settings_text.h"

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;
using Lines = std::vector<std::string>;

constexpr const char* kLax = "; --profile-lax leaves it out";

std::string with_underscores(std::string key) {
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

Lines& gcode_lines(PrintSettings& settings, std::string_view key) {
  if (key == "start_gcode") return settings.start_gcode;
  if (key == "at_height") return settings.at_height;
  return key == "pause_gcode" ? settings.pause_gcode : settings.end_gcode;
}

std::string place_of(const PendingGcode& gcode) {
  return gcode.place.empty() ? gcode.key : gcode.place + ": " + gcode.key;
}

// A profile's lines that may not be sent are taken out and named.
Lines without_refused(const Lines& lines, const PendingGcode& gcode, WholeSettings& whole) {
  const Result<Lines> allowed = allowed_commands(whole.settings.allow_gcode);
  Lines sent;
  for (const std::string& line : lines) {
    if (firmware_link::blank_or_comment(line)) {
      whole.notes.push_back(
          fmt::format("{}: '{}' is taken out: it is no command", place_of(gcode), line));
      continue;
    }
    const auto refused =
        allowed.ok() ? firmware_link::refused_in(line, allowed.value()) : std::nullopt;
    if (!refused) {
      sent.push_back(line);
      continue;
    }
    const std::string remedy =
        refused->never ? "" : fmt::format("; --allow-gcode {} keeps it", refused->command);
    whole.notes.push_back(fmt::format("{}: '{}' is taken out: {} {}{}", place_of(gcode), line,
                                      refused->command, refused->reason, remedy));
  }
  return sent;
}

// Fills in the placeholders. What only a part gives makes the lines wait for it; without a part
// none are sent.
Status fill(const PendingGcode& gcode, const PartFacts* part, WholeSettings& whole) {
  static const ProfileValues kNoValues;
  const ProfileValues& profile = whole.profile ? whole.profile->values : kNoValues;
  const PlaceholderValues values(whole.settings, profile, part);
  const VariableLookup lookup = [&values](std::string_view name, std::size_t index) {
    return values.find(name, index);
  };
  Lines& lines = gcode_lines(whole.settings, gcode.key);
  Result<Lines> filled = fill_placeholders(gcode.lines, lookup, gcode.origin);
  if (!filled.ok() && values.lacked_part()) {
    whole.pending.push_back(gcode);
    lines.clear();
    return {};
  }
  if (filled.ok()) filled = sendable_lines(filled.value());
  if (!filled.ok()) {
    return Error{ErrorCode::kBadSetting,
                 fmt::format("{}: {}", place_of(gcode), filled.error().message)};
  }
  lines = gcode.origin == GcodeOrigin::kOwn ? std::move(filled).value()
                                            : without_refused(filled.value(), gcode, whole);
  return {};
}

// A profile's lines that are not understood are an error, or rind's own are sent.
Status fill_or_leave_out(const PendingGcode& gcode, bool lax, const PartFacts* part,
                         WholeSettings& whole) {
  Status filled = fill(gcode, part, whole);
  if (filled.ok() || gcode.origin == GcodeOrigin::kOwn) return filled;
  if (!lax) return Error{ErrorCode::kBadSetting, filled.error().message + kLax};
  PrintSettings defaults;
  Lines& lines = gcode_lines(whole.settings, gcode.key);
  lines = gcode_lines(defaults, gcode.key);
  whole.notes.push_back(fmt::format("{}; it is left out, and rind's own is sent ({})",
                                    filled.error().message, write_lines(lines)));
  return {};
}

class Assembly {
 public:
  explicit Assembly(const SettingsRequest& request) : request_(request) {
    for (const auto& [key, value] : request.assignments) assigned_.insert(with_underscores(key));
  }

  Result<WholeSettings> assemble() {
    std::string text;
    if (!request_.profile.empty()) {
      Result<std::string> read = profile_text(request_.profile);
      if (!read.ok()) return read.error();
      text = std::move(read).value();
    }
    // A bundle has printers, prints and filaments of its own.
    PrinterRequest printer = request_.printer;
    const ProfileChoice choice = choice_for(text, printer);
    Result<StartingSettings> start = starting_settings(printer);
    if (!start.ok()) return start.error();
    whole_.settings = std::move(start.value().settings);
    whole_.bed_known = start.value().bed_known;
    if (!request_.profile.empty()) {
      Result<LoadedSettings> loaded =
          read_settings(text, request_.profile, whole_.settings, choice);
      if (!loaded.ok()) return loaded.error();
      loaded_ = std::move(loaded).value();
      whole_.settings = loaded_.settings;
      whole_.profile = std::make_shared<const LoadedSettings>(loaded_);
      whole_.bed_known = whole_.bed_known || loaded_.bed_told;
    }
    whole_.bed_known = whole_.bed_known || (assigned("bed_x") && assigned("bed_y"));
    for (const auto& [key, value] : request_.assignments) {
      if (Status set = set_setting(whole_.settings, key, value); !set.ok()) return set.error();
    }
    // By the print's own layers and roads, which may be others than the profile's.
    if (loaded_.from_prusa) {
      take_prusa_support_distances(
          loaded_.values, [this](const std::string& key) { return assigned(key); },
          whole_.settings);
    }
    for (const auto step : {&Assembly::take_unreadable, &Assembly::fill_gcode}) {
      if (Status done = (this->*step)(); !done.ok()) return done.error();
    }
    if (Status valid = validate_settings(whole_.settings); !valid.ok()) return valid.error();
    name_left_out();
    return std::move(whole_);
  }

 private:
  [[nodiscard]] bool assigned(const std::string& key) const { return assigned_.count(key) > 0; }

  Status take_unreadable() {
    for (const Unreadable& one : loaded_.unreadable) {
      if (assigned("bed_shape") ||
          std::all_of(one.keys.begin(), one.keys.end(),
                      [this](const std::string& key) { return assigned(key); })) {
        continue;
      }
      if (!request_.lax) return Error{ErrorCode::kBadSetting, one.what + kLax};
      whole_.notes.push_back(
          fmt::format("{}; it is left out, and rind's own bed is used", one.what));
    }
    return {};
  }

  Status fill_gcode() {
    for (const RawGcode& raw : loaded_.gcode) {
      if (assigned(raw.key)) continue;
      const PendingGcode gcode{raw.key, raw.place, unescaped_lines(raw.text), raw.origin};
      if (Status filled = fill_or_leave_out(gcode, request_.lax, nullptr, whole_); !filled.ok()) {
        return filled;
      }
    }
    for (const char* key : {"start_gcode", "at_height", "pause_gcode", "end_gcode"}) {
      // A profile's lines are filled in once.
      const bool theirs = std::any_of(loaded_.gcode.begin(), loaded_.gcode.end(),
                                      [key](const RawGcode& raw) { return raw.key == key; });
      if (theirs && !assigned(key)) continue;
      const PendingGcode own{key, "", gcode_lines(whole_.settings, key), GcodeOrigin::kOwn};
      if (Status filled = fill(own, nullptr, whole_); !filled.ok()) return filled;
    }
    return {};
  }

  void name_left_out() {
    if (!loaded_.from_prusa) return;
    std::vector<std::string> notes = loaded_.chosen;
    notes.push_back(fmt::format("{}: of its settings {}; rind settings --from lists them",
                                request_.profile, counts_of(report_of(loaded_))));
    notes.insert(notes.end(), loaded_.left_out.begin(), loaded_.left_out.end());
    whole_.notes.insert(whole_.notes.begin(), notes.begin(), notes.end());
  }

  const SettingsRequest& request_;
  std::set<std::string, std::less<>> assigned_;
  LoadedSettings loaded_;
  WholeSettings whole_;
};

}  // namespace

ProfileChoice choice_for(std::string_view profile, PrinterRequest& printer) {
  if (!offers_choice(profile)) return {};
  const bool none = printer.printer == kNoPrinter;
  ProfileChoice choice{none ? std::string() : printer.printer, printer.quality, printer.filament};
  printer.printer = kNoPrinter;
  printer.quality.clear();
  printer.filament.clear();
  return choice;
}

Result<WholeSettings> whole_settings(const SettingsRequest& request) {
  return Assembly(request).assemble();
}

Status fill_for_part(const SettingsRequest& request, const PartFacts& part, WholeSettings& whole) {
  const std::vector<PendingGcode> pending = std::exchange(whole.pending, {});
  for (const PendingGcode& gcode : pending) {
    Status filled = fill_or_leave_out(gcode, request.lax, &part, whole);
    if (!filled.ok()) return filled;
  }
  return {};
}

}  // namespace host
