#include "host/printing/print_start.h"

#include <optional>

namespace host {
namespace {

// Twice, because an answer may be damaged.
constexpr int kQuestions = 2;

ParkMoves park_moves_in(const core::Settings& machine, const core::Box& part) {
  return {machine, parking_position(machine, part)};
}

}  // namespace

PrintStart::PrintStart(const core::Settings& settings, const MachineSpace& space,
                       const PartExtent& part)
    : settings_(settings),
      space_(space),
      part_(part),
      machine_(with_space(settings, space)),
      park_moves_(park_moves_in(machine_, part.box)) {}

bool PrintStart::travel_asked(PrinterLink& link, firmware_link::Instant now) {
  firmware_link::Session& session = link.session();
  const std::string question(session.rules().travel_question);
  if (question.empty()) return true;
  while (questions_ < kQuestions && session.can_take()) {
    session.insert(command_of(question), now);
    ++questions_;
  }
  return questions_ == kQuestions && session.can_take() &&
         session.statistics().lines_in_flight == 0;
}

core::Status PrintStart::take_travel(const firmware_link::Session& session, Reporter& reporter) {
  std::optional<firmware_link::TravelLimits> limits = session.capabilities().travel;
  if (limits) {
    core::Status fits = check_travel(on_machine(part_.box, settings_), part_.height, *limits);
    if (!fits.ok()) return fits;
    limits = from_bed(*limits, settings_);
  }
  if (const std::string note = space_note(space_, limits); !note.empty()) {
    reporter.note("bed", note);
  }
  if (!limits) return {};
  machine_ = with_space(settings_, within(space_, *limits));
  park_moves_ = park_moves_in(machine_, part_.box);
  return {};
}

}  // namespace host
