// What the user wants done at heights of the part: a pause, lines of G-code, another value of a
// setting (height_settings()).
//
//     12.4 pause                   4th layer of 0.2 mm ▔▔▔▔▔▔▔▔
//     12.4 M600                    3rd                 ▔▔▔▔▔▔▔▔  what is due at 0.5: before
//     30 nozzle_celsius 220        2nd                 ▔▔▔▔▔▔▔▔  the 4th, which starts at 0.6
//     30 gcode M117 half           1st                 ▔▔▔▔▔▔▔▔
//
// An action is due before the first layer with roads that starts at its height or above it: the
// part is at least as high then. A value holds from there to the next one of the same setting.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"    // Result
#include "core/settings.h"  // Settings
#include "core/units.h"     // Length

namespace core {

// A setting that may have another value from a height on. It changes no geometry.
struct HeightSetting {
  std::string_view key;  // its name in Settings
  double Settings::*member;
  int decimals;  // as many as are sent, or laid
  double largest;
  bool may_be_zero;
};

[[nodiscard]] std::span<const HeightSetting> height_settings();

struct HeightAction {
  enum class Kind { kPause, kGcode, kValue };

  Length height;  // > 0
  Kind kind = Kind::kPause;
  std::string line;                        // of G-code
  const HeightSetting* setting = nullptr;  // of height_settings(); kValue
  double value = 0;
};

// Reads one line of Settings::at_height. The error does not name the setting.
[[nodiscard]] Result<HeightAction> read_height_action(std::string_view text);

// All of them by height; those of one height in their order. REQUIRES: each line can be read.
[[nodiscard]] std::vector<HeightAction> height_actions(const Settings& settings);

class HeightActions {
 public:
  // REQUIRES: likewise.
  explicit HeightActions(const Settings& settings) : actions_(height_actions(settings)) {}

  // What is due before a layer that starts at `bottom`, but for the first `done` of all.
  // REQUIRES: there are as many.
  [[nodiscard]] std::span<const HeightAction> due(std::size_t done, Length bottom) const;

  // The settings once the first `done` actions were carried out. REQUIRES: there are as many.
  void apply(std::size_t done, Settings& settings) const;

  // Nothing: there are no more than `done`.
  [[nodiscard]] std::optional<Length> height_of(std::size_t done) const {
    return done < actions_.size() ? std::optional(actions_[done].height) : std::nullopt;
  }

 private:
  std::vector<HeightAction> actions_;
};

}  // namespace core
