#include "firmware_link/virtual/virtual_controller.h"

#include "firmware_link/virtual/virtual_firmware.h"

namespace firmware_link {

VirtualController::VirtualController(const VirtualControllerOptions& options, Instant now)
    : firmware_(std::make_unique<Firmware>(options, now)) {}

VirtualController::~VirtualController() = default;

std::size_t VirtualController::input(std::span<const std::byte> bytes, Instant now) {
  return firmware_->input(bytes, now);
}

void VirtualController::advance(Instant now) { firmware_->advance(now); }

std::size_t VirtualController::output(std::span<std::byte> into) { return firmware_->output(into); }

std::optional<Instant> VirtualController::next_event() const { return firmware_->next_event(); }

bool VirtualController::owes_answer() const { return firmware_->owes_answer(); }

bool VirtualController::moving() const { return firmware_->moving(); }

void VirtualController::halt(std::string_view words, Instant now) { firmware_->halt(words, now); }

void VirtualController::say(std::string_view words, Instant now) { firmware_->say(words, now); }

void VirtualController::delay_next(Duration delay, std::string_view word) {
  firmware_->delay_next(delay, word);
}

void VirtualController::lose_answer(std::string_view word, std::string_view instead) {
  firmware_->lose_answer(word, instead);
}

void VirtualController::set_last_line(std::int64_t number, Instant now) {
  firmware_->set_last_line(number, now);
}

void VirtualController::work_in_silence() { firmware_->work_in_silence(); }

void VirtualController::break_heaters(Instant now) { firmware_->break_heaters(now); }

void VirtualController::restart(Duration ready_after, Instant now) {
  firmware_->restart(ready_after, now);
}

void VirtualController::reset(Instant now) { firmware_->reset(now); }

VirtualControllerState VirtualController::state() const { return firmware_->state(); }

const VirtualControllerTotals& VirtualController::totals() const { return firmware_->totals(); }

}  // namespace firmware_link
