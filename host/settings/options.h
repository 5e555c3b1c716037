// Reads the command line and checks its form. Values of settings are checked in settings_table.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/units.h"                    // LayerIndex
#include "host/output/output_format.h"     // OutputFormat
#include "host/part/bad_layers.h"          // OnBadLayer
#include "host/pipeline/hanging_log.h"     // OnFloating
#include "host/settings/section_words.h"   // SectionPlace, SectionZoom
#include "host/settings/spool_amount.h"    // SpoolAmount
#include "host/settings/whole_settings.h"  // SettingsRequest
#include "host/system/limits.h"            // kSortBytesDefault

namespace host {

enum class Subcommand {
  kPrint,
  kResume,
  kSlice,
  kPlan,
  kShow,
  kPorts,
  kSettings,
  kFormats,
  kPresets,
  kSetup,
  kTest,
  kTell,
};

// What to do if the port vanishes or the controller resets during a print.
enum class OnLostPort { kWait, kStop };

// Whether a mesh from a pipe is taken to be in order of height, so that it can be sliced as it
// arrives. A wrong yes ends in the middle of the part; a needless no costs time and disk.
enum class PipeSorted {
  kAuto,  // slice: yes if its start is in order; print: no
  kYes,   // if its start is in order
  kNo,
};

// The number of processors, at most kThreadsDefaultMax.
[[nodiscard]] int threads_by_default();

// Of the threads that were asked for, as many as there are processors: more would only take turns.
[[nodiscard]] int threads_at_work(int asked);

// The part's file, and how it is read.
struct PartOptions {
  std::string path;                     // "-": standard input
  std::vector<std::string> more_paths;  // of parts beside it
  std::string title;                    // for people, if it is not the file's name
  std::size_t sort_bytes = kSortBytesDefault;
  PipeSorted sorted = PipeSorted::kAuto;
  std::string spool;  // a folder for temporary files of supports; empty: $TMPDIR, or /tmp
  bool tall = false;  // OpenOptions::tall
  OnBadLayer on_bad_layer = OnBadLayer::kRepair;
  OnFloating on_floating = OnFloating::kWarn;
};

// print, resume: the printer.
struct LinkOptions {
  std::string port;  // a device, or "virtual"
  int baud = 115'200;
  bool baud_told = false;
  OnLostPort on_lost_port = OnLostPort::kWait;
  double lost_port_wait_s = 600;
  double virtual_speed = 1;  // seconds of the virtual controller's clock per real second
};

// print, resume: the print and its journal.
struct PrintCommandOptions {
  // print: empty: the default folder. resume, tell: a journal or a part's name; empty: resume lists
  // all journals, tell means the one print that is running.
  std::string journal;
  bool no_journal = false;
  bool anew = false;  // the journal of an interrupted print of this part may be set aside
  double pause_heat_s = kPausedHot_s;  // how long a paused nozzle stays hot
  bool yes = false;                    // nobody can answer questions
  std::optional<double> nozzle_height_mm;
  bool bad_layer_told = false;
  bool floating_told = false;
};

// slice, show: the output.
struct OutputOptions {
  std::string path;  // "-": standard output
  OutputFormat format = OutputFormat::kGcode;
  LayerContents contents = LayerContents::kWalls;
  core::LayerIndex layer = 0;  // 0: a section is shown instead
  std::optional<SectionPlace> section;
  std::optional<SectionZoom> zoom;  // only with a section
};

// test: which one, and the values that it tries.
struct TestOptions {
  std::string name;
  std::optional<double> from, to, step;
};

struct Options {
  Subcommand subcommand = Subcommand::kPlan;
  PartOptions part;
  SettingsRequest settings;
  LinkOptions link;
  PrintCommandOptions print;
  OutputOptions output;
  TestOptions test;
  std::string request;                    // tell
  std::optional<SpoolAmount> spool_left;  // plan, print, resume
  std::string preset_shown;               // presets: a name; empty: list them

  std::string translated;  // settings: the profile whose translation is shown; empty: none

  int threads = threads_by_default();  // threads for the geometry
  std::size_t memory_limit_bytes = 0;  // 0: no limit
  std::string log;                     // a file; empty: none
  std::string stats;                   // a file for statistics; empty: none
  bool quiet = false;
  bool json = false;
};

// There is no command to run: help, the version, or a usage error.
struct OptionsExit {
  int exit_code = 0;
  std::string text;   // for standard output when exit_code is 0, else an error's message
  bool json = false;  // an error is told as an event
};

// Never throws, never prints.
[[nodiscard]] std::variant<Options, OptionsExit> parse_options(int argc, const char* const* argv);

}  // namespace host
