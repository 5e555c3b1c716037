#include "host/printing/ready_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "host/gcode/ready_reader.h"

namespace host {
namespace {

using core::Error;
using core::Result;

Checkpoint checkpoint_at(FilePlace place) {
  Checkpoint checkpoint;
  checkpoint.layer = std::max(0, place.layer - 1);
  checkpoint.commands = place.commands;
  checkpoint.filament_mm = place.filament_mm;
  checkpoint.file = std::make_shared<const FilePlace>(std::move(place));
  return checkpoint;
}

// What only the controller that is found lets know.
void warn_of_arcs(const ReadySummary& summary, const CommandForm& form, PipelineSignals& signals) {
  if (summary.arcs == 0 || form.arcs) return;
  signals.warnings.put(fmt::format(
      "the file has {} arcs (G2, G3), the first in line {}, and the controller does not say that "
      "it "
      "draws them (Klipper needs [gcode_arcs]): if it does not, turn arcs off in the slicer",
      summary.arcs, summary.first_arc_line));
}

// What a printer moves before its first layer and behind its last may be cut short by the end
// stops of its software, as where it wipes the nozzle beside the bed. So it is not asked whether it
// is there.
void beside_layers(firmware_link::ReadyLine& line) {
  using firmware_link::PlaceAfter;
  if (line.place == PlaceAfter::kByMove) line.place = PlaceAfter::kAsBefore;
}

}  // namespace

Result<bool> run_ready(const PrintPlan& print_plan, const JournalRecord* resumed,
                       QueueFiller& filler, PipelineSignals& signals,
                       GeometryStatistics& statistics) {
  const ReadyFile& file = *print_plan.ready;
  const ReadySummary& summary = file.summary();
  const std::string name = file.name();
  signals.layers.store(summary.layers);
  signals.full_speed_s.store(summary.seconds);
  signals.time_s.store(summary.time_s());
  statistics.layers = summary.layers;
  statistics.arcs = summary.arcs;
  statistics.filament_mm[0] = summary.filament_mm;
  statistics.needed = {summary.needed_mm, summary.needed_to_change_mm};
  statistics.time_s = summary.time_s();
  FilePlace from;
  if (resumed != nullptr) {
    if (!resumed->checkpoint.file) {
      return Error{core::ErrorCode::kBadPart,
                   name + ": the print that was interrupted was one of a part, not of G-code"};
    }
    from = *resumed->checkpoint.file;
  }
  const CommandForm form = print_plan.command_form();
  warn_of_arcs(summary, form, signals);
  const std::unique_ptr<GcodeText> text = file.text();
  if (core::Status there = text->go_to(from.text); !there.ok()) return there.error();
  MeaningRules rules;
  rules.flavor = form.flavor;
  rules.checks = false;
  std::int64_t next_checkpoint = from.commands;
  ReadyReader reader(*text, std::move(rules), summary.marks, std::move(from));
  while (!signals.stop_asked()) {
    Result<std::optional<ReadyCommand>> read = reader.next();
    if (!read.ok()) return read.error();
    if (!read.value()) return true;
    ReadyCommand& command = *read.value();
    const FilePlace& behind = reader.behind();
    if (behind.layer == 0 || behind.commands > summary.last_road) {
      beside_layers(command.meaning.line);
    }
    if (command.meaning.sets_up || behind.commands > next_checkpoint) {
      filler.start_layer(checkpoint_at(reader.before()));
      next_checkpoint = behind.commands + kCheckpointCommands - 1;
    }
    if (!filler.take_ready(command, behind)) return false;
  }
  return false;
}

}  // namespace host
