#include "tools/faults/hostile_controller.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <string>

#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

Duration seconds(double value) { return Duration(static_cast<Duration::rep>(value * 1e6)); }

bool comes_first(Mishap mishap) {
  return mishap == Mishap::kNotReady || mishap == Mishap::kDownBefore || mishap == Mishap::kNoise;
}

VirtualControllerOptions adapted(const Scenario& scenario, std::uint64_t seed,
                                 VirtualControllerOptions options) {
  SplitMix random(~seed);
  if (scenario.mishap == Mishap::kNotReady)
    options.klipper.ready_after = seconds(90 * random.share());
  if (scenario.mishap == Mishap::kStopHoming) {
    options.homing_time = seconds(30 + 270 * random.share());
    options.busy_lines = seed % 2 == 0;
  }
  options.dialect = scenario.dialect;
  options.advanced_ok = scenario.advanced_ok;
  options.meatpack = scenario.meatpack;
  return options;
}

// Messages of thermal protection in several firmwares.
constexpr std::string_view kRunaways[] = {"Error:Thermal Runaway, system stopped! Heater_ID: 0\n",
                                          "error:THERMAL RUNAWAY on T0\n",
                                          "Error:Thermal runaway, system stopped! Heater_ID: bed\n",
                                          "Error:MINTEMP triggered, system stopped! Heater_ID: 0\n",
                                          "ERROR: MaxTemp triggered on T. Check sensors!\n",
                                          "fatal:Heater decoupled\n"};

}  // namespace

HostileController::HostileController(const Scenario& scenario, std::uint64_t seed,
                                     const VirtualControllerOptions& options,
                                     std::size_t within_lines, Instant now)
    : scenario_(scenario),
      random_(seed),
      down_(scenario.down, random_.next()),
      up_(scenario.up, random_.next()),
      controller_(adapted(scenario, seed, options), now),
      lines_until_mishap_(scenario.mishap_after + random_.below(within_lines)),
      mute_controller_(scenario.mishap == Mishap::kNoise) {
  LINK_CHECK(within_lines > 0);
  happened_ = comes_first(scenario.mishap);
  if (scenario.mishap == Mishap::kDownBefore) {
    controller_.halt("Lost communication with MCU 'mcu'\n", now);
  }
}

std::size_t HostileController::input(std::span<const std::byte> bytes, Instant now) {
  if (!plugged(now)) return 0;
  const std::size_t count = std::min(bytes.size(), down_.room());
  if (mute_ || mute_controller_) return bytes.size();
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
    case Mishap::kNotReady:
    case Mishap::kDownBefore:
    case Mishap::kHostStands:  // it is the host's
    case Mishap::kStopHoming:  // likewise
      break;
    case Mishap::kRestart:
      controller_.restart(seconds(1 + 20 * random_.share()), now);
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
      controller_.halt(kRunaways[random_.below(std::size(kRunaways))], now);
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
    case Mishap::kLostAnswer:
      controller_.lose_answer(scenario_.word, instead());
      break;
    case Mishap::kJump:
      // A firmware that counts wrong: by more than an `ok` too many could explain.
      controller_.set_last_line(static_cast<std::int64_t>(random_.below(5)), now);
      break;
    case Mishap::kDumbReset:
      reset_unheard(now);
      break;
    case Mishap::kSilentWork:
      controller_.work_in_silence();
      controller_.delay_next(seconds(60 + 1'000 * random_.share()), scenario_.word);
      break;
    case Mishap::kBusyForEver:
      controller_.delay_next(seconds(1e6));
      break;
    case Mishap::kChatter:
    case Mishap::kNoise:
      break;
    case Mishap::kHostActions:
      controller_.say("//action:pause\n// action:resume\n", now);
      break;
  }
}

// Its report of that is lost.
void HostileController::reset_unheard(Instant now) {
  controller_.reset(now);
  std::array<std::byte, 256> banner;
  while (controller_.output(banner) > 0) {
  }
}

// What arrives instead of an `ok`: nothing, or the rest of it.
std::string_view HostileController::instead() {
  constexpr std::string_view kLeft[] = {"", "o\n", "k\n", "\xefk\n", "ok"};
  return kLeft[random_.below(std::size(kLeft))];
}

void HostileController::chatter(Instant now) {
  constexpr std::string_view kNoise = "\xfe\x80\xf8\x07~\xffx\x18\n";
  while (chatter_next_ <= now && up_.room() >= 64) {
    const std::string_view words =
        scenario_.mishap == Mishap::kNoise ? kNoise : "[INFO] motor driver 31 C, 24.1 V\n";
    up_.carry(std::as_bytes(std::span(words)), chatter_next_);
    chatter_next_ += std::chrono::milliseconds(100);
  }
}

void HostileController::advance(Instant now) {
  pass_down(now);
  controller_.advance(now);
}

std::size_t HostileController::output(std::span<std::byte> into, Instant now) {
  std::array<std::byte, 256> bytes;
  while (up_.room() >= 2 * bytes.size()) {
    const std::size_t count = controller_.output(bytes);
    if (count == 0) break;
    if (mute_controller_) continue;
    if (scenario_.line_end == "\n") {
      up_.carry(std::span(bytes).first(count), now);
      continue;
    }
    std::string text;
    for (const std::byte byte : std::span(bytes).first(count)) {
      const char c = static_cast<char>(byte);
      text += c == '\n' ? std::string(scenario_.line_end) : std::string(1, c);
    }
    up_.carry(std::as_bytes(std::span(text)), now);
  }
  const bool chats = scenario_.mishap == Mishap::kChatter || scenario_.mishap == Mishap::kNoise;
  if (chats) chatter(now);
  // Its output while no host was connected is lost.
  if (!plugged(now) || mute_) {
    up_.drop(up_.arrived(now).size());
    return 0;
  }
  return up_.take(into, now);
}

std::optional<Instant> HostileController::next_event() const {
  std::optional<Instant> next = controller_.next_event();
  if (chatter_next_ > Instant{} && (!next || chatter_next_ < *next)) next = chatter_next_;
  if (!up_.empty() && (!next || up_.held_until() < *next)) next = up_.held_until();
  return next;
}

bool HostileController::owes_answer() const { return controller_.owes_answer() || !up_.empty(); }

}  // namespace firmware_link
