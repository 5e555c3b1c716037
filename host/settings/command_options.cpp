#include "host/settings/command_options.h"

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/limits.h"  // kObjectsMax

namespace host {
namespace {

// Takes one of the words. They stand behind the value's name (get_type_name()) for completions;
// help leaves them out.
template <typename Value>
CLI::CheckedTransformer one_of(const std::map<std::string, Value>& words) {
  std::string all;
  for (const auto& [word, value] : words) all += (all.empty() ? "" : ",") + word;
  CLI::CheckedTransformer check(words);
  check.description("{" + all + "}");
  return check;
}

void add_tall(CLI::App& command, Options& options) {
  command.add_flag("--tall", options.part.tall,
                   "the part is meant to be that high: accept corners that look stray");
}

}  // namespace

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
      ->transform(one_of(kWords))
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
      ->transform(one_of(kWords))
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
      .add_option(
          "--threads,--jobs", options.threads,
          "number of processors to slice with, of those that there are; each needs the memory "
          "of one more layer")
      ->type_name("N")
      ->check(CLI::Range(1, kThreadsMax))
      ->default_str("as many as there are, at most " + std::to_string(kThreadsDefaultMax));
  command
      .add_option("--memory-limit", options.memory_limit_bytes,
                  "memory of the whole program, as 64M; end with an error if more is needed")
      ->type_name("BYTES")
      ->transform(CLI::AsSizeValue(false).description(""));
}

void add_part(CLI::App& command, Options& options) {
  command
      .add_option_function<std::vector<std::string>>(
          "PART",
          [&options](const std::vector<std::string>& paths) {
            options.part.path = paths.front();
            options.part.more_paths.assign(paths.begin() + 1, paths.end());
          },
          "the part's file, or - for standard input; several are laid beside one another")
      ->required()
      ->expected(1, core::kObjectsMax)
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
      ->transform(one_of(kWords));
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
      ->transform(one_of(kWords));
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

}  // namespace host
