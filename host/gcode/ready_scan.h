// Looks through a whole ready G-code file before anything moves.
//
// One pass, in constant memory. Each line is checked as it will be sent; what the print is like is
// summed up, and what its user should know is told.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"            // Box
#include "core/result.h"              // Result
#include "core/settings.h"            // Settings
#include "host/files/content_hash.h"  // FileContent
#include "host/gcode/gcode_text.h"    // GcodeText

namespace host {

// Names of macros that are told, at most.
inline constexpr std::size_t kMacrosTold = 4;

struct ReadySummary {
  FileContent content;
  std::int64_t lines = 0;
  std::int64_t commands = 0;
  std::int32_t layers = 0;
  bool marks = false;  // comments tell where layers start
  // Of the roads: of those in layers where comments tell these, so that what a printer wipes off
  // beside its bed does not count.
  core::Box box;  // from the bed's front left corner; empty: there is no road
  core::Length height;
  std::int64_t outside_line = 0;  // where the first of these leaves the settings' bed; 0: none does
  std::int64_t highest_line = 0;
  double filament_mm = 0;  // in roads
  double needed_mm = 0;    // as CommandClock has it; likewise the next
  std::optional<double> needed_to_change_mm;
  double seconds = 0;            // at full speed
  double clock_s = 0;            // as CommandClock has it
  std::optional<double> told_s;  // as the slicer tells it
  std::int64_t last_road = 0;    // the command of that number, from 1
  std::int64_t arcs = 0;
  std::int64_t first_arc_line = 0;
  bool counts_filament = true;  // every move counts its filament by itself, in mm (M83)
  // What a resumed print could not put right after the controller was reset, one sentence each.
  std::vector<std::string> unsafe;
  std::vector<std::string> warnings;

  // How long it takes: as the slicer tells it, or else by the motion clock. Without heating.
  [[nodiscard]] double time_s() const { return told_s.value_or(clock_s); }
};

struct ScanRequest {
  std::vector<std::string> allowed;  // MeaningRules::allowed
  // Called now and then with the bytes read; false: stop.
  std::function<bool(std::int64_t)> on_progress;
};

// Errors (kBadPart): a line that can't be sent, with its number; no road at all; `on_progress` said
// false (kUnreadable). REQUIRES: the text is at its start.
[[nodiscard]] core::Result<ReadySummary> scan_ready(GcodeText& text, const core::Settings& settings,
                                                    const ScanRequest& request);

}  // namespace host
