#include "host/settings/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "host/calibration/calibration.h"  // calibration_names
#include "host/settings/command_options.h"
#include "host/settings/documents.h"
#include "host/settings/section_words.h"
#include "host/settings/setting_options.h"
#include "host/settings/usage.h"
#include "host/system/exit_codes.h"
#include "host/system/version.h"

namespace host {
namespace {

constexpr const char* kAbout =
    "rind prints a part while it is still being sliced: a dense wall where the surface is near, "
    "loose fill inside, in memory that does not grow with the part's height.";

void add_journal(CLI::App& command, Options& options) {
  CLI::Option* journal =
      command
          .add_option("--journal", options.print.journal,
                      "journal for `rind resume`; default: a file in $XDG_STATE_HOME/rind or "
                      "~/.local/state/rind")
          ->type_name("FILE");
  command.add_flag("--no-journal", options.print.no_journal, "keep no journal")->excludes(journal);
  command.add_flag("--anew", options.print.anew,
                   "set the journal of an interrupted print aside (.old)");
}

// The value, or a usage error of that option.
template <typename Value>
Value taken(const char* option, core::Result<Value> read) {
  if (!read.ok()) throw CLI::ValidationError(option, read.error().message);
  return std::move(read).value();
}

void add_spool_left(CLI::App& command, Options& options) {
  command
      .add_option_function<std::string>(
          "--spool-left",
          [&options](const std::string& text) {
            options.spool_left = taken("--spool-left", spool_amount(text));
          },
          "filament that is left on the spool, as '12 m' or '350 g': is it enough?")
      ->type_name("AMOUNT")
      ->trigger_on_parse();
}

CLI::App* add_print(CLI::App& app, Options& options) {
  CLI::App* command = app.add_subcommand("print", "print a part while it is being sliced");
  add_part(*command, options);
  add_sorted(*command, options);
  add_port(*command, options);
  add_journal(*command, options);
  add_spool_left(*command, options);
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
  add_spool_left(*command, options);
  add_memory(*command, options);
  add_bad_layer(*command, options);
  add_floating(*command, options);
  add_settings(*command, options);
  add_reports(*command, options);
  return command;
}

CLI::App* add_tell(CLI::App& app, Options& options) {
  CLI::App* command = app.add_subcommand("tell", "tell a running print to pause, or what else");
  command
      ->add_option_function<std::vector<std::string>>(
          "REQUEST",
          [&options](const std::vector<std::string>& words) {
            for (const std::string& word : words) {
              options.request += (options.request.empty() ? "" : " ") + word;
            }
          },
          "pause, resume, stop, or cancel N: object N, as rind plan counts them")
      ->type_name("")
      ->required()
      ->expected(1, 2);
  command
      ->add_option("--print", options.print.journal,
                   "which print, where several run: its part or its journal")
      ->type_name("NAME");
  command->add_flag("--json", options.json, "messages as JSON");
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
  command
      ->add_option("-o,--output", options.output.path,
                   "FILE.svg, FILE.png, or - for standard output (SVG)")
      ->type_name("FILE")
      ->required();
  add_settings(*command, options);
  add_reports(*command, options);
  return command;
}

void add_value(CLI::App& command, const char* flag, std::optional<double>& value,
               const char* help) {
  command.add_option(flag, value, help)->type_name("X");
}

CLI::App* add_test(CLI::App& app, Options& options) {
  CLI::App* command = app.add_subcommand(
      "test",
      "print a part that shows which value of a setting is right, and say what to look for");
  std::vector<std::string> names;
  for (const std::string_view name : calibration_names()) names.emplace_back(name);
  command->add_option("TEST", options.test.name, "what is tested")
      ->required()
      ->type_name("")
      ->check(CLI::IsMember(names));
  add_value(*command, "--from", options.test.from,
            "the lowest block's value; default: by the filament and the printer");
  add_value(*command, "--to", options.test.to, "the highest block's value");
  add_value(*command, "--step", options.test.step,
            "how much the value changes from block to block");
  command
      ->add_option("-o,--output", options.output.path,
                   "write OUT.gcode instead, or the part alone as OUT.stl; - for standard output")
      ->type_name("OUT");
  add_memory(*command, options);
  add_port(*command, options);
  add_journal(*command, options);
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

CLI::App* add_presets(CLI::App& app, Options& options) {
  CLI::App* command =
      app.add_subcommand("presets", "list the presets of printers, filaments and qualities");
  command->add_option("NAME", options.preset_shown, "a preset to show")->type_name("");
  command->add_flag("--json", options.json, "as JSON");
  return command;
}

CLI::App* add_setup(CLI::App& app, Options& options) {
  CLI::App* command =
      app.add_subcommand("setup", "find the printer, and write down what rind should know of it");
  command
      ->add_option("--port", options.link.port,
                   "serial device of the printer; default: the one that is there")
      ->type_name("DEVICE");
  command->add_option("--baud", options.link.baud, "speed of the serial line; default: tried")
      ->type_name("N")
      ->check(CLI::Range(300, 4'000'000))
      ->each([&options](const std::string&) { options.link.baud_told = true; });
  add_printer(*command, options);
  add_assignments(*command, options);
  command->add_flag("--yes", options.print.yes, "ask nothing: take the usual answers");
  command->add_flag("--anew", options.print.anew, "set the printer's file aside (.old)");
  add_reports(*command, options);
  return command;
}

std::string unknown_format(const Options& options) {
  std::string known;
  for (const std::string& name : output_format_names()) known += " " + name;
  return "the name '" + options.output.path + "' does not tell the format; add --format, one of" +
         known;
}

std::string no_picture(const Options& options) {
  return "a picture is SVG or PNG, but '" + options.output.path +
         "' has another ending; use .svg or .png";
}

// The commands that were added, and the word that was typed.
struct Commands {
  std::vector<std::pair<const CLI::App*, Subcommand>> all;

  CLI::App& add(Subcommand subcommand, CLI::App* command) {
    all.emplace_back(command, subcommand);
    return *command;
  }
};

Commands add_commands(CLI::App& app, Options& options, std::string& format, std::string& contents) {
  Commands commands;
  commands.add(Subcommand::kSetup, add_setup(app, options));
  commands.add(Subcommand::kPrint, add_print(app, options));
  commands.add(Subcommand::kResume, add_resume(app, options));
  commands.add(Subcommand::kTell, add_tell(app, options));
  commands.add(Subcommand::kSlice, add_slice(app, options, format, contents));
  CLI::App& plan = commands.add(
      Subcommand::kPlan,
      app.add_subcommand("plan", "layers, filament, time and defects; prints nothing"));
  add_part(plan, options);
  add_spool_left(plan, options);
  add_settings(plan, options);
  add_reports(plan, options);
  commands.add(Subcommand::kShow, add_show(app, options));
  commands.add(Subcommand::kTest, add_test(app, options));
  CLI::App& ports =
      commands.add(Subcommand::kPorts, app.add_subcommand("ports", "list the serial ports"));
  ports.add_flag("--json", options.json, "as JSON");
  commands.add(Subcommand::kPresets, add_presets(app, options));
  CLI::App& settings = commands.add(
      Subcommand::kSettings,
      app.add_subcommand("settings", "list all settings with unit, range and default"));
  add_settings(settings, options);
  settings
      .add_option("--from", options.translated,
                  "say what becomes of each setting in another slicer's profile, then list all")
      ->type_name("PROFILE")
      ->excludes("--profile");
  settings.add_flag("--json", options.json, "as JSON");
  commands.add(Subcommand::kFormats, add_formats(app, options));
  return commands;
}

OptionsExit usage_error(const CLI::App& app, const std::string& message,
                        const std::vector<std::string>& words) {
  const bool json = std::find(words.begin(), words.end(), "--json") != words.end();
  return {kExitUsage, json ? message : message + "\n" + usage_hint(app, words), json};
}

// A test's part alone, for other programs.
bool is_body(const Options& options) { return options.output.path.ends_with(".stl"); }

// What the names of outputs say.
std::optional<std::string> name_outputs(Options& options, const std::string& format,
                                        const std::string& contents) {
  if (options.subcommand == Subcommand::kShow && !picture_format_of(options.output.path)) {
    return no_picture(options);
  }
  if (!options.translated.empty()) options.settings.profile = options.translated;
  if (options.subcommand == Subcommand::kTest && !options.output.path.empty() &&
      output_format_of(options.output.path, "") != OutputFormat::kGcode && !is_body(options)) {
    return "a test is written as G-code, or its body as STL: name OUT.gcode or OUT.stl, not '" +
           options.output.path + "'";
  }
  if (options.subcommand != Subcommand::kSlice) return std::nullopt;
  const std::optional<OutputFormat> known = output_format_of(options.output.path, format);
  if (!known) return unknown_format(options);
  options.output.format = *known;
  options.output.contents = contents_of(options.output.format, contents);
  return std::nullopt;
}

}  // namespace

std::variant<Options, OptionsExit> parse_options(int argc, const char* const* argv) {
  Options options;
  std::string format, contents;
  CLI::App app(kAbout, "rind");
  app.set_version_flag("--version", std::string("rind ") + kVersion);
  app.require_subcommand(1);
  const Commands commands = add_commands(app, options, format, contents);
  DocumentRequest document;
  add_documents(app, document);
  lay_out_help(app);

  const std::vector<std::string> words =
      usual_words(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
  if (const auto unknown = unknown_word(app, words)) return usage_error(app, *unknown, words);
  try {
    // CLI11 takes them from the back.
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    if (const auto text = document_of(app, document)) return OptionsExit{kExitDone, *text, false};
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    const bool asked = app.exit(error, out, err) == 0;
    if (asked) return OptionsExit{kExitDone, out.str()};
    return usage_error(app, error.what(), words);
  }
  for (const auto& [command, subcommand] : commands.all) {
    if (*command) options.subcommand = subcommand;
  }
  if (const auto wrong = name_outputs(options, format, contents)) {
    return usage_error(app, *wrong, words);
  }
  return options;
}

}  // namespace host
