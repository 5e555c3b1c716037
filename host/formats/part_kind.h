// The kinds of bodies of an object, in the spellings of all slicers.
#pragma once

#include <string_view>

namespace host {

enum class PartKind {
  kPlastic,          // normal_part, ModelPart, empty
  kNegative,         // negative_part, NegativeVolume: cut out of the object's plastic
  kModifier,         // modifier_part, ParameterModifier: other settings within it
  kSupportEnforcer,  // support_enforcer, SupportEnforcer: what hangs within it is held
  kSupportBlocker,   // support_blocker, SupportBlocker: nothing within it is held
  kUnknown,
};

[[nodiscard]] PartKind part_kind_of(std::string_view word);

}  // namespace host
