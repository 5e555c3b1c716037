#include "host/settings/spool_amount.h"

#include <array>
#include <string_view>
#include <utility>

#include "host/output/gcode_summary.h"    // filament_grams
#include "host/settings/settings_text.h"  // read_number
#include "host/system/text.h"             // trimmed

namespace host {
namespace {

struct Unit {
  std::string_view word;
  SpoolAmount one;
};

// "mm" before "m", "kg" before "g": the first that the text ends with counts.
constexpr std::array kUnits = {Unit{"mm", {1, 0}}, Unit{"m", {1'000, 0}}, Unit{"kg", {0, 1'000}},
                               Unit{"g", {0, 1}}};

core::Error bad(std::string message) { return {core::ErrorCode::kBadSetting, std::move(message)}; }

}  // namespace

core::Result<SpoolAmount> spool_amount(const std::string& text) {
  const std::string whole(trimmed(text));
  for (const Unit& unit : kUnits) {
    if (!whole.ends_with(unit.word)) continue;
    const std::string number(
        trimmed(std::string_view(whole).substr(0, whole.size() - unit.word.size())));
    const core::Result<double> read = read_number(number, "");
    if (!read.ok() || read.value() < 0) break;
    return SpoolAmount{read.value() * unit.one.mm, read.value() * unit.one.grams};
  }
  return bad("'" + text +
             "' is no amount of filament; write '12 m', '900 mm', '350 g' or '0.4 kg'");
}

core::Result<double> spool_mm(const SpoolAmount& amount, const core::Settings& settings) {
  if (amount.grams == 0) return amount.mm;
  const double grams_per_mm = filament_grams(1, settings);
  if (grams_per_mm > 0) return amount.grams / grams_per_mm;
  return bad(
      "--spool-left: the filament's weight is not known; set filament_density_g_cm3, or tell a "
      "length, as '12 m'");
}

}  // namespace host
