#include "host/gcode/ready_scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/bed.h"
#include "host/gcode/command_clock.h"
#include "host/gcode/gcode_comments.h"
#include "host/gcode/ready_reader.h"

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using firmware_link::Effect;
using firmware_link::Move;
using firmware_link::ReadyLine;

constexpr std::int64_t kUnitsOfUm = 10;
// Lines between two signs of progress.
constexpr std::int64_t kProgressLines = 16'384;

// Extent of roads, and the lines where it grew last.
struct Extent {
  core::Box box;
  std::int64_t top_um = 0;
  std::int64_t outside_line = 0;  // the first road beyond the bed
  std::int64_t highest_line = 0;
};

class Scan {
 public:
  Scan(const core::Settings& settings, ReadySummary& summary)
      : origin_x_(settings.bed_origin_x.units()),
        origin_y_(settings.bed_origin_y.units()),
        bed_(settings),
        rectangular_(settings.bed_shape.empty()),
        clock_(settings),
        summary_(summary) {}

  void comment(std::string_view comment) {
    if (starts_layer(comment)) ++layer_marks_;
    if (const auto time = printing_time_in(comment)) summary_.told_s = time;
  }
  void command(const ReadyCommand& command, const GcodeModes& before, const FilePlace& behind);
  void end(const FilePlace& last);

 private:
  void look_at_move(const ReadyCommand& command, const GcodeModes& before);
  void look_at_road(const ReadyCommand& command, const GcodeModes& before);
  void grow(Extent& extent, const GcodeModes& at, std::int64_t line) const;
  void unsafe(std::string why);

  std::int64_t origin_x_;
  std::int64_t origin_y_;
  core::Bed bed_;
  bool rectangular_;
  CommandClock clock_;
  ReadySummary& summary_;
  std::int64_t layer_marks_ = 0;
  Extent all_;
  Extent in_layers_;  // that comments tell
  std::optional<std::int64_t> first_unclear_line_;
  std::vector<std::string> macros_;
};

void Scan::unsafe(std::string why) {
  if (std::find(summary_.unsafe.begin(), summary_.unsafe.end(), why) == summary_.unsafe.end()) {
    summary_.unsafe.push_back(std::move(why));
  }
}

void Scan::grow(Extent& extent, const GcodeModes& at, std::int64_t line) const {
  if (at.x_um && at.y_um) {
    const auto unit = [](std::int64_t um, std::int64_t origin) {
      constexpr std::int64_t kFar = 1'000'000'000;
      return static_cast<std::int32_t>(std::clamp(um * kUnitsOfUm - origin, -kFar, kFar));
    };
    const core::Point point{unit(*at.x_um, origin_x_), unit(*at.y_um, origin_y_)};
    const core::Box was = extent.box;
    extent.box.add(point);
    // Within a box that is on the bed, all is; but for beds that are no rectangle.
    const bool looks = !rectangular_ || !(was == extent.box);
    if (looks && extent.outside_line == 0 && !bed_.holds(point)) extent.outside_line = line;
  }
  if (at.z_um && *at.z_um > extent.top_um) {
    extent.top_um = *at.z_um;
    extent.highest_line = line;
  }
}

void Scan::look_at_road(const ReadyCommand& command, const GcodeModes& before) {
  if (before.filament_mode_unclear && !first_unclear_line_) {
    first_unclear_line_ = command.line_number;
  }
  GcodeModes behind = before;
  behind.apply(command.meaning.line);
  for (Extent* extent : {&all_, &in_layers_}) {
    if (extent == &in_layers_ && layer_marks_ == 0) continue;
    // Both ends of it.
    grow(*extent, before, command.line_number);
    grow(*extent, behind, command.line_number);
  }
  if (before.shifted) {
    unsafe("roads are laid in coordinates that G92 or G55 has moved: they can't be found again");
  }
  if (before.nozzle_tenths == 0) {
    unsafe("no line that rind knows heats the nozzle (a macro may): it could not be heated again");
  }
}

void Scan::look_at_move(const ReadyCommand& command, const GcodeModes& before) {
  const Move& move = command.meaning.line.move;
  if (move.e_10nm && !before.has(Effect::kRelativeFilament)) summary_.counts_filament = false;
  if (before.has(Effect::kInches)) summary_.counts_filament = false;
  if (move.arc) {
    ++summary_.arcs;
    if (summary_.first_arc_line == 0) summary_.first_arc_line = command.line_number;
  }
  if (command.lays_road) look_at_road(command, before);
}

void Scan::command(const ReadyCommand& command, const GcodeModes& before, const FilePlace& behind) {
  const ReadyLine& line = command.meaning.line;
  const Move& move = line.move;
  if (move.x_um || move.y_um || move.z_um || move.e_10nm) look_at_move(command, before);
  clock_.add(line);
  if (line.effect.kind == Effect::Kind::kTool && line.effect.value != 0) {
    unsafe("it uses other tools than T0, which rind would not choose and heat again");
  }
  if (line.words.text().starts_with("G10") || line.words.text().starts_with("G11")) {
    unsafe("it draws filament back by G10, of which a controller that was reset knows nothing");
  }
  if (command.meaning.macro) {
    const std::string_view text = line.words.text();
    const std::string name(text.substr(0, text.find(' ')));
    const bool known = std::find(macros_.begin(), macros_.end(), name) != macros_.end();
    if (!known && macros_.size() < kMacrosTold) macros_.push_back(name);
  }
  if (command.lays_road) summary_.last_road = behind.commands;
  if (!summary_.told_s) summary_.told_s = time_left_in(line.words.text());
}

void Scan::end(const FilePlace& last) {
  summary_.lines = last.lines;
  summary_.commands = last.commands;
  summary_.marks = layer_marks_ > 0;
  summary_.layers = static_cast<std::int32_t>(layer_marks_ > 0 ? layer_marks_ : last.layer);
  const Extent& extent = in_layers_.box.empty() ? all_ : in_layers_;
  summary_.box = extent.box;
  summary_.height = core::Length::from_units(extent.top_um * kUnitsOfUm);
  summary_.outside_line = extent.outside_line;
  summary_.highest_line = extent.highest_line;
  summary_.filament_mm = last.filament_mm;
  summary_.seconds = last.seconds;
  summary_.clock_s = clock_.seconds();
  summary_.needed_mm = clock_.needed_mm();
  summary_.needed_to_change_mm = clock_.needed_to_change_mm();
  if (!last.set_up_whole) unsafe("it sets up more than rind remembers");
  if (!macros_.empty()) {
    unsafe(fmt::format("what the macro{} {} set{} up is not known", macros_.size() > 1 ? "s" : "",
                       fmt::join(macros_, ", "), macros_.size() > 1 ? "" : "s"));
  }
  if (first_unclear_line_) {
    summary_.warnings.push_back(
        fmt::format("line {}: filament moves behind a G90 or G91 that no M82 or M83 follows; "
                    "Marlin and Klipper "
                    "take it differently, and rind as the controller does that it finds",
                    *first_unclear_line_));
  }
  const GcodeModes& modes = last.modes;
  if (modes.nozzle_tenths > 0 || modes.bed_tenths > 0) {
    summary_.warnings.push_back("the file ends with a heater on");
  }
}

}  // namespace

Result<ReadySummary> scan_ready(GcodeText& text, const core::Settings& settings,
                                const ScanRequest& request) {
  ReadySummary summary;
  Scan scan(settings, summary);
  MeaningRules rules;
  rules.allowed = request.allowed;
  // Layers by height: whether comments tell them is known at the end alone.
  ReadyReader reader(text, std::move(rules), false);
  reader.on_comment = [&scan](std::string_view comment) { scan.comment(comment); };
  std::int64_t told_lines = 0;
  while (true) {
    const GcodeModes before = reader.behind().modes;
    Result<std::optional<ReadyCommand>> read = reader.next();
    if (!read.ok()) return read.error();
    if (!read.value()) break;
    scan.command(*read.value(), before, reader.behind());
    if (request.on_progress && reader.behind().lines - told_lines >= kProgressLines) {
      told_lines = reader.behind().lines;
      if (!request.on_progress(text.bytes_read())) {
        return Error{ErrorCode::kUnreadable, "stopped"};
      }
    }
  }
  scan.end(reader.behind());
  if (!summary.told_s) {
    const std::string& metadata = text.metadata();
    for (std::size_t at = 0; at < metadata.size() && !summary.told_s;) {
      const std::size_t end = std::min(metadata.find('\n', at), metadata.size());
      summary.told_s = printing_time_in(std::string_view(metadata).substr(at, end - at));
      at = end + 1;
    }
  }
  summary.content = {text.hash(), text.bytes_read()};
  if (summary.filament_mm <= 0) {
    return Error{ErrorCode::kBadPart, "no line of it lays any material"};
  }
  return summary;
}

}  // namespace host
