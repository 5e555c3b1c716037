#include "host/printing/print_start.h"

#include <fmt/format.h>

#include <optional>
#include <variant>

#include "host/printing/safe_moves.h"  // park_move

namespace host {
namespace {

// Twice, because an answer may be damaged.
constexpr int kQuestions = 2;

// A print's end goes there (safe_moves.h).
core::Status check_parking(const core::Settings& settings,
                           const firmware_link::TravelLimits& limits) {
  const auto park = std::get<firmware_link::Move>(park_move(settings));
  if (within_travel(park, limits)) return {};
  return core::Error{
      core::ErrorCode::kOutOfBounds,
      fmt::format("the nozzle would be parked at X {:g} Y {:g} mm, but the controller's axes go "
                  "from X {:g} to {:g} and from Y {:g} to {:g} mm; set park_x and park_y",
                  static_cast<double>(*park.x_um) / 1'000, static_cast<double>(*park.y_um) / 1'000,
                  limits.min_mm[0], limits.max_mm[0], limits.min_mm[1], limits.max_mm[1])};
}

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
    if (core::Status parks = check_parking(settings_, *limits); !parks.ok()) return parks;
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
