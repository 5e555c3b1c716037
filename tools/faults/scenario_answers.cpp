#include "tools/faults/scenario_answers.h"

#include <chrono>
#include <cstddef>
#include <string_view>

namespace firmware_link {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;

// A question waits behind a long command. If a line end is lost, its answer is lost, too, and the
// question is repeated.
constexpr Duration kBehindWork = milliseconds(6'000);

struct Lost {
  std::string_view name;
  std::string_view what;
  std::string_view word;
  Duration stood_max;
};

constexpr Lost kLost[] = {
    {"lost-ok-filament", "the ok to a G92 E0 is lost", "G92", milliseconds(2'500)},
    {"lost-ok-place", "the ok to an M114 is lost", "M114", milliseconds(2'500)},
    {"lost-ok-motors", "the ok to an M84 is lost", "M84", kBehindWork},
    {"lost-ok-heat", "the ok to an M109 is lost", "M109", kBehindWork},
    {"lost-ok-homing", "the ok to a G28 is lost", "G28", kBehindWork},
    {"lost-ok-waiting", "the ok to an M400 is lost", "M400", kBehindWork},
    {"lost-ok-last", "the ok to the print's last line is lost", "M107", kBehindWork},
};

constexpr Lost kLostByKlipper[] = {
    {"klipper-lost-ok-filament", "the ok to a G92 E0 is lost", "G92", milliseconds(2'500)},
    {"klipper-lost-ok-place", "the ok to an M114 is lost", "M114", milliseconds(2'500)},
    {"klipper-lost-ok-motors", "the ok to an M84 is lost", "M84", kBehindWork},
    {"klipper-lost-ok-heat", "the ok to an M109 is lost", "M109", kBehindWork},
    {"klipper-lost-ok-homing", "the ok to a G28 is lost", "G28", kBehindWork},
    {"klipper-lost-ok-waiting", "the ok to an M400 is lost", "M400", kBehindWork},
    {"klipper-lost-ok-last", "the ok to the print's last line is lost", "M107", kBehindWork},
};

Scenario of(std::string_view name, std::string_view what, Mishap mishap, FaultKind end) {
  Scenario scenario;
  scenario.name = name;
  scenario.what = what;
  scenario.mishap = mishap;
  scenario.may_finish = end == FaultKind::kNone;
  if (end != FaultKind::kNone) scenario.faults = fault_bit(end);
  return scenario;
}

Scenario klipper_noise(std::string_view name, std::string_view what) {
  Scenario scenario = of(name, what, Mishap::kNone, FaultKind::kPosition);
  scenario.dialect = VirtualDialect::kKlipper;
  scenario.may_finish = true;
  scenario.every_move_extrudes = true;
  scenario.stood_max = milliseconds(6'000);  // several losses may coincide
  return scenario;
}

}  // namespace

void add_answer_scenarios(std::vector<Scenario>& all) {
  const std::size_t first = all.size();
  const auto add_lost = [&all](const Lost& lost, VirtualDialect dialect) {
    Scenario scenario = of(lost.name, lost.what, Mishap::kLostAnswer, FaultKind::kNone);
    scenario.dialect = dialect;
    scenario.word = lost.word;
    scenario.stood_max = lost.stood_max;
    all.push_back(scenario);
  };
  for (const Lost& lost : kLost) add_lost(lost, VirtualDialect::kMarlin);
  for (const Lost& lost : kLostByKlipper) add_lost(lost, VirtualDialect::kKlipper);

  Scenario jump = of("jump", "the count of lines jumps back", Mishap::kJump, FaultKind::kRefusals);
  jump.mishap_after = 26;
  jump.stood_max = milliseconds(8'000);
  all.push_back(jump);
  Scenario reset = of("dumb-reset", "the board resets, and its `start` is damaged",
                      Mishap::kDumbReset, FaultKind::kRefusals);
  reset.mishap_after = 26;
  reset.stood_max = milliseconds(8'000);
  all.push_back(reset);

  Scenario probing =
      of("silent-probing", "a G29 of minutes on firmware that says nothing meanwhile",
         Mishap::kSilentWork, FaultKind::kNone);
  probing.word = "G29";
  all.push_back(probing);
  probing.name = "klipper-silent-probing";
  probing.dialect = VirtualDialect::kKlipper;
  all.push_back(probing);

  all.push_back(of("busy-for-ever", "a command never ends, and says that it is busy",
                   Mishap::kBusyForEver, FaultKind::kSilence));
  all.push_back(
      of("chatter", "a device that logs ten lines a second", Mishap::kChatter, FaultKind::kNone));
  all.push_back(
      of("noise", "a device that says nothing but noise", Mishap::kNoise, FaultKind::kNoAnswer));

  Scenario lost_ok = klipper_noise("klipper-lost-ok", "Klipper's answers get lost");
  lost_ok.up.lose_line = 0.04;
  lost_ok.up.distance = 40;
  all.push_back(lost_ok);
  Scenario lost_bytes = klipper_noise("klipper-lost-bytes", "bytes of Klipper's answers get lost");
  lost_bytes.up.lose_byte = 0.01;
  lost_bytes.up.distance = 40;
  all.push_back(lost_bytes);
  Scenario lost_ends = klipper_noise("klipper-lost-ends", "ends of lines to Klipper get lost");
  lost_ends.down.lose_line_end = 0.01;
  all.push_back(lost_ends);
  for (std::size_t i = first; i < all.size(); ++i) all[i].about_answers = true;
}

}  // namespace firmware_link
