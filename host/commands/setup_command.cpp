// Finds the port, asks the controller what it is, asks the user for the rest, and writes a
// printer's file (presets/printer_file.h). Nothing is heated or moved.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "firmware_link/ports/ports.h"
#include "firmware_link/virtual/virtual_port.h"
#include "host/commands/commands.h"
#include "host/commands/setup_questions.h"
#include "host/presets/presets.h"
#include "host/presets/printer_file.h"
#include "host/printing/controller_facts.h"
#include "host/printing/port_clock.h"
#include "host/settings/settings_text.h"  // write_number
#include "host/system/exit_codes.h"
#include "host/system/stop_signals.h"
#include "host/system/text.h"  // lower_case

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;
using firmware_link::BytePort;

// How long a controller may take until it has told what it is: Klipper's start takes as long.
constexpr double kAnswer_s = 20;
// Speeds that are tried where none is named, the most usual first.
constexpr int kBauds[] = {115'200, 250'000};
constexpr int kSetAsideMax = 100;
// Longer axes are no answer, but a controller that knows none.
constexpr double kFarthest_mm = 1e5;

bool stop_asked() { return stop_signal_count() > 0; }

Error refusal(std::string message) { return {ErrorCode::kBadSetting, std::move(message)}; }

Result<std::string> choose_port(const Options& options, SetupQuestions& questions) {
  if (!options.link.port.empty()) return options.link.port;
  const std::vector<firmware_link::PortDescription> ports = firmware_link::list_ports();
  if (ports.empty()) {
    return refusal(
        "no serial port was found: is the printer plugged in and switched on? Otherwise name it: "
        "--port /dev/ttyUSB0, a pseudo-terminal of Klipper, tcp://HOST:PORT; --port virtual is a "
        "controller inside this program");
  }
  std::vector<std::string> lines;
  lines.reserve(ports.size());
  for (const firmware_link::PortDescription& port : ports) {
    lines.push_back(fmt::format("{}  {}{}", port.path, port.description,
                                port.usb.empty() ? "" : "  " + port.usb));
  }
  const Result<std::size_t> chosen = questions.one_of("Which port is the printer's?", lines);
  if (!chosen.ok()) return chosen.error();
  return ports[chosen.value()].path;
}

// The name that stays the same when the device is plugged in again, if it has one.
std::string lasting_name(const std::string& port) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::weakly_canonical(port, error);
  std::filesystem::directory_iterator link("/dev/serial/by-id", error);
  for (; !error && link != std::filesystem::directory_iterator(); link.increment(error)) {
    if (std::filesystem::weakly_canonical(link->path(), error) == real) {
      return link->path().string();
    }
  }
  return port;
}

Result<std::unique_ptr<BytePort>> opened(const std::string& port, int baud) {
  if (port == "virtual") {
    return std::unique_ptr<BytePort>(std::make_unique<firmware_link::VirtualPort>(
        firmware_link::VirtualControllerOptions(), steady_port_clock(), 1));
  }
  firmware_link::OpenedPort attempt = firmware_link::open_port(port, baud);
  if (const auto* error = std::get_if<firmware_link::PortError>(&attempt)) {
    return refusal(port + ": " + error->cause + "; " + error->remedy);
  }
  return std::get<std::unique_ptr<BytePort>>(std::move(attempt));
}

struct Answer {
  ControllerFacts facts;
  int baud = 0;
};

Result<Answer> ask_at_each_speed(const Options& options, const std::string& port,
                                 Reporter& reporter) {
  std::vector<int> bauds(std::begin(kBauds), std::end(kBauds));
  const bool has_speed = port != "virtual" && port.rfind("tcp://", 0) != 0;
  if (options.link.baud_told || !has_speed) bauds = {options.link.baud};
  Answer answer;
  for (const int baud : bauds) {
    reporter.note("asking", has_speed ? fmt::format("asking {} at {} baud", port, baud)
                                      : fmt::format("asking {}", port));
    Result<std::unique_ptr<BytePort>> link = opened(port, baud);
    if (!link.ok()) return link.error();
    answer = {ask_controller(*link.value(), kAnswer_s, stop_asked), baud};
    if (answer.facts.answered || stop_asked()) break;
  }
  return answer;
}

// The preset whose words the controller's name has; the longest words win.
std::string preset_by_name(const std::string& machine_type) {
  std::string best, best_words;
  for (const PresetText& one : preset_texts()) {
    if (one.kind != PresetKind::kPrinter) continue;
    const Result<Preset> preset = find_preset(one.kind, one.name);
    if (!preset.ok() || preset.value().machine_type.empty()) continue;
    const std::string& words = preset.value().machine_type;
    if (lower_case(machine_type).find(lower_case(words)) == std::string::npos) continue;
    if (words.size() > best_words.size()) std::tie(best, best_words) = std::pair(one.name, words);
  }
  return best;
}

std::string proposed_preset(const ControllerFacts& facts) {
  if (std::string named = preset_by_name(facts.machine_type); !named.empty()) return named;
  if (facts.dialect == "Klipper") return "klipper";
  if (facts.dialect == "RepRapFirmware") return "duet";
  return "marlin";
}

std::vector<std::string> names_of(PresetKind kind) {
  std::vector<std::string> names;
  for (const PresetText& one : preset_texts()) {
    if (one.kind == kind) names.emplace_back(one.name);
  }
  return names;
}

// A side of the bed, from the command line, the controller, or the user.
Result<std::string> side(const Options& options, const ControllerFacts& facts, std::size_t axis,
                         SetupQuestions& questions) {
  constexpr const char* kKeys[] = {"bed_x", "bed_y", "axis_z"};
  constexpr const char* kWords[] = {"How wide is the bed (X), in mm?",
                                    "How deep is the bed (Y), in mm?",
                                    "How high can the nozzle go (Z), in mm?"};
  for (const auto& [key, value] : options.settings.assignments) {
    if (key == kKeys[axis]) return std::string();
  }
  std::string told, origin;
  if (facts.travel) {
    const double least = facts.travel->min_mm[axis], most = facts.travel->max_mm[axis];
    // A nozzle that goes somewhat farther than the front left corner wipes itself there.
    constexpr double kBeside_mm = 20;
    const bool centred = axis < 2 && least <= -kBeside_mm;
    const double mm = std::floor(centred ? most - least : most);
    if (mm >= 1 && mm < kFarthest_mm) told = write_number(mm);
    if (centred && !told.empty()) {
      origin = fmt::format("bed_origin_{} = {}\n", axis == 0 ? "x" : "y", write_number(least));
    }
  }
  // The height may stay unknown: a part that is too high is then refused by nobody.
  if (axis == 2 && told.empty()) return std::string("axis_z = off\n");
  const Result<double> mm = questions.number(kWords[axis], told, kKeys[axis]);
  if (!mm.ok()) return mm.error();
  return fmt::format("{} = {}\n{}", kKeys[axis], write_number(mm.value()), origin);
}

Status set_aside(const std::string& path, Reporter& reporter) {
  std::error_code error;
  for (int number = 1; number <= kSetAsideMax; ++number) {
    const std::string old = path + (number == 1 ? ".old" : fmt::format(".old{}", number));
    if (std::filesystem::exists(old, error)) continue;
    std::filesystem::rename(path, old, error);
    if (error) break;
    reporter.note("action", fmt::format("{} is set aside as {}", path, old));
    return {};
  }
  return refusal(path + ": can't be set aside as " + path + ".old");
}

Status make_room(const Options& options, const std::string& path, SetupQuestions& questions,
                 Reporter& reporter) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    std::filesystem::create_directories(std::filesystem::path(path).parent_path(), error);
    if (error) return refusal(path + ": its folder can't be made: " + error.message());
    return {};
  }
  if (options.print.anew ||
      questions.agreed(fmt::format("{} is there already. Set it aside (.old)?", path))) {
    return set_aside(path, reporter);
  }
  return refusal(path +
                 " is there already: --anew sets it aside, --printer NAME sets up another "
                 "printer");
}

class Setup {
 public:
  Setup(const Options& options, Reporter& reporter)
      : options_(options), reporter_(reporter), questions_(!options.print.yes) {}

  Status run() {
    const std::string& named = options_.settings.printer.printer;
    if (printer_folder().empty()) return refusal("neither $XDG_CONFIG_HOME nor $HOME is set");
    if (!named.empty() && !is_printer_name(named)) {
      return refusal("\"" + named + "\" is no printer's name: letters, digits, '-', '_', '.'");
    }
    printer_.path = printer_path(named.empty() ? kUsualPrinter : named);
    for (const auto step : {&Setup::ask_controller_, &Setup::choose_presets, &Setup::measure}) {
      if (Status done = (this->*step)(); !done.ok()) return done;
    }
    return write();
  }

 private:
  Status ask_controller_() {
    const Result<std::string> port = choose_port(options_, questions_);
    if (!port.ok()) return port.error();
    Result<Answer> answer = ask_at_each_speed(options_, port.value(), reporter_);
    if (!answer.ok()) return answer.error();
    facts_ = std::move(answer.value().facts);
    printer_.port = lasting_name(port.value());
    if (stop_asked()) return refusal("stopped; nothing is written");
    if (facts_.answered) {
      const std::string& type = facts_.machine_type;
      reporter_.note("controller", fmt::format("it is {}{}", facts_.firmware,
                                               type.empty() ? "" : ", and calls itself " + type));
      if (port.value() != "virtual") printer_.baud = answer.value().baud;
      return {};
    }
    if (options_.settings.printer.preset.empty()) {
      return refusal(
          fmt::format("{}: {}; check cable, power and --baud, or say what it is: "
                      "--preset NAME (rind presets lists them)",
                      port.value(), facts_.why_not));
    }
    reporter_.note("warning",
                   fmt::format("{}: {}; it is set up as you say", port.value(), facts_.why_not));
    if (options_.link.baud_told) printer_.baud = options_.link.baud;
    return {};
  }

  Status choose_presets() {
    const PrinterRequest& typed = options_.settings.printer;
    const auto choose = [this](PresetKind kind, const std::string& said, const std::string& usual,
                               std::string& into) -> Status {
      Result<std::string> chosen = said;
      if (said.empty()) {
        chosen = questions_.named(fmt::format("Which {}?", preset_kind_word(kind)), names_of(kind),
                                  usual);
      }
      if (!chosen.ok()) return chosen.error();
      if (const auto found = find_preset(kind, chosen.value()); !found.ok()) return found.error();
      into = chosen.value();
      return {};
    };
    Status done =
        choose(PresetKind::kPrinter, typed.preset, proposed_preset(facts_), printer_.preset);
    if (done.ok()) done = choose(PresetKind::kFilament, typed.filament, "pla", printer_.filament);
    if (done.ok()) done = choose(PresetKind::kQuality, typed.quality, "0.2", printer_.quality);
    return done;
  }

  // What the presets of any printer can't know.
  Status measure() {
    const Result<Preset> preset = find_preset(PresetKind::kPrinter, printer_.preset);
    if (!preset.ok()) return preset.error();
    if (!preset.value().measured) {
      for (const std::size_t axis : {0U, 1U, 2U}) {
        const Result<std::string> line = side(options_, facts_, axis, questions_);
        if (!line.ok()) return line.error();
        printer_.settings += line.value();
      }
    }
    for (const auto& [key, value] : options_.settings.assignments) {
      printer_.settings += fmt::format("{} = {}\n", key, value);
    }
    return {};
  }

  Status write() {
    const std::string text = written_printer(printer_);
    if (Status fits = check(text); !fits.ok()) return fits;
    if (Status room = make_room(options_, printer_.path, questions_, reporter_); !room.ok()) {
      return room;
    }
    if (Status written = write_output(printer_.path, text); !written.ok()) return written;
    const std::string& named = options_.settings.printer.printer;
    reporter_.note("written",
                   fmt::format("{}:\n{}\nNow print: rind print PART.stl{}", printer_.path, text,
                               named.empty() ? "" : " --printer " + named));
    return {};
  }

  // Whether a print could use it.
  [[nodiscard]] Status check(const std::string& text) const {
    const Result<PrinterFile> read = read_printer(text, printer_.path);
    if (!read.ok()) return read.error();
    SettingsRequest request;
    request.printer.given = read.value();
    const Result<WholeSettings> whole = whole_settings(request);
    return whole.ok() ? Status() : whole.error();
  }

  const Options& options_;
  Reporter& reporter_;
  SetupQuestions questions_;
  ControllerFacts facts_;
  PrinterFile printer_;
};

}  // namespace

int setup_command(const Options& options, Reporter& reporter) {
  const Status done = Setup(options, reporter).run();
  return done.ok() ? kExitDone : fail(done.error(), reporter);
}

}  // namespace host
