#include "host/gcode/ready_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <utility>

#include "host/gcode/gcode_comments.h"  // starts_layer

namespace host {
namespace {

using firmware_link::Move;

double step_um(const std::optional<std::int64_t>& to, const std::optional<std::int64_t>& from) {
  return to && from ? static_cast<double>(*to - *from) : 0;
}

// In seconds, at the move's feed.
double time_of(const Move& move, const GcodeModes& before) {
  const std::int64_t feed = move.f_mm_min.value_or(before.f_mm_min.value_or(0));
  if (feed <= 0) return 0;
  double way_um = std::hypot(step_um(move.x_um, before.x_um), step_um(move.y_um, before.y_um),
                             step_um(move.z_um, before.z_um));
  if (move.arc) way_um = static_cast<double>(move.arc->length_um);
  if (way_um == 0) way_um = std::abs(static_cast<double>(move.e_10nm.value_or(0))) / 100;
  return way_um * 60 / 1'000 / static_cast<double>(feed);
}

}  // namespace

ReadyReader::ReadyReader(GcodeText& text, MeaningRules rules, bool marks, FilePlace from)
    : rules_(std::move(rules)),
      marks_(marks),
      lines_(text, from.lines),
      set_up_(from.set_up),
      place_(std::move(from)) {
  place_.set_up.clear();
}

FilePlace ReadyReader::before() const {
  FilePlace place = before_;
  place.set_up = set_up_.text();
  place.set_up_whole = place_.set_up_whole;
  return place;
}

core::Result<std::optional<ReadyCommand>> ReadyReader::next() {
  while (true) {
    core::Result<std::optional<GcodeLine>> read = lines_.next();
    if (!read.ok()) return read.error();
    if (!read.value()) return std::optional<ReadyCommand>();
    const GcodeLine& line = *read.value();
    if (!line.comment.empty()) {
      if (on_comment) on_comment(line.comment);
      if (marks_ && starts_layer(line.comment)) ++place_.layer;
    }
    place_.text = line.place;
    place_.lines = line.number - 1;
    before_ = place_;
    core::Result<std::optional<LineMeaning>> meaning = meaning_of(line.text, rules_, place_.modes);
    if (!meaning.ok()) {
      const std::string_view shown = line.text.substr(0, 80);
      return core::Error{meaning.error().code, fmt::format("line {} ('{}'): {}", line.number, shown,
                                                           meaning.error().message)};
    }
    if (!meaning.value()) continue;
    ReadyCommand command;
    command.meaning = *std::move(meaning).value();
    command.line_number = line.number;
    note(command);
    return std::optional(command);
  }
}

void ReadyReader::note(ReadyCommand& command) {
  const firmware_link::ReadyLine& line = command.meaning.line;
  place_.lines = command.line_number;
  ++place_.commands;
  command.lays_road = lays_road(line.move);
  command.way_seconds = time_of(line.move, before_.modes);
  place_.seconds += command.way_seconds;
  if (command.meaning.sets_up) set_up_.add(line.words.text());
  place_.set_up_whole = place_.set_up_whole && !set_up_.left_out();
  if (!command.lays_road) return;
  place_.filament_mm += static_cast<double>(*line.move.e_10nm) * 1e-5;
  const std::int64_t z_um = place_.modes.z_um.value_or(0);
  if (marks_) {
    place_.top_um = z_um;
  } else if (place_.layer == 0 || z_um >= place_.top_um + kLayerStepUm) {
    ++place_.layer;
    place_.top_um = z_um;
  }
}

}  // namespace host
