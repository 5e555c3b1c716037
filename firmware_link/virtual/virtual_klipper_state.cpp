#include "firmware_link/virtual/virtual_klipper_state.h"

namespace firmware_link {
namespace {

constexpr std::string_view kStartupMessage =
    "Printer is not ready\n"
    "The klippy host software is attempting to connect.  Please\n"
    "retry in a few moments.";
constexpr std::string_view kShutdownMessage =
    "\nOnce the underlying issue is corrected, use the\n"
    "\"FIRMWARE_RESTART\" command to reset the firmware, reload the\n"
    "config, and restart the host software.\nPrinter is shutdown";
constexpr std::string_view kErrorMessage =
    "\n\nOnce the underlying issue is corrected, use the \"RESTART\"\n"
    "command to reload the config and restart the host software.\nPrinter is halted";

}  // namespace

void VirtualKlipperState::start(std::string_view config_error, Duration ready_after, Instant now) {
  ready_at_.reset();
  idle_ = true;
  words_ = std::string(config_error);
  if (!config_error.empty()) {
    state_ = State::kError;
  } else if (ready_after.count() > 0) {
    state_ = State::kStartup;
    ready_at_ = now + ready_after;
  } else {
    state_ = State::kReady;
  }
}

bool VirtualKlipperState::found(Instant now) {
  if (!ready_at_ || *ready_at_ > now) return false;
  ready_at_.reset();
  state_ = State::kReady;
  return true;
}

bool VirtualKlipperState::shut_down(std::string_view words, bool* was_ready) {
  if (state_ == State::kShutdown) return false;
  const bool asked = words.find("M112") != std::string_view::npos;
  words_ = asked ? "Shutdown due to M112 command" : words.substr(0, words.find('\n'));
  *was_ready = ready();
  state_ = State::kShutdown;
  ready_at_.reset();
  return true;
}

bool VirtualKlipperState::falls_idle(bool busy, Duration idle_timeout, Instant now) {
  if (busy) {
    moved_at_ = now;
    return false;
  }
  if (idle_ || !ready() || now < moved_at_ + idle_timeout) return false;
  idle_ = true;
  return true;
}

std::optional<Instant> VirtualKlipperState::next(bool busy, Duration idle_timeout) const {
  if (ready_at_) return ready_at_;
  if (idle_ || busy) return std::nullopt;
  return moved_at_ + idle_timeout;
}

std::string VirtualKlipperState::message() const {
  switch (state_) {
    case State::kStartup:
      return std::string(kStartupMessage);
    case State::kShutdown:
      return words_ + std::string(kShutdownMessage);
    case State::kError:
      return words_ + std::string(kErrorMessage);
    case State::kReady:
      break;
  }
  return "Printer is ready";
}

}  // namespace firmware_link
