// Expressions in a profile's G-code, as PrusaSlicer has them:
//
//     first_layer_temperature[0] - 25            layer_z < max_print_height and not has_wipe_tower
//     min(max_layer_z + 2, max_print_height)     (filament_type[0] == "FLEX") ? 1 : 0
//     printer_notes =~ /.*MINI.*/                round(bed_temperature[0] * 0.8)
//
// Whole numbers stay whole: 7 / 2 is 3. Numbers are written with six digits, as there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/result.h"  // Result

namespace host {

using ExpressionValue = std::variant<bool, std::int64_t, double, std::string>;

enum class VariableKind { kText, kWhole, kNumber };

// What a name stands for.
struct Variable {
  std::string text;
  VariableKind kind = VariableKind::kText;
};

// What the index-th value of a name is. Nullopt: the name is not known, or is no list of that
// length. An error: it is known to be missing, and why.
using VariableLookup =
    std::function<core::Result<std::optional<Variable>>(std::string_view name, std::size_t index)>;

// Parentheses and conditions within one another.
inline constexpr int kExpressionDepthMax = 64;

// A text that expressions make, and the G-code that they stand in.
inline constexpr std::size_t kExpandedBytesMax = 1 << 20;

// A text, and how far it was read.
struct Cursor {
  std::string_view text;
  std::size_t at = 0;

  void skip_space();
  [[nodiscard]] bool done() const { return at >= text.size(); }
  // The character there; '\0' at the end.
  [[nodiscard]] char peek() const { return done() ? '\0' : text[at]; }
  // Whether the word, or the sign, stands here; then it is read, and the space before it.
  [[nodiscard]] bool take(std::string_view sign);
  [[nodiscard]] bool take_word(std::string_view word);
};

// Reads the longest expression at the cursor. With `live` false it is only read: names need not be
// known, and the value is of no meaning. Errors say what is wrong at the cursor's place.
[[nodiscard]] core::Result<ExpressionValue> read_expression(Cursor& cursor,
                                                            const VariableLookup& lookup,
                                                            bool live);

[[nodiscard]] std::string text_of(const ExpressionValue& value);

// Whether a condition with this value holds: what is neither 0, false nor an empty text.
[[nodiscard]] bool holds(const ExpressionValue& value);

}  // namespace host
