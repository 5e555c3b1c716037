// A print in one process: a part, the print plan, and a virtual controller that notes what it
// executed and whose wire can be cut.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "firmware_link/virtual/virtual_port.h"
#include "host/output/gcode_writer.h"
#include "host/part/part_file.h"
#include "host/pipeline/pipeline.h"
#include "host/printing/port_clock.h"
#include "host/printing/print_part.h"
#include "tests/host/ready_files.h"
#include "tests/host/scripted_control.h"
#include "tests/support/own_lines.h"
#include "tests/support/part_folder.h"

namespace print_test {

// Passes everything on until it is told to break.
class BreakablePort final : public firmware_link::BytePort {
 public:
  explicit BreakablePort(firmware_link::BytePort& inner) : inner_(inner) {}

  std::function<void()> on_read;  // before each

  void unplug() { unplugged_ = true; }
  // The controller's next words.
  void say(std::string text) { words_ = std::move(text); }

  [[nodiscard]] std::size_t write(std::span<const std::byte> bytes) override {
    return unplugged_ ? 0 : inner_.write(bytes);
  }
  [[nodiscard]] std::size_t read(std::span<std::byte> into, int timeout_ms) override {
    if (on_read) on_read();
    if (unplugged_) return 0;
    if (words_.empty()) return inner_.read(into, timeout_ms);
    const std::size_t count = std::min(into.size(), words_.size());
    std::memcpy(into.data(), words_.data(), count);
    words_.erase(0, count);
    return count;
  }
  [[nodiscard]] firmware_link::PortState state() const override {
    return unplugged_ ? firmware_link::PortState::kLost : inner_.state();
  }

 private:
  firmware_link::BytePort& inner_;
  bool unplugged_ = false;
  std::string words_;
};

inline host::PrintPlan open(const core::Settings& settings, const std::string& path) {
  if (path.ends_with("gcode")) return open_ready(settings, path, path.ends_with(".bgcode"));
  core::Result<host::OpenedPart> part = host::open_whole_part(path, settings);
  if (!part.ok()) FAIL(part.error().message);
  return {settings, std::move(part).value(), path};
}

struct Rig {
  host::PrintPlan print_plan;
  // Commands as the controller took them, without the link's own; to a Marlin the numbered ones.
  std::vector<std::string> executed;
  std::vector<std::string> sent;      // the same as they were sent: moves are not spelled out
  std::function<void()> on_executed;  // after each
  ScriptedControl control;
  host::PrintOptions options;  // what a test wants of it
  std::unique_ptr<firmware_link::VirtualPort> port;
  std::unique_ptr<BreakablePort> wire;

  Rig(const core::Settings& settings, const std::string& path,
      firmware_link::VirtualControllerOptions machine = {})
      : Rig(settings, open(settings, path), std::move(machine)) {}
  Rig(const core::Settings& settings, host::PrintPlan opened,
      firmware_link::VirtualControllerOptions machine = {})
      : print_plan(std::move(opened)) {
    machine.bed_x_mm = settings.bed_x.mm();
    machine.bed_y_mm = settings.bed_y.mm();
    machine.bed_origin_x_mm = settings.bed_origin_x.mm();
    machine.bed_origin_y_mm = settings.bed_origin_y.mm();
    const bool numbers = machine.dialect == firmware_link::VirtualDialect::kMarlin ||
                         machine.dialect == firmware_link::VirtualDialect::kPrusa;
    machine.executed = [this, numbers](const firmware_link::ExecutedCommand& command) {
      const std::string text(command.text);
      if ((command.number || !numbers) && !test::is_own_line(text)) {
        executed.push_back(text);
        sent.emplace_back(command.words);
      }
      if (on_executed) on_executed();
    };
    port = std::make_unique<firmware_link::VirtualPort>(machine, host::steady_port_clock(), 0);
    wire = std::make_unique<BreakablePort>(*port);
  }

  [[nodiscard]] host::PrintOutcome print() {
    host::Reporter reporter({.quiet = true, .json = false, .stdout_taken = false});
    return host::print_part(
        {print_plan, *wire, control, reporter, options, host::steady_seconds()});
  }

  [[nodiscard]] firmware_link::VirtualControllerState controller() {
    return port->controller().state();
  }

  [[nodiscard]] std::int64_t count(std::string_view begin) const {
    return std::count_if(executed.begin(), executed.end(), [begin](const std::string& text) {
      return text.compare(0, begin.size(), begin) == 0;
    });
  }
};

// What `rind slice` writes, comments and empty lines left out.
inline std::vector<std::string> sliced_lines(const core::Settings& settings,
                                             const std::string& path,
                                             host::GeometryStatistics& statistics) {
  host::PrintPlan print_plan = open(settings, path);
  std::string text;
  host::GcodeWriter writer(settings.pause_gcode);
  host::PipelineOutputs outputs;
  outputs.on_motion = [&](const core::Motion& motion,
                          const std::optional<firmware_link::Command>& command) {
    writer.write(motion, command, text);
    return true;
  };
  host::PipelineSignals signals;
  const auto end = host::run_pipeline(print_plan, outputs, signals, statistics);
  REQUIRE(end.ok());
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t line_end = text.find('\n', at);
    if (text[at] != ';') lines.push_back(text.substr(at, line_end - at));
    at = line_end + 1;
  }
  return lines;
}

inline std::vector<std::string> sliced_lines(const core::Settings& settings,
                                             const std::string& path) {
  host::GeometryStatistics statistics;
  return sliced_lines(settings, path, statistics);
}

// The same without the lines that a session has of its own, too, as Rig::executed has them.
inline std::vector<std::string> given_lines(const core::Settings& settings,
                                            const std::string& path) {
  std::vector<std::string> lines = sliced_lines(settings, path);
  std::erase_if(lines, [](const std::string& line) { return test::is_own_line(line); });
  return lines;
}

}  // namespace print_test
