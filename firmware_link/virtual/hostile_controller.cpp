#include "firmware_link/virtual/hostile_controller.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "firmware_link/check.h"

namespace firmware_link {
namespace {

constexpr std::size_t kGreetingLines = 8;

VirtualControllerOptions adapted(const Scenario& scenario, VirtualControllerOptions options) {
  options.dialect = scenario.dialect;
  options.advanced_ok = scenario.advanced_ok;
  options.meatpack = scenario.meatpack;
  return options;
}

Duration seconds(double value) { return Duration(static_cast<Duration::rep>(value * 1e6)); }

}  // namespace

HostileController::HostileController(const Scenario& scenario, std::uint64_t seed,
                                     const VirtualControllerOptions& options,
                                     std::size_t within_lines, Instant now)
    : scenario_(scenario),
      random_(seed),
      down_(scenario.down, random_.next()),
      up_(scenario.up, random_.next()),
      controller_(adapted(scenario, options), now),
      lines_until_mishap_(kGreetingLines + random_.below(within_lines)) {
  LINK_CHECK(within_lines > 0);
}

std::size_t HostileController::input(std::span<const std::byte> bytes, Instant now) {
  if (!plugged(now)) return 0;
  const std::size_t count = std::min(bytes.size(), down_.room());
  if (mute_) return bytes.size();
  const auto taken = bytes.first(count);
  down_.carry(taken, now);
  pass_down(now);
  const auto lines = static_cast<std::size_t>(
      std::count(taken.begin(), taken.end(), static_cast<std::byte>('\n')));
  if (!happened_ && scenario_.mishap != Mishap::kNone) {
    if (lines >= lines_until_mishap_) {
      happen(now);
    } else {
      lines_until_mishap_ -= lines;
    }
  }
  return count;
}

void HostileController::pass_down(Instant now) {
  const std::string_view arrived = down_.arrived(now);
  if (!arrived.empty()) {
    down_.drop(controller_.input(std::as_bytes(std::span(arrived.data(), arrived.size())), now));
  }
}

void HostileController::happen(Instant now) {
  happened_ = true;
  switch (scenario_.mishap) {
    case Mishap::kNone:
      break;
    case Mishap::kReset:
      controller_.reset(now);
      break;
    case Mishap::kUnplug:
      unplugged_until_ = Instant::max();
      break;
    case Mishap::kReplug:
      unplugged_until_ = now + seconds(1 + 20 * random_.share());
      break;
    case Mishap::kKill:
      controller_.halt("echo:M112 Shutdown\n", now);
      break;
    case Mishap::kRunaway:
      controller_.halt("Error:Thermal Runaway, system stopped! Heater_ID: 0\n", now);
      break;
    case Mishap::kDeadHeaters:
      controller_.break_heaters(now);
      break;
    case Mishap::kMute:
      mute_ = true;
      break;
    case Mishap::kUserPause:
      controller_.say("//action:paused\necho:busy: paused for user\n", now);
      [[fallthrough]];
    case Mishap::kBusy:
      controller_.delay_next(seconds(60 + 240 * random_.share()));
      break;
    case Mishap::kShutdown:
      controller_.halt("Lost communication with MCU 'mcu'\n", now);
      break;
    case Mishap::kAlarm:
      controller_.say("!! Move out of range: 999.000 0.000 0.500 [0.000]\n", now);
      break;
    case Mishap::kHostActions:
      controller_.say("//action:pause\n// action:resume\n", now);
      break;
  }
}

void HostileController::advance(Instant now) {
  pass_down(now);
  controller_.advance(now);
}

std::size_t HostileController::output(std::span<std::byte> into, Instant now) {
  std::array<std::byte, 256> bytes;
  while (up_.room() >= bytes.size()) {
    const std::size_t count = controller_.output(bytes);
    if (count == 0) break;
    up_.carry(std::span(bytes).first(count), now);
  }
  // What it said while nobody was there is gone.
  if (!plugged(now) || mute_) {
    up_.drop(up_.arrived(now).size());
    return 0;
  }
  return up_.take(into, now);
}

std::optional<Instant> HostileController::next_event() const {
  std::optional<Instant> next = controller_.next_event();
  if (!up_.empty() && (!next || up_.held_until() < *next)) next = up_.held_until();
  return next;
}

bool HostileController::owes_answer() const { return controller_.owes_answer() || !up_.empty(); }

}  // namespace firmware_link
