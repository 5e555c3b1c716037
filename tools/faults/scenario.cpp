#include "tools/faults/scenario.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "tools/faults/scenario_answers.h"

namespace firmware_link {
namespace {

constexpr std::uint32_t kNoise = fault_bit(FaultKind::kRefusals) | fault_bit(FaultKind::kSilence) |
                                 fault_bit(FaultKind::kNoAnswer) | fault_bit(FaultKind::kPosition);

Scenario noise(std::string_view name, std::string_view what, const WireDamage& down,
               const WireDamage& up) {
  Scenario scenario;
  scenario.name = name;
  scenario.what = what;
  scenario.down = down;
  scenario.up = up;
  scenario.faults = kNoise;
  // Several losses may coincide.
  scenario.stood_max = std::chrono::seconds(12);
  return scenario;
}

Scenario mishap(std::string_view name, std::string_view what, Mishap what_happens, FaultKind end,
                VirtualDialect dialect = VirtualDialect::kMarlin) {
  Scenario scenario;
  scenario.name = name;
  scenario.what = what;
  scenario.mishap = what_happens;
  scenario.dialect = dialect;
  scenario.may_finish = end == FaultKind::kNone;
  if (end != FaultKind::kNone) scenario.faults = fault_bit(end);
  if (what_happens == Mishap::kHostStands) scenario.stood_max = std::chrono::minutes(10);
  return scenario;
}

WireDamage with(double WireDamage::*what, double probability, std::size_t distance = 100) {
  WireDamage damage;
  damage.*what = probability;
  damage.distance = distance;
  return damage;
}

WireDamage late(double probability, Duration delay_max) {
  WireDamage damage = with(&WireDamage::delay_line, probability);
  damage.delay_max = delay_max;
  return damage;
}

WireDamage everything(std::size_t distance) {
  WireDamage damage;
  damage.lose_byte = damage.flip_byte = damage.double_byte = 1e-3;
  damage.lose_line = damage.double_line = damage.lose_line_end = 0.01;
  damage.distance = distance;
  return damage;
}

struct Packed {
  std::string_view name;
  std::string_view what;
  WireDamage down;
  WireDamage up;
};

std::vector<Scenario> noises() {
  using D = WireDamage;
  const std::size_t near = 40;
  std::vector<Scenario> all = {
      noise("clean", "nothing at all goes wrong", {}, {}),
      noise("flipped-down", "flipped bits in what is sent", with(&D::flip_byte, 3e-3), {}),
      noise("lost-bytes-down", "lost bytes in what is sent", with(&D::lose_byte, 3e-3), {}),
      noise("doubled-bytes-down", "doubled bytes in what is sent", with(&D::double_byte, 3e-3), {}),
      noise("lost-ends-down", "lost ends of line", with(&D::lose_line_end, 0.05), {}),
      noise("lost-lines-down", "lost lines", with(&D::lose_line, 0.05), {}),
      noise("doubled-lines-down", "doubled lines", with(&D::double_line, 0.05), {}),
      noise("flipped-up", "flipped bits in answers", {}, with(&D::flip_byte, 6e-3, near)),
      noise("lost-bytes-up", "lost bytes in answers", {}, with(&D::lose_byte, 6e-3, near)),
      noise("doubled-bytes-up", "doubled bytes in answers", {}, with(&D::double_byte, 6e-3, near)),
      noise("lost-ok", "lost answers", {}, with(&D::lose_line, 0.05, near)),
      noise("doubled-ok", "doubled answers", {}, with(&D::double_line, 0.05, near)),
      noise("late-ok", "answers up to 8 s late", {}, late(0.03, std::chrono::seconds(8))),
      noise("nonsense", "a nonsense Resend and other chatter", {},
            with(&D::insert_line, 0.1, near)),
      noise("flush-tails", "a flush leaves a whole command without its number",
            with(&D::cut_behind_number, 4e-3), {}),
      noise("everything", "all damages both ways", everything(100), everything(60)),
  };
  for (Scenario& scenario : all) {
    if (scenario.up.delay_max.count() > 0) scenario.stood_max = std::chrono::seconds(30);
  }
  Scenario advanced =
      noise("advanced-everything", "the same, with ADVANCED_OK", everything(100), everything(60));
  advanced.advanced_ok = true;
  all.push_back(advanced);
  for (const auto& [name, what, down, up] :
       {Packed{"packed", "packed lines, and nothing goes wrong", {}, {}},
        Packed{"packed-flipped", "flipped bits in packed lines", with(&D::flip_byte, 3e-3), {}},
        Packed{"packed-lost-ok",
               "lost answers to packed lines",
               {},
               with(&D::lose_line, 0.05, near)}}) {
    Scenario packed = noise(name, what, down, up);
    packed.meatpack = true;
    all.push_back(packed);
  }
  Scenario prusa =
      noise("prusa-everything", "the same, to Prusa's firmware", everything(100), everything(60));
  prusa.dialect = VirtualDialect::kPrusa;
  all.push_back(prusa);
  return all;
}

std::vector<Scenario> all_scenarios() {
  std::vector<Scenario> all = noises();
  const auto add = [&all](const Scenario& scenario) { all.push_back(scenario); };
  add(mishap("reset", "the board resets in mid-print", Mishap::kReset, FaultKind::kReset));
  add(mishap("unplug", "the port vanishes", Mishap::kUnplug, FaultKind::kPortLost));
  add(mishap("replug", "the port vanishes and comes back", Mishap::kReplug, FaultKind::kPortLost));
  add(mishap("kill", "somebody presses stop", Mishap::kKill, FaultKind::kHalted));
  add(mishap("runaway", "thermal protection halts it", Mishap::kRunaway, FaultKind::kHalted));
  add(mishap("dead-heaters", "heaters that never rise", Mishap::kDeadHeaters, FaultKind::kHeater));
  add(mishap("mute", "it hears and says nothing more", Mishap::kMute, FaultKind::kSilence));
  all.back().stood_max = std::chrono::seconds(40);
  add(mishap("busy", "a command takes minutes", Mishap::kBusy, FaultKind::kNone));
  add(mishap("user-pause", "it waits for a button", Mishap::kUserPause, FaultKind::kNone));
  add(mishap("host-actions", "the operator asks for a pause", Mishap::kHostActions,
             FaultKind::kNone));
  add(mishap("klipper", "Klipper, and nothing goes wrong", Mishap::kNone, FaultKind::kNone,
             VirtualDialect::kKlipper));
  add(mishap("klipper-silence", "a command takes minutes, and Klipper says nothing", Mishap::kBusy,
             FaultKind::kNone, VirtualDialect::kKlipper));
  add(mishap("host-stands-still", "the host's clock jumps by minutes", Mishap::kHostStands,
             FaultKind::kNone));
  add(mishap("stop-in-homing", "a stop in a homing of minutes", Mishap::kStopHoming,
             FaultKind::kNone));
  for (const auto& [name, end] : {std::pair("ends-crlf", "\r\n"), std::pair("ends-lfcr", "\n\r"),
                                  std::pair("ends-cr", "\r")}) {
    Scenario ends;
    ends.name = name;
    ends.what = "other line ends in answers";
    ends.line_end = end;
    add(ends);
  }
  const auto klipper = [&](std::string_view name, std::string_view what, Mishap what_happens,
                           FaultKind end, std::string_view says = {}) {
    Scenario scenario = mishap(name, what, what_happens, end, VirtualDialect::kKlipper);
    scenario.says = says;
    add(scenario);
  };
  klipper("klipper-starts", "it answers before it is ready", Mishap::kNotReady, FaultKind::kNone);
  klipper("klipper-down-before", "it has shut down before we come", Mishap::kDownBefore,
          FaultKind::kHalted, "Lost communication");
  klipper("klipper-restart", "somebody restarts it", Mishap::kRestart, FaultKind::kReset);
  klipper("klipper-replug", "its port vanishes and comes back", Mishap::kReplug,
          FaultKind::kPortLost);
  klipper("klipper-host-stands-still", "the host's clock jumps by minutes", Mishap::kHostStands,
          FaultKind::kNone);
  klipper("klipper-stop-in-homing", "a stop in a homing of minutes", Mishap::kStopHoming,
          FaultKind::kNone);
  klipper("klipper-kill", "somebody presses stop", Mishap::kKill, FaultKind::kHalted,
          "Shutdown due to M112 command");
  klipper("klipper-shutdown", "it shuts down, and says why later", Mishap::kShutdown,
          FaultKind::kHalted, "Lost communication with MCU 'mcu'");
  add(mishap("klipper-alarm", "a move out of range", Mishap::kAlarm, FaultKind::kAlarm,
             VirtualDialect::kKlipper));
  add(mishap("klipper-unplug", "its pseudo-terminal goes away", Mishap::kUnplug,
             FaultKind::kPortLost, VirtualDialect::kKlipper));
  add(mishap("reprap", "RepRapFirmware, and nothing goes wrong", Mishap::kNone, FaultKind::kNone,
             VirtualDialect::kRepRap));
  Scenario lossy = mishap("reprap-lost-lines", "a line that is lost is never asked for",
                          Mishap::kNone, FaultKind::kSilence, VirtualDialect::kRepRap);
  lossy.down = with(&WireDamage::lose_line, 0.02);
  lossy.may_finish = true;
  lossy.faults |= fault_bit(FaultKind::kNoAnswer);
  lossy.stood_max = std::chrono::seconds(10);  // the questions get lost, too
  add(lossy);
  add(mishap("prusa", "Prusa's firmware, and nothing goes wrong", Mishap::kNone, FaultKind::kNone,
             VirtualDialect::kPrusa));
  add_answer_scenarios(all);
  return all;
}

}  // namespace

std::span<const Scenario> scenarios() {
  static const std::vector<Scenario> all = all_scenarios();
  return all;
}

const Scenario* find_scenario(std::string_view name) {
  const auto all = scenarios();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Scenario& scenario) { return scenario.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace firmware_link
