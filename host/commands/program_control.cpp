#include "host/commands/program_control.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <variant>

#include "firmware_link/ports/ports.h"
#include "host/settings/settings_text.h"  // read_number
#include "host/system/stop_signals.h"
#include "host/system/text.h"  // trimmed

namespace host {
namespace {

using firmware_link::BytePort;

std::unique_ptr<BytePort> opened(const std::string& path, int baud) {
  firmware_link::OpenedPort attempt = firmware_link::open_port(path, baud);
  auto* port = std::get_if<std::unique_ptr<BytePort>>(&attempt);
  return port != nullptr ? std::move(*port) : nullptr;
}

}  // namespace

int ProgramControl::stop_urgency() { return host::stop_urgency(); }

void ProgramControl::hear() {
  while (pipe_ && !request_ && !cancelled_) {
    const std::optional<TypedRequest> typed = pipe_->next();
    if (!typed) return;
    request_ = typed->request;
    if (!typed->request) cancelled_ = typed->object;
  }
}

std::optional<UserRequest> ProgramControl::next_request() {
  if (const std::optional<UserRequest> key = parts_.controls.next()) return key;
  hear();
  return std::exchange(request_, {});
}

std::optional<int> ProgramControl::next_cancelled() {
  if (const std::optional<int> typed = parts_.controls.next_cancelled()) return typed;
  hear();
  return std::exchange(cancelled_, {});
}

core::Status ProgramControl::may_start() {
  core::Status may = parts_.keeper.reserve(parts_.reporter);
  const std::string journal = parts_.keeper.held_path();
  if (may.ok() && !journal.empty() && !pipe_) pipe_ = RequestPipe::create(journal);
  return may;
}

Journal* ProgramControl::journal() { return parts_.keeper.journal(); }

// The same USB device under whatever name it has now, or else the same name.
std::unique_ptr<BytePort> ProgramControl::reopen_port() {
  parts_.port.reset();
  const Options& options = parts_.options;
  if (usb_.empty()) return opened(options.link.port, options.link.baud);
  for (const firmware_link::PortDescription& port : firmware_link::list_ports()) {
    if (port.usb == usb_) return opened(port.path, options.link.baud);
  }
  return nullptr;
}

std::optional<std::int64_t> ProgramControl::nozzle_height(std::int64_t z_um, bool in_doubt) {
  if (!parts_.options.print.yes) return ask_nozzle_height(parts_.controls, z_um);
  return in_doubt ? std::nullopt : std::optional(z_um);
}

std::optional<std::int64_t> ask_nozzle_height(Controls& controls, std::int64_t z_um) {
  const std::string question = fmt::format(
      "The controller may have forgotten where the nozzle is. The nozzle will be heated and "
      "lifted, then X and Y will be homed; Z will not be homed, because the part is in the way.\n"
      "Make sure that the nozzle is not below the part's top, and that its way up and to the end "
      "stops is free.\nHow high above the bed is it now, in mm? Enter for {:.3f}, where it was "
      "left; n for no, stop:",
      static_cast<double>(z_um) / 1'000);
  while (true) {
    const std::optional<std::string> answer =
        controls.ask(question, [] { return stop_signal_count() > 0; });
    if (!answer) return std::nullopt;
    const std::string_view text = trimmed(*answer);
    if (text.empty()) return z_um;
    if (text == "n" || text == "no") return std::nullopt;
    const core::Result<double> height = read_number(text, "mm");
    if (height.ok() && height.value() >= 0 && height.value() < 1e7) {
      return std::llround(height.value() * 1'000);
    }
  }
}

}  // namespace host
