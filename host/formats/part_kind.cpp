#include "host/formats/part_kind.h"

#include <string>

namespace host {
namespace {

// Lower-case letters only: "negative_part" and "NegativeVolume" become comparable.
std::string letters_of(std::string_view word) {
  std::string letters;
  for (const char c : word) {
    if (c >= 'A' && c <= 'Z') letters += static_cast<char>(c - 'A' + 'a');
    if (c >= 'a' && c <= 'z') letters += c;
  }
  return letters;
}

}  // namespace

PartKind part_kind_of(std::string_view word) {
  const std::string letters = letters_of(word);
  if (letters.empty() || letters == "normalpart" || letters == "modelpart")
    return PartKind::kPlastic;
  if (letters == "negativepart" || letters == "negativevolume") return PartKind::kNegative;
  if (letters == "modifierpart" || letters == "parametermodifier" || letters == "modifier") {
    return PartKind::kModifier;
  }
  if (letters.starts_with("support") && letters.ends_with("blocker")) {
    return PartKind::kSupportBlocker;
  }
  const bool enforces = letters.starts_with("support") && letters.ends_with("enforcer");
  return enforces ? PartKind::kSupportEnforcer : PartKind::kUnknown;
}

}  // namespace host
