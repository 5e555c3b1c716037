// What the user asked for: the command line, read and checked for form. What the settings mean is
// checked where they are known (settings_table.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/units.h"                   // LayerIndex
#include "host/output/output_format.h"    // OutputFormat
#include "host/part/bad_layers.h"         // OnBadLayer
#include "host/settings/section_words.h"  // SectionPlace, SectionZoom
#include "host/system/limits.h"           // kSortBytesDefault

namespace host {

enum class Subcommand { kPrint, kResume, kSlice, kPlan, kShow, kPorts, kSettings, kFormats };

// When the port vanishes, or the controller resets, in mid-print.
enum class OnLostPort { kWait, kStop };

// Whether a mesh that comes through a pipe is taken to be in order of height, so that it can be
// sliced as it comes. A wrong yes ends in mid-part, a needless no costs time and disk.
enum class PipeSorted {
  kAuto,  // slice: yes when it begins so; print: no
  kYes,   // when it begins so
  kNo,
};

// As many as there are processors, and at most kJobsDefaultMax.
[[nodiscard]] int jobs_by_default();

struct Options {
  Subcommand subcommand = Subcommand::kPlan;
  std::string part;  // "-": standard input

  // print
  std::string port;  // a device, or "virtual"
  int baud = 115'200;
  bool baud_told = false;
  std::string journal;  // empty: the default place
  bool no_journal = false;
  bool anew = false;  // a print of the part that was cut may be set aside
  OnLostPort on_lost_port = OnLostPort::kWait;
  double lost_port_wait_s = 600;
  double pause_heat_s = kPausedHot_s;  // how long a paused nozzle stays hot
  bool yes = false;                    // nobody is there to be asked

  // resume, besides; `journal` is a journal, or a part's name, or empty: list what there is
  std::optional<double> nozzle_height_mm;
  bool bad_layer_told = false;

  double virtual_speed = 1;  // seconds of the virtual controller's clock a real second

  // slice, show
  std::string output;  // "-": standard output
  OutputFormat format = OutputFormat::kGcode;
  LayerContents contents = LayerContents::kWalls;
  core::LayerIndex layer = 0;  // 0: none, a section is asked for
  std::optional<SectionPlace> section;
  std::optional<SectionZoom> zoom;  // only with a section

  int jobs = jobs_by_default();        // processors for the geometry
  std::size_t memory_limit_bytes = 0;  // 0: none
  OnBadLayer on_bad_layer = OnBadLayer::kRepair;
  std::string log;  // empty: none
  std::size_t sort_bytes = kSortBytesDefault;
  PipeSorted sorted = PipeSorted::kAuto;
  bool tall = false;  // OpenOptions::tall

  // Settings: the profile first, then these in the order they were typed, shortcuts included.
  std::string profile;       // empty: none
  bool profile_lax = false;  // without what of it can't be read
  std::vector<std::pair<std::string, std::string>> assignments;

  std::string stats;  // file for statistics; empty: none
  bool quiet = false;
  bool json = false;
};

// Nothing to run: help, the version, or words that can't be understood.
struct OptionsExit {
  int exit_code = 0;
  std::string text;  // for standard output when exit_code is 0, else for standard error
};

// Never throws, never prints.
[[nodiscard]] std::variant<Options, OptionsExit> parse_options(int argc, const char* const* argv);

}  // namespace host
