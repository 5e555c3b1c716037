// What slicers call the bodies of an object, in any of their spellings.
#pragma once

#include <string_view>

namespace host {

enum class PartKind {
  kPlastic,      // normal_part, ModelPart; nothing
  kNegative,     // negative_part, NegativeVolume: cut out of the object's plastic
  kModifier,     // modifier_part, ParameterModifier: other settings within it
  kSupportMark,  // support_blocker, SupportEnforcer …
  kUnknown,
};

[[nodiscard]] PartKind part_kind_of(std::string_view word);

}  // namespace host
