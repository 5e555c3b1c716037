#include "host/printing/printer_link.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "firmware_link/dialects/marlin_dialect.h"
#include "firmware_link/wire/meat_pack.h"  // kMeatPackReset
#include "firmware_link/wire/reply.h"      // LineSplitter, read_reply
#include "host/printing/port_clock.h"
#include "host/system/limits.h"
#include "host/system/stage_clock.h"  // steady_seconds

namespace host {
namespace {

using firmware_link::Command;
using firmware_link::Instant;
using firmware_link::PortState;

firmware_link::Duration duration_of(double seconds) {
  return firmware_link::Duration(std::llround(seconds * 1e6));
}

// Stands for a port that is gone, so that its owner may close it.
class GonePort final : public firmware_link::BytePort {
 public:
  [[nodiscard]] std::size_t write(std::span<const std::byte>) override { return 0; }
  [[nodiscard]] std::size_t read(std::span<std::byte>, int) override { return 0; }
  [[nodiscard]] PortState state() const override { return PortState::kLost; }
};

}  // namespace

PrinterLink::PrinterLink(const PrintSettings& settings, const Options& options,
                         firmware_link::BytePort& port)
    : port_(&port) {
  options_.pack = settings.meatpack == PackUse::kAuto;
  options_.wait_limit = duration_of(settings.wait_limit_s);
  options_.banner_wait = duration_of(options.banner_wait_s);
  options_.count_filament = options.count_filament;
}

void PrinterLink::start_session(bool ask_found_line) {
  options_.ask_found_line = ask_found_line;
  session_ = std::make_unique<firmware_link::Session>(
      std::make_unique<firmware_link::MarlinDialect>(), options_, link_now());
}

void PrinterLink::take(const Command& command, Instant now) {
  session_->take(command, now);
  given_ = true;
}

void PrinterLink::insert(const Command& command, Instant now) {
  session_->insert(command, now);
  given_ = true;
}

void PrinterLink::step(Instant now) { firmware_link::step(*session_, *port_, now, kLinkWait_ms); }

bool PrinterLink::port_open() const { return port_->state() == PortState::kOpen; }

bool PrinterLink::reopen_port(PrintControl& control) {
  static GonePort gone;
  // A port that is held open could not come back under its name.
  port_ = &gone;
  reopened_.reset();
  reopened_ = control.reopen_port();
  if (!reopened_) return false;
  port_ = reopened_.get();
  return true;
}

bool PrinterLink::flush(double limit_s) {
  const double until_s = steady_seconds() + limit_s;
  while (!session_->output().empty() && port_open() && steady_seconds() < until_s) {
    const Instant now = link_now();
    session_->written(port_->write(session_->output()), now);
    hear();
  }
  return session_->output().empty();
}

void PrinterLink::hear() {
  std::array<std::byte, 256> answer;
  const std::size_t count = port_->read(answer, kLinkWait_ms);
  session_->input(std::span(answer).first(count), link_now());
}

firmware_link::Halt PrinterLink::halt(double limit_s) {
  const int attempts = static_cast<int>(limit_s * 1'000) / kLinkWait_ms;
  return firmware_link::halt(*session_, *port_, kLinkWait_ms, attempts);
}

bool PrinterLink::moves_ended(double limit_s, PrintControl& control) {
  // M114's answer is waited for, and not an `ok`, of which there may be one too many.
  std::string words = session_->may_unpack() ? std::string(firmware_link::kMeatPackReset) : "";
  words += "M400\nM114\n";
  const int urgency = control.stop_urgency();
  const double until_s = steady_seconds() + limit_s;
  std::span<const std::byte> to_write = std::as_bytes(std::span(words));
  firmware_link::LineSplitter lines;
  while (steady_seconds() < until_s && control.stop_urgency() <= urgency && port_open()) {
    if (!to_write.empty()) to_write = to_write.subspan(port_->write(to_write));
    std::array<std::byte, 256> bytes{};
    std::span<const std::byte> answer = std::span(bytes).first(port_->read(bytes, kLinkWait_ms));
    while (!answer.empty()) {
      answer = answer.subspan(lines.take(answer));
      const std::optional<std::string_view> line = lines.line();
      if (!line) continue;
      const firmware_link::Reply::Kind kind = firmware_link::read_reply(*line).kind;
      if (kind == firmware_link::Reply::Kind::kPosition) return true;
      if (kind == firmware_link::Reply::Kind::kStart) return false;
      if (kind == firmware_link::Reply::Kind::kHalted) return false;
    }
  }
  return false;
}

}  // namespace host
