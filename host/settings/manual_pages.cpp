#include "host/settings/manual_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "host/system/exit_codes.h"

namespace host {
namespace {

// What a page says besides, if its command has the option.
struct Note {
  std::string_view option;
  std::string_view name;
  std::string_view text;
};

constexpr std::array kFiles = {
    Note{"--printer", "$XDG_CONFIG_HOME/rind/printer.ini, ~/.config/rind/printer.ini",
         "the printer that every command uses if none is named; rind setup writes it"},
    Note{"--printer", "$XDG_CONFIG_HOME/rind/NAME.ini, ~/.config/rind/NAME.ini",
         "further printers, for --printer NAME"},
    Note{"--nozzle-height", "$XDG_STATE_HOME/rind, ~/.local/state/rind",
         "the journals of interrupted prints"},
    Note{"--journal", "$XDG_STATE_HOME/rind, ~/.local/state/rind",
         "the journal of a print, which is deleted when the print is done"},
    Note{"--port", "/dev/ttyUSB*, /dev/ttyACM*",
         "the printers' ports. They belong to a group, which is dialout on Debian: sudo adduser "
         "$USER dialout, then log in again."}};

constexpr std::array kEnvironment = {
    Note{"--printer", "XDG_CONFIG_HOME", "the folder of rind's folder of printers"},
    Note{"--journal", "XDG_STATE_HOME", "the folder of rind's folder of journals"},
    Note{"--nozzle-height", "XDG_STATE_HOME", "the folder of rind's folder of journals"},
    Note{"--memory", "TMPDIR",
         "the folder for temporary files: a mesh that is sorted, slices that supports need"}};

struct Example {
  std::string_view words;
  std::string_view text;
};

constexpr std::array kExamples = {
    Example{"rind setup", "Finds the printer and writes down what it is, once."},
    Example{"rind plan part.stl", "Tells layers, filament, time and defects."},
    Example{"rind print part.stl --filament petg --quality 0.1", "Prints a part."},
    Example{"rind print part.stl --port virtual", "Prints to a controller inside rind."},
    Example{"rind resume", "Lists interrupted prints."},
    Example{"systemctl --user start rind@$(systemd-escape --path part.stl)",
            "Prints without a terminal, where systemd and rind's unit are installed. "
            "systemctl --user stop ends the print safely; journalctl --user tells how it went."}};

std::string heading(std::string_view title) { return fmt::format(".SH {}\n", title); }

std::string bold(const std::string& text) { return "\\fB" + manual_text(text) + "\\fR"; }

// A paragraph of its own. No line may begin with a dot.
std::string paragraph(const std::string& text) { return "\\&" + manual_text(text) + "\n"; }

std::string tagged(const std::string& tag, const std::string& text) {
  return ".TP\n" + tag + "\n" + paragraph(text);
}

std::string option_tag(const OptionText& option) {
  std::string tag;
  for (const std::string& name : option.names) tag += (tag.empty() ? "" : ", ") + bold(name);
  if (!option.value.empty()) tag += " \\fI" + manual_text(option.value) + "\\fR";
  return tag;
}

std::string options_of(const std::vector<OptionText>& options) {
  std::string text;
  for (const OptionText& option : options) {
    const std::string usual =
        option.usual.empty() ? "" : fmt::format(" (default: {})", option.usual);
    text += tagged(option_tag(option), option.help + usual);
  }
  return text;
}

bool has(const std::vector<OptionText>& options, std::string_view name) {
  return std::any_of(options.begin(), options.end(), [&](const OptionText& option) {
    return std::find(option.names.begin(), option.names.end(), name) != option.names.end();
  });
}

// The notes of one command, or all of them, each name once.
template <typename Notes>
std::string notes(std::string_view title, const Notes& all, const CommandText* command) {
  std::string text;
  for (const Note& note : all) {
    if (command != nullptr && !has(command->options, note.option)) continue;
    const std::string tag = bold(std::string(note.name));
    if (text.find(".TP\n" + tag + "\n") != std::string::npos) continue;
    text += tagged(tag, std::string(note.text));
  }
  return text.empty() ? "" : heading(title) + text;
}

std::string exits() {
  std::string text = heading("EXIT STATUS");
  for (const ExitText& exit : kExitTexts) {
    text += tagged(bold(std::to_string(exit.code)), std::string(exit.meaning));
  }
  return text;
}

std::string page_head(const ProgramText& program, const std::string& title, int section,
                      const std::string& about) {
  std::string capitals = title;
  for (char& letter : capitals) {
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  }
  return fmt::format(".\\\" Written by rind manual {}.{}\n.TH {} {} \"\" \"rind {}\" \"rind\"\n",
                     title, section, manual_text(capitals), section, manual_text(program.version)) +
         heading("NAME") + manual_text(title) + " \\- " + manual_text(about) + "\n";
}

std::string reference(const std::string& page, int section) {
  return fmt::format("{}({})", bold(page), section);
}

std::string program_page(const ProgramText& program) {
  std::string text = page_head(program, "rind", 1, "print a part while it is being sliced") +
                     heading("SYNOPSIS") + bold("rind") + " \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n" +
                     heading("DESCRIPTION") + paragraph(program.about) + heading("COMMANDS");
  std::string others;
  for (const CommandText& command : program.commands) {
    text += tagged(bold("rind " + command.name), command.help);
    others += reference("rind-" + command.name, 1) + ", ";
  }
  text += heading("OPTIONS") + options_of(program.options) + exits() +
          notes("ENVIRONMENT", kEnvironment, nullptr) + notes("FILES", kFiles, nullptr) +
          heading("EXAMPLES");
  for (const Example& example : kExamples) {
    text += tagged(bold(std::string(example.words)), std::string(example.text));
  }
  return text + heading("SEE ALSO") + others + reference("rind.ini", 5) + "\n";
}

std::string command_page(const ProgramText& program, const CommandText& command) {
  std::string text = page_head(program, "rind-" + command.name, 1, command.help) +
                     heading("SYNOPSIS") + bold("rind " + command.name) + " [\\fIOPTIONS\\fR]";
  for (const OptionText& option : command.options) {
    if (option.required) text += " " + option_tag(option);
  }
  for (const OptionText& operand : command.operands) {
    const std::string name = "\\fI" + manual_text(operand.names.front()) + "\\fR";
    text += operand.required ? " " + name : " [" + name + "]";
  }
  text += "\n";
  if (!command.operands.empty()) text += heading("OPERANDS") + options_of(command.operands);
  text += heading("OPTIONS") + options_of(command.options) + exits() +
          notes("ENVIRONMENT", kEnvironment, &command) + notes("FILES", kFiles, &command);
  text += heading("SEE ALSO") + reference("rind", 1);
  if (has(command.options, "--set")) text += ", " + reference("rind.ini", 5);
  return text + "\n";
}

std::string settings_page(const ProgramText& program, const std::vector<SettingRow>& settings) {
  std::string text =
      page_head(program, "rind.ini", 5, "settings of rind, and files of printers") +
      heading("DESCRIPTION") +
      paragraph(
          "A file of settings has lines KEY = VALUE; lines that begin with # or ; are comments. "
          "rind takes such a file with --profile, one setting with --set KEY=VALUE, and a "
          "printer's file with --printer. rind settings prints a file with all settings.") +
      heading("FILES OF PRINTERS") +
      paragraph(
          "rind setup writes them. The settings stand behind the line [rind]; before them "
          "stand, behind the line [printer]:") +
      tagged(bold("preset"), "the printer's preset, as rind presets lists them") +
      tagged(bold("filament"), "the filament's preset") +
      tagged(bold("quality"), "the preset of layer height and road width") +
      tagged(bold("port"), "the serial device") + tagged(bold("baud"), "its speed") +
      heading("SETTINGS");
  for (const SettingRow& row : settings) {
    text += tagged(bold(row.key), row.help);
    text +=
        ".br\n" + paragraph(fmt::format("{}; default: {}", row.range,
                                        row.default_value.empty() ? "empty" : row.default_value));
  }
  return text + notes("FILES", kFiles, nullptr) + heading("SEE ALSO") + reference("rind", 1) +
         ", " + reference("rind-settings", 1) + ", " + reference("rind-setup", 1) + "\n";
}

}  // namespace

std::string manual_text(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    switch (letter) {
      case '\\':
        out += "\\e";
        break;
      case '-':
        out += "\\-";
        break;
      case '\'':
        out += "\\(aq";
        break;
      case '`':
        out += "\\(ga";
        break;
      case '^':
        out += "\\(ha";
        break;
      case '~':
        out += "\\(ti";
        break;
      case '\n':
        out += ' ';
        break;
      default:
        out += letter;
    }
  }
  return out;
}

std::vector<ManualPage> manual_pages(const ProgramText& program,
                                     const std::vector<SettingRow>& settings) {
  std::vector<ManualPage> pages = {{"rind.1", program_page(program)}};
  for (const CommandText& command : program.commands) {
    pages.push_back({"rind-" + command.name + ".1", command_page(program, command)});
  }
  pages.push_back({"rind.ini.5", settings_page(program, settings)});
  return pages;
}

}  // namespace host
