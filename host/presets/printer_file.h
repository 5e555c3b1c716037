// The printers that the user has set up: files that `rind setup` writes, and people edit.
//
//     $XDG_CONFIG_HOME/rind, or ~/.config/rind
//         printer.ini        the one that is used if none is named
//         NAME.ini           --printer NAME
//
//     [printer]
//     preset = ender3        presets.h
//     filament = pla
//     quality = 0.2
//     port = /dev/serial/by-id/usb-1a86_USB_Serial-if00-port0
//     baud = 115200
//     [rind]
//     bed_x = 230            settings, over those of the presets
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"  // Result

namespace host {

inline constexpr std::size_t kPrinterFileBytesMax = 1 << 20;
// The printer that is used if none is named.
inline constexpr std::string_view kUsualPrinter = "printer";
// --printer: no file of a printer.
inline constexpr std::string_view kNoPrinter = "none";

struct PrinterFile {
  std::string path;
  std::string preset;  // this and the next four: empty where nothing is said
  std::string filament;
  std::string quality;
  std::string port;
  int baud = 0;          // 0: not said
  std::string settings;  // the text of a profile, with the file's line numbers
};

// Empty: there is no such folder ($HOME is not set).
[[nodiscard]] std::string printer_folder();

// A file's name without ".ini": letters, digits, '-', '_' and '.', not first a '.', at most 64.
[[nodiscard]] bool is_printer_name(std::string_view name);

// REQUIRES: is_printer_name(name), printer_folder() is not empty
[[nodiscard]] std::string printer_path(std::string_view name);

// Names of the printers that were set up, at most `kPrintersListedMax`, in order.
inline constexpr std::size_t kPrintersListedMax = 100;
[[nodiscard]] std::vector<std::string> printer_names();

// `name`: as --printer has it. Empty: kUsualPrinter, if it is there. kNoPrinter: nothing.
// An error of a named one that is not there names those that are.
[[nodiscard]] core::Result<std::optional<PrinterFile>> find_printer(std::string_view name);

// Errors start with "path:line: ".
[[nodiscard]] core::Result<PrinterFile> read_printer(std::string_view text,
                                                     const std::string& path);

// ENSURES: read_printer() reads it back, but for the line numbers.
[[nodiscard]] std::string written_printer(const PrinterFile& printer);

}  // namespace host
