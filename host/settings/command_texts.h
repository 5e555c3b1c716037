// What the command line offers, as plain text: manual pages and completions are written from it.
#pragma once

#include <string>
#include <vector>

namespace host {

// What a value names; completions propose accordingly.
enum class ValueKind {
  kNone,     // there is no value
  kText,     // nothing can be proposed
  kWords,    // one of `words`
  kFile,     // of any kind
  kFolder,   // a folder
  kPort,     // a serial device, or "virtual"
  kPrinter,  // "none", or one that was set up: a file in the user's folder (printer_file.h)
  kSetting,  // KEY=VALUE
};

struct OptionText {
  std::vector<std::string> names;  // "--threads", "--jobs"; of an operand: its placeholder
  std::string value;               // its placeholder, "FILE"; may be empty
  ValueKind kind = ValueKind::kNone;
  std::vector<std::string> words;  // kWords
  std::string help;
  std::string usual;  // what it is if it is not given; may be empty
  bool required = false;
  bool repeatable = false;
};

struct CommandText {
  std::string name;
  std::string help;
  std::vector<OptionText> operands;
  std::vector<OptionText> options;
};

struct ProgramText {
  std::string about;
  std::string version;
  std::vector<OptionText> options;
  std::vector<CommandText> commands;
};

}  // namespace host
