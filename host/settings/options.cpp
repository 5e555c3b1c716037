#include "host/settings/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "host/settings/section_words.h"
#include "host/settings/setting_options.h"
#include "host/system/exit_codes.h"
#include "host/system/version.h"

namespace host {
namespace {

constexpr const char* kAbout =
    "rind prints a part while it is still being sliced: a dense wall where the surface is near, "
    "loose fill inside, in memory that does not grow with the part's height.";

void add_bad_layer(CLI::App& command, Options& options) {
  static const std::map<std::string, OnBadLayer> kWords = {{"repair", OnBadLayer::kRepair},
                                                           {"neighbour", OnBadLayer::kNeighbour},
                                                           {"pause", OnBadLayer::kPause},
                                                           {"stop", OnBadLayer::kStop}};
  command
      .add_option(
          "--on-bad-layer", options.part.on_bad_layer,
          "how to treat a layer with open contours, or an empty one: repair (print the closed "
          "contours), neighbour (print the slice below again), pause (wait for the user), stop")
      ->type_name("WORD")
      ->transform(CLI::CheckedTransformer(kWords).description(""))
      ->each([&options](const std::string&) { options.print.bad_layer_told = true; });
}

void add_floating(CLI::App& command, Options& options) {
  static const std::map<std::string, OnFloating> kWords = {{"warn", OnFloating::kWarn},
                                                           {"stop", OnFloating::kStop}};
  command
      .add_option("--on-floating", options.part.on_floating,
                  "how to treat a layer with an island that begins in the air: warn (print it), "
                  "stop (before that layer)")
      ->type_name("WORD")
      ->transform(CLI::CheckedTransformer(kWords).description(""))
      ->each([&options](const std::string&) { options.print.floating_told = true; });
}

void add_memory(CLI::App& command, Options& options) {
  command
      .add_option("--memory", options.part.sort_bytes,
                  "memory for sorting a mesh, as 8M or 512k; more goes to a file in $TMPDIR")
      ->type_name("BYTES")
      ->transform(CLI::AsSizeValue(false).description(""))
      ->check(CLI::Range(kSortBytesMin, std::size_t{1} << 40).description(""));
  command
      .add_option("--spool", options.part.spool,
                  "folder for the slices that supports need, otherwise in $TMPDIR or /tmp")
      ->type_name("DIR");
  command
      .add_option("--threads,--jobs", options.threads,
                  "number of processors to slice with; each needs the memory of one more layer")
      ->type_name("N")
      ->check(CLI::Range(1, kThreadsMax))
      ->capture_default_str();
  command
      .add_option("--memory-limit", options.memory_limit_bytes,
                  "memory of the whole program, as 64M; end with an error if more is needed")
      ->type_name("BYTES")
      ->transform(CLI::AsSizeValue(false).description(""));
}

void add_tall(CLI::App& command, Options& options) {
  command.add_flag("--tall", options.part.tall,
                   "the part is meant to be that high: accept corners that look stray");
}

void add_part(CLI::App& command, Options& options) {
  command.add_option("PART", options.part.path, "the part's file, or - for standard input")
      ->required()
      ->type_name("");
  add_tall(command, options);
  add_memory(command, options);
  add_bad_layer(command, options);
  add_floating(command, options);
}

void add_sorted(CLI::App& command, Options& options) {
  static const std::map<std::string, PipeSorted> kWords = {
      {"auto", PipeSorted::kAuto}, {"yes", PipeSorted::kYes}, {"no", PipeSorted::kNo}};
  command
      .add_option(
          "--sorted", options.part.sorted,
          "whether a mesh from a pipe is in order of height and can be sliced as it arrives: "
          "yes, no, or auto (slice: if its start is in order; print: no)")
      ->type_name("WORD")
      ->transform(CLI::CheckedTransformer(kWords).description(""));
}

void add_reports(CLI::App& command, Options& options) {
  command.add_option("--stats", options.stats, "write statistics to FILE (JSON)")
      ->type_name("FILE");
  command.add_option("--log", options.log, "write all messages to FILE, too; its size is bounded")
      ->type_name("FILE");
  command.add_flag("--quiet", options.quiet, "no progress, no notes; errors only");
  command.add_flag("--json", options.json, "events as JSON lines instead of text");
}

void add_port(CLI::App& command, Options& options) {
  command
      .add_option("--port", options.link.port,
                  "serial device of the printer, or 'virtual': a controller inside this "
                  "program, without a printer")
      ->type_name("DEVICE");
  command.add_option("--baud", options.link.baud, "speed of the serial line")
      ->type_name("N")
      ->check(CLI::Range(300, 4'000'000))
      ->capture_default_str()
      ->each([&options](const std::string&) { options.link.baud_told = true; });
  command
      .add_option("--virtual-speed", options.link.virtual_speed,
                  "speed of the virtual controller's clock, as a multiple of real time; "
                  "0: as fast as possible")
      ->type_name("X")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  static const std::map<std::string, OnLostPort> kWords = {{"wait", OnLostPort::kWait},
                                                           {"stop", OnLostPort::kStop}};
  command
      .add_option("--on-lost-port", options.link.on_lost_port,
                  "if the cable or the controller fails during a print: wait for it and resume, or "
                  "stop")
      ->type_name("WORD")
      ->transform(CLI::CheckedTransformer(kWords).description(""));
  command
      .add_option("--lost-port-wait", options.link.lost_port_wait_s,
                  "seconds to wait for a lost port")
      ->type_name("S")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command
      .add_option("--pause-heat", options.print.pause_heat_s,
                  "seconds that the nozzle stays hot in a pause")
      ->type_name("S")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command.add_flag("--yes", options.print.yes,
                   "resume after a reset without asking for the nozzle's height: it has not moved");
}

CLI::App* add_print(CLI::App& app, Options& options) {
  CLI::App* command = app.add_subcommand("print", "print a part while it is being sliced");
  add_part(*command, options);
  add_sorted(*command, options);
  add_port(*command, options);
  CLI::Option* journal =
      command
          ->add_option("--journal", options.print.journal,
                       "journal for `rind resume`; default: a file in $XDG_STATE_HOME/rind or "
                       "~/.local/state/rind")
          ->type_name("FILE");
  command->add_flag("--no-journal", options.print.no_journal, "keep no journal")->excludes(journal);
  command->add_flag("--anew", options.print.anew,
                    "set the journal of an interrupted print aside (.old)");
  add_settings(*command, options);
  add_reports(*command, options);
  return command;
}

CLI::App* add_resume(CLI::App& app, Options& options) {
  CLI::App* command =
      app.add_subcommand("resume", "resume an interrupted print after its last executed line");
  command
      ->add_option("JOURNAL", options.print.journal,
                   "a journal, or its part; without it, list the journals")
      ->type_name("");
  command->add_option("--part", options.part.path, "the part's file, if it was moved")
      ->type_name("FILE");
  add_port(*command, options);
  command
      ->add_option("--nozzle-height", options.print.nozzle_height_mm,
                   "height of the nozzle above the bed now; with --yes")
      ->type_name("MM")
      ->check(CLI::Range(0.0, 1e7));
  add_memory(*command, options);
  add_bad_layer(*command, options);
  add_floating(*command, options);
  add_settings(*command, options);
  add_reports(*command, options);
  return command;
}

CLI::App* add_slice(CLI::App& app, Options& options, std::string& format, std::string& contents) {
  CLI::App* command = app.add_subcommand("slice", "write what would be printed to a file");
  add_part(*command, options);
  add_sorted(*command, options);
  command
      ->add_option("-o,--output", options.output.path,
                   "OUT.gcode, .cli, .lsif, .ssl, .svg, or - for standard output")
      ->type_name("OUT")
      ->required();
  command
      ->add_option(
          "--format", format,
          "format, if the name does not tell: gcode, cli, cli-binary, cli-roads (hatches), "
          "lsif, ssl (Slice V0), svg")
      ->type_name("FORMAT")
      ->check(CLI::IsMember(output_format_names()));
  command
      ->add_option(
          "--contents", contents,
          "content of a layer file: walls (wall and inside; default for cli, lsif), slices "
          "(the part; default for ssl, svg), quickslice (walls; both copies of a shared "
          "contour among the inside's)")
      ->type_name("WHAT")
      ->check(CLI::IsMember({"walls", "slices", "quickslice"}));
  add_settings(*command, options);
  add_reports(*command, options);
  return command;
}

// The value, or a usage error of that option.
template <typename Value>
Value taken(const char* option, core::Result<Value> read) {
  if (!read.ok()) throw CLI::ValidationError(option, read.error().message);
  return std::move(read).value();
}

CLI::App* add_show(CLI::App& app, Options& options) {
  CLI::App* command =
      app.add_subcommand("show", "draw one layer, or a vertical cut: wall, inside and roads");
  add_part(*command, options);
  // One of the two, and not both.
  CLI::Option_group* which = command->add_option_group("what to show");
  which->add_option("--layer", options.output.layer, "number of the layer; the lowest is 1")
      ->type_name("N")
      ->check(CLI::Range(std::int64_t{1}, INT64_MAX));
  which
      ->add_option_function<std::string>(
          "--section",
          [&options](const std::string& text) {
            options.output.section = taken("--section", section_place(text));
          },
          "a cut through all layers, in mm or percent from the part's front (Y) or left side (X)")
      ->type_name("Y=MM|X=MM")
      ->trigger_on_parse();
  which->require_option(1);
  command
      ->add_option_function<std::string>(
          "--zoom",
          [&options](const std::string& text) {
            options.output.zoom = taken("--zoom", section_zoom(text));
          },
          "only a square of the section: its middle's distance from the part's edge and height "
          "above the bed, and its side, in mm")
      ->type_name("ALONG,HEIGHT,SIZE")
      ->needs("--section")
      ->trigger_on_parse();
  command->add_option("-o,--output", options.output.path, "FILE.svg, or - for standard output")
      ->type_name("FILE")
      ->required();
  add_settings(*command, options);
  add_reports(*command, options);
  return command;
}

CLI::App* add_formats(CLI::App& app, Options& options) {
  CLI::App* command =
      app.add_subcommand("formats", "list the file formats that are read and written");
  command->add_flag("--json", options.json, "as JSON");
  return command;
}

std::string unknown_format(const Options& options) {
  std::string known;
  for (const std::string& name : output_format_names()) known += " " + name;
  return "the name '" + options.output.path + "' does not tell the format; add --format, one of" +
         known;
}

std::string no_picture(const Options& options) {
  return "a picture is SVG, but '" + options.output.path + "' has another ending; use .svg";
}

// For a first word that is no command, CLI11 only says that a command is missing.
std::string explain(const CLI::App& app, const CLI::ParseError& error, int argc,
                    const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-' || !app.get_subcommands().empty()) return error.what();
  std::string known;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  return "'" + std::string(argv[1]) + "' is not a command; there are " + known;
}

OptionsExit usage_error(const std::string& message) {
  return {kExitUsage, "rind: " + message + "\nTry 'rind --help'.\n"};
}

}  // namespace

std::variant<Options, OptionsExit> parse_options(int argc, const char* const* argv) {
  Options options;
  std::string format, contents;
  CLI::App app(kAbout, "rind");
  app.set_version_flag("--version", std::string("rind ") + kVersion);
  app.require_subcommand(1);
  app.footer("rind COMMAND --help lists a command's options.");

  const CLI::App* print = add_print(app, options);
  const CLI::App* resume = add_resume(app, options);
  const CLI::App* slice = add_slice(app, options, format, contents);
  CLI::App* plan = app.add_subcommand("plan", "layers, filament, time and defects; prints nothing");
  add_part(*plan, options);
  add_settings(*plan, options);
  add_reports(*plan, options);
  const CLI::App* show = add_show(app, options);
  const CLI::App* ports = app.add_subcommand("ports", "list the serial ports");
  CLI::App* settings = app.add_subcommand("settings", "list all settings with unit and range");
  add_settings(*settings, options);
  settings->add_flag("--json", options.json, "as JSON");

  const CLI::App* formats = add_formats(app, options);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    const bool asked = app.exit(error, out, err) == 0;
    if (asked) return OptionsExit{kExitDone, out.str()};
    return usage_error(explain(app, error, argc, argv));
  }

  if (*print) {
    options.subcommand = Subcommand::kPrint;
  } else if (*resume) {
    options.subcommand = Subcommand::kResume;
  } else if (*slice) {
    options.subcommand = Subcommand::kSlice;
    const std::optional<OutputFormat> known = output_format_of(options.output.path, format);
    if (!known) return usage_error(unknown_format(options));
    options.output.format = *known;
    options.output.contents = contents_of(options.output.format, contents);
  } else if (*plan) {
    options.subcommand = Subcommand::kPlan;
  } else if (*show) {
    options.subcommand = Subcommand::kShow;
    if (!may_be_picture(options.output.path)) return usage_error(no_picture(options));
  } else if (*ports) {
    options.subcommand = Subcommand::kPorts;
  } else if (*formats) {
    options.subcommand = Subcommand::kFormats;
  } else {
    options.subcommand = Subcommand::kSettings;
  }
  return options;
}

}  // namespace host
