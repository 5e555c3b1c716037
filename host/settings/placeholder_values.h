// What the names in a user's G-code stand for: our settings, then the profile's values, then what
// is known of the print and the part.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/geometry.h"                   // Box
#include "core/result.h"                     // Result
#include "core/units.h"                      // Length
#include "host/pipeline/print_settings.h"    // PrintSettings
#include "host/settings/gcode_expression.h"  // Variable
#include "host/settings/prusa_left_out.h"    // ProfileValues

namespace host {

// What G-code may ask of a part that was read to its end.
struct PartFacts {
  std::string name;         // its file's
  core::Length top;         // of its highest layer
  std::int64_t layers = 0;  // 0: neither number nor height is known, as of a pipe
  core::Box box;            // on the bed, from its front left corner; empty: not known
};

// The index-th of a profile's values of that name, "215,210" or "PLA;PETG"; the first if there are
// fewer, as in PrusaSlicer.
[[nodiscard]] std::optional<Variable> profile_value(const ProfileValues& profile,
                                                    std::string_view name, std::size_t index);

class PlaceholderValues {
 public:
  // REQUIRES: all three outlive it. `part` may be null: not opened yet.
  PlaceholderValues(const PrintSettings& settings, const ProfileValues& profile,
                    const PartFacts* part);

  // An error for a name that only a part gives, when there is none, or it is not known of it.
  [[nodiscard]] core::Result<std::optional<Variable>> find(std::string_view name,
                                                           std::size_t index) const;

  // Whether find() was asked for what only a part gives, and there is none.
  [[nodiscard]] bool lacked_part() const { return lacked_part_; }

 private:
  [[nodiscard]] std::optional<Variable> of_print(std::string_view name, std::size_t index) const;
  [[nodiscard]] std::optional<Variable> of_part(std::string_view name, std::size_t index) const;

  const PrintSettings& settings_;
  const ProfileValues& profile_;
  const PartFacts* part_;
  ProfileValues rows_;
  mutable bool lacked_part_ = false;
};

}  // namespace host
