// What the user's start G-code sets for the whole print: the tool, M220, M221, accelerations,
// pressure advance. What later lines of the user's change of these is told again behind them.
//
//     start_gcode    T1   M221 S95                      the user's wish for this print: stays
//     at_height      T0   M221 S120   M220 S50          for these lines alone
//     behind them    T1   M221 S95    M220 S100         as start_gcode says; else as switched on
//
// An acceleration (M204, SET_VELOCITY_LIMIT ACCEL) and pressure advance (M900, M572,
// SET_PRESSURE_ADVANCE) are told again by core::MotionBuilder, where it has told one; otherwise
// as start_gcode says. Where that says nothing the value stays changed: what it was is unknown, and
// so is what a macro does.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/settings.h"  // Settings

namespace host {

class StandingValues {
 public:
  // REQUIRES: check_user_gcode() was fine.
  explicit StandingValues(const core::Settings& settings);

  // The lines to tell behind these. Mostly empty.
  [[nodiscard]] std::vector<std::string> told_again_after(
      const std::vector<std::string>& lines) const;

  // Whether these lines change an acceleration or pressure advance of which nobody knows what it
  // was.
  [[nodiscard]] bool loses_value(const std::vector<std::string>& lines) const;

  // The line of start_gcode that chose the tool. Empty: none did.
  [[nodiscard]] std::string tool() const;
  // In percent.
  [[nodiscard]] int feed() const;
  [[nodiscard]] int flow() const;

 private:
  // One value that lines leave.
  struct Value {
    std::string key;   // of what: "T", "M220", "M221 T1", "M204", "M204 R", "advance" …
    std::string line;  // that tells it; empty: it is some other, unknown one
  };

  [[nodiscard]] static std::vector<Value> values_after(const std::vector<std::string>& lines);
  static void read(std::string_view line, std::vector<Value>& values);
  // The line that tells what stands; empty: core::MotionBuilder tells it; nullopt: unknown.
  [[nodiscard]] std::optional<std::string> standing(const Value& changed) const;

  std::vector<Value> of_start_;
  bool accelerations_are_told_;
  bool advance_is_told_;
};

}  // namespace host
