#include "host/presets/printer_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "host/presets/headed_profile.h"
#include "host/presets/presets.h"  // find_preset

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

constexpr std::string_view kEnding = ".ini";
constexpr std::array<std::string_view, 5> kKeys = {"preset", "filament", "quality", "port", "baud"};
constexpr int kBaudMin = 300;
constexpr int kBaudMax = 4'000'000;

Error bad(std::string message) { return {ErrorCode::kBadSetting, std::move(message)}; }

Result<int> read_baud(std::string_view text, const std::string& path) {
  if (text.empty()) return 0;
  int baud = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), baud);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (whole && baud >= kBaudMin && baud <= kBaudMax) return baud;
  return bad(fmt::format("{}: baud = {}: expected a whole number from {} to {}", path, text,
                         kBaudMin, kBaudMax));
}

Result<std::string> whole_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  if (file) {
    text.resize(kPrinterFileBytesMax + 1);
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
  }
  if (!file.eof()) {
    return Error{ErrorCode::kUnreadable, path + (text.size() > kPrinterFileBytesMax
                                                     ? ": too large: not a printer's settings"
                                                     : ": can't be read")};
  }
  return text;
}

std::string known_printers() {
  std::string known;
  for (const std::string& name : printer_names()) known += (known.empty() ? "" : ", ") + name;
  return known.empty() ? "none was set up; rind setup does it" : "there are " + known;
}

}  // namespace

std::string printer_folder() {
  const char* configuration = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  if (configuration != nullptr && *configuration == '/') {
    return std::string(configuration) + "/rind";
  }
  if (home != nullptr && *home == '/') return std::string(home) + "/.config/rind";
  return {};
}

bool is_printer_name(std::string_view name) {
  constexpr std::size_t kBytesMax = 64;
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  return !name.empty() && name.size() <= kBytesMax && name.front() != '.' && name != kNoPrinter &&
         std::all_of(name.begin(), name.end(), fits);
}

std::string printer_path(std::string_view name) {
  return fmt::format("{}/{}{}", printer_folder(), name, kEnding);
}

std::vector<std::string> printer_names() {
  std::vector<std::string> names;
  std::error_code error;
  std::filesystem::directory_iterator file(printer_folder(), error);
  for (; !error && file != std::filesystem::directory_iterator(); file.increment(error)) {
    const std::filesystem::path path = file->path();
    if (path.extension() != kEnding || !is_printer_name(path.stem().string())) continue;
    names.push_back(path.stem().string());
    if (names.size() == kPrintersListedMax) break;
  }
  std::sort(names.begin(), names.end());
  return names;
}

Result<PrinterFile> read_printer(std::string_view text, const std::string& path) {
  if (text.find('\0') != std::string_view::npos) {
    return bad(path + ": holds a zero byte: not a printer's settings");
  }
  Result<HeadedProfile> read = read_headed_profile(text, path, "printer", kKeys);
  if (!read.ok()) return read.error();
  HeadedProfile& profile = read.value();
  const Result<int> baud = read_baud(profile.value("baud"), path);
  if (!baud.ok()) return baud.error();
  PrinterFile printer;
  printer.path = path;
  printer.preset = profile.value("preset");
  printer.filament = profile.value("filament");
  printer.quality = profile.value("quality");
  printer.port = profile.value("port");
  printer.baud = baud.value();
  printer.settings = std::move(profile.settings);
  return printer;
}

Result<std::optional<PrinterFile>> find_printer(std::string_view name) {
  if (name == kNoPrinter) return std::optional<PrinterFile>();
  if (!name.empty() && !is_printer_name(name)) {
    return bad(fmt::format("\"{}\" is no printer's name: letters, digits, '-', '_', '.'; {}", name,
                           known_printers()));
  }
  const bool usual = name.empty();
  if (printer_folder().empty()) {
    if (usual) return std::optional<PrinterFile>();
    return bad("no printer is known: neither $XDG_CONFIG_HOME nor $HOME is set");
  }
  const std::string path = printer_path(usual ? kUsualPrinter : name);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    if (usual) return std::optional<PrinterFile>();
    const std::string preset = find_preset(PresetKind::kPrinter, name).ok()
                                   ? fmt::format("; a preset has this name: --preset {}", name)
                                   : "";
    return bad(
        fmt::format("there is no printer \"{}\" ({}); {}{}", name, path, known_printers(), preset));
  }
  const Result<std::string> text = whole_file(path);
  if (!text.ok()) return text.error();
  Result<PrinterFile> read = read_printer(text.value(), path);
  if (!read.ok()) return read.error();
  return std::optional<PrinterFile>(std::move(read).value());
}

std::string written_printer(const PrinterFile& printer) {
  std::string text =
      "# A printer of rind: --printer names its file. rind presets, rind settings\n"
      "# tell what may stand here; an unknown key is an error.\n[printer]\n";
  const auto add = [&text](std::string_view key, const std::string& value) {
    if (!value.empty()) text += fmt::format("{} = {}\n", key, value);
  };
  add("preset", printer.preset);
  add("filament", printer.filament);
  add("quality", printer.quality);
  add("port", printer.port);
  if (printer.baud > 0) add("baud", std::to_string(printer.baud));
  return text + "\n[rind]\n" + printer.settings;
}

}  // namespace host
