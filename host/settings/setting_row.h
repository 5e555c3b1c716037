// A row of the table of settings (settings_rows.h): a setting's name, field, range and help.
//
// Help texts are noun phrases: first the setting's meaning, then special values.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/geometry.h"                 // Point
#include "core/limits.h"                   // kCoordinateMax
#include "core/units.h"                    // Length, kUnitsPerMm
#include "host/pipeline/print_settings.h"  // PrintSettings

namespace host {

using SettingLines = std::vector<std::string>;

// An enumeration's field, and the names of its values in the order of the enumeration.
struct Choice {
  std::size_t (*get)(const PrintSettings& settings);
  void (*set)(PrintSettings& settings, std::size_t value);
  std::array<std::string_view, 8> names;  // "" after the last
};

template <auto kMember, typename... Names>
constexpr Choice choice(Names... names) {
  using Enumeration = std::remove_cvref_t<decltype(std::declval<PrintSettings&>().*kMember)>;
  return {[](const PrintSettings& settings) -> std::size_t {
            return static_cast<std::size_t>(settings.*kMember);
          },
          [](PrintSettings& settings, std::size_t value) {
            settings.*kMember = static_cast<Enumeration>(value);
          },
          {names...}};
}

// A number for each step of what the layer below holds; one number is written for four equal ones.
using OverhangSteps = std::array<double, core::kOverhangSteps>;

// The bed's outline: corners in the printer's coordinates.
using BedCorners = std::vector<core::Point>;

// The setting's field. Its type decides how values are written.
using SettingMember =
    std::variant<core::Length PrintSettings::*, double PrintSettings::*, int PrintSettings::*,
                 bool PrintSettings::*, std::string PrintSettings::*, SettingLines PrintSettings::*,
                 OverhangSteps PrintSettings::*, BedCorners PrintSettings::*, Choice>;

// A word for a number with a special meaning.
struct NumberWord {
  std::string_view word;
  double number = 0;
};
using NumberWords = std::array<NumberWord, 2>;  // "" after the last

inline constexpr NumberWords kAutoIsZero = {NumberWord{"auto", 0}};
inline constexpr NumberWords kAutoIsNegative = {NumberWord{"auto", -1}};
inline constexpr NumberWords kOffIsZero = {NumberWord{"off", 0}};
inline constexpr NumberWords kAutoOrOff = {NumberWord{"auto", 0}, NumberWord{"off", 0.001}};

struct Setting {
  std::string_view key;
  SettingMember member;
  std::string_view unit;  // "%": a fraction, which may also be given in percent
  double min = 0;         // the range includes both ends; a word's number may lie outside
  double max = 0;
  std::string_view help;
  NumberWords words{};

  [[nodiscard]] std::optional<double> number_of(std::string_view word) const;
  [[nodiscard]] std::optional<std::string_view> word_for(double number) const;
};

// Largest bed: coordinates of the part must fit.
inline constexpr double kBedMaxMm = core::kCoordinateMax / core::kUnitsPerMm / 2;

}  // namespace host
