#include "host/settings/setting_options.h"

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/settings/settings_table.h"  // setting_words
#include "host/settings/settings_text.h"   // write_lines

namespace host {
namespace {

// The words behind the value's name, as CLI11 writes them; help leaves them out.
std::string with_words(const std::string& value_name, const std::vector<std::string>& words) {
  if (words.empty()) return value_name;
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ",") + word;
  return value_name + ":{" + all + "}";
}

// Adds `--flag VALUE` as a shortcut for `--set key=VALUE`.
void add_shortcut(CLI::App& command, Options& options, const std::string& flag,
                  const std::string& key, const std::string& value_name, const std::string& help) {
  command
      .add_option_function<std::string>(
          flag,
          [&options, key](const std::string& value) {
            options.settings.assignments.emplace_back(key, value);
          },
          help)
      ->type_name(with_words(value_name, setting_words(key)))
      ->trigger_on_parse();
}

// An option that may be given several times: one line of a setting each, but for values that
// `taken_otherwise` takes.
void add_lines(CLI::App& command, Options& options, const std::string& flag, const std::string& key,
               const std::string& value_name, const std::string& help,
               const std::function<bool(const std::string&)>& taken_otherwise = {}) {
  auto lines = std::make_shared<std::vector<std::string>>();
  command
      .add_option_function<std::vector<std::string>>(
          flag,
          [&options, lines, key, taken_otherwise](const std::vector<std::string>& values) {
            for (const std::string& value : values) {
              if (taken_otherwise && taken_otherwise(value)) continue;
              lines->push_back(value);
              options.settings.assignments.emplace_back(key, write_lines(*lines));
            }
          },
          help)
      ->type_name(value_name)
      ->allow_extra_args(false)
      ->trigger_on_parse();
}

// "40,30": a place on the bed, and no action.
bool is_place(const std::string& text) {
  const std::size_t comma = text.find(',');
  return comma != std::string::npos && read_number(text.substr(0, comma), "").ok() &&
         read_number(text.substr(comma + 1), "").ok();
}

void add_at(CLI::App& command, Options& options) {
  const auto take_place = [&options](const std::string& value) {
    if (!is_place(value)) return false;
    const std::size_t comma = value.find(',');
    options.settings.assignments.emplace_back("centre", "0");
    options.settings.assignments.emplace_back("part_x", value.substr(0, comma));
    options.settings.assignments.emplace_back("part_y", value.substr(comma + 1));
    return true;
  };
  add_lines(
      command, options, "--at", "at_height", "'MM ACTION'|X,Y",
      "what is done at a height, as '12.4 pause', '12.4 M600', '30 nozzle_celsius 220'; may be "
      "repeated. X,Y, as 40,30: where the part's front left corner lies on the bed",
      take_place);
}

void add_assignment(Options& options, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw CLI::ValidationError("--set", "'" + text + "' is not KEY=VALUE, as in layer_height=0.2");
  }
  options.settings.assignments.emplace_back(text.substr(0, equals), text.substr(equals + 1));
}

}  // namespace

void add_printer(CLI::App& command, Options& options) {
  const auto add_preset = [&command](const char* flag, std::string& value, const char* help) {
    command.add_option(flag, value, help)->type_name("NAME");
  };
  PrinterRequest& printer = options.settings.printer;
  add_preset("--preset", printer.preset, "printer's preset; rind presets lists them");
  add_preset(
      "--printer", printer.printer,
      "printer that rind setup has set up (default: printer), or one of the profile's bundle; "
      "none: rind's defaults");
  add_preset("--filament", printer.filament,
             "filament's preset, as pla, petg, or one of the profile's bundle");
  add_preset("--quality", printer.quality,
             "preset of layer height and road width, as 0.2, or a print of the profile's bundle");
}

void add_assignments(CLI::App& command, Options& options) {
  command
      .add_option_function<std::vector<std::string>>(
          "--set",
          [&options](const std::vector<std::string>& values) {
            for (const std::string& value : values) add_assignment(options, value);
          },
          "one setting; may be repeated, the last one counts")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->trigger_on_parse();
}

void add_settings(CLI::App& command, Options& options) {
  add_printer(command, options);
  command
      .add_option("--profile", options.settings.profile,
                  "settings file: rind's own, or another slicer's; see 'rind settings'")
      ->type_name("FILE");
  command.add_flag("--profile-lax", options.settings.lax,
                   "leave out the profile's bed and G-code if they can't be read");
  add_shortcut(command, options, "--allow-gcode", "allow_gcode", "CODES",
               "send these commands, which are refused otherwise, as M500,M501");
  add_at(command, options);
  add_lines(command, options, "--height-range", "height_range", "'MM-MM MM'",
            "height of a mesh's layers between two heights, as '10-12.5 0.1'; may be repeated");
  add_lines(command, options, "--support-range", "support_height_range", "'MM-MM on|off'",
            "whether supports hold what hangs between two heights, as '0-20 off'; may be repeated");
  add_assignments(command, options);
  add_shortcut(command, options, "--scale", "part_scale", "FACTOR",
               "size of the part, as 2, 150%, 1,1,2 (along x, y, z), or 'to 100mm' (longest side)");
  add_shortcut(command, options, "--rotate", "part_rotation", "DEGREES",
               "turn the part about z, as 45, or about x, y, z, as 90,0,45");
  add_shortcut(command, options, "--mirror", "part_mirror", "AXIS",
               "mirror the part along x, y or z");
  add_shortcut(command, options, "--cut", "cut", "'MM PIECE'",
               "cut the part in two at a height, and print '20 lower' or '20 upper'; 20: both");
  add_shortcut(command, options, "--units", "part_units", "UNIT",
               "unit of an STL's or OBJ's numbers: mm, inch, m");
  add_shortcut(command, options, "--copies", "copies", "N", "print each part so often");
  command.add_flag_callback(
      "--sequential", [&options] { options.settings.assignments.emplace_back("sequential", "on"); },
      "print several objects one after another, each to its top");
  add_shortcut(command, options, "--layer-height", "layer_height", "MM", "thickness of a layer");
  add_shortcut(command, options, "--wall-thickness", "wall_thickness", "MM",
               "depth below the surface to which the part is dense");
  add_shortcut(command, options, "--wall", "wall_shape", "SHAPE",
               "shape of the wall: ball or cylinder");
  add_shortcut(command, options, "--wall-layers", "wall_layers", "N",
               "layers a cylinder-shaped wall reaches up and down");
  add_shortcut(command, options, "--style", "style", "STYLE",
               "thin-wall, or to compare with: regular, fast");
  add_shortcut(command, options, "--infill,--loose-density", "loose_density", "SHARE",
               "share of the inside that is filled, as 15%");
  add_shortcut(command, options, "--perimeters,--walls", "perimeters", "N",
               "closed roads along every contour");
  add_shortcut(command, options, "--supports", "supports", "WHERE",
               "what is held from below: off, bed, everywhere");
  add_shortcut(command, options, "--brim", "brim_width", "MM",
               "width of the brim, which holds the part to the bed");
}

}  // namespace host
