#include "firmware_link/dialects/prusa_dialect.h"

namespace firmware_link {

LinkRules PrusaDialect::rules() const {
  LinkRules rules = MarlinDialect::rules();
  rules.travel_question = {};  // its M211 means something else
  return rules;
}

Meaning PrusaDialect::meaning_of(const Reply& reply) const {
  // "Unknown M code: M999", "Unknown G code: G99"
  if (reply.kind == Reply::Kind::kEcho && reply.text.substr(0, 8) == "Unknown ") {
    return Meaning::kWarning;
  }
  return MarlinDialect::meaning_of(reply);
}

void PrusaDialect::amend(Capabilities& capabilities) const { capabilities.arcs = true; }

}  // namespace firmware_link
