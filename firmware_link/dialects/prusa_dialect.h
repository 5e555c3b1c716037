// Prusa's firmware for its 8-bit printers (MK2, MK3): the Marlin of its time. It differs in what it
// says of itself: arcs are there without a `Cap:ARCS`, and a repeated number is refused with
// `Resend:` where today's Marlin keeps silent, which the session takes either way.
#pragma once

#include "firmware_link/dialects/marlin_dialect.h"  // MarlinDialect

namespace firmware_link {

class PrusaDialect final : public MarlinDialect {
 public:
  [[nodiscard]] std::string_view name() const override { return "Prusa"; }
  [[nodiscard]] LinkRules rules() const override;
  [[nodiscard]] Meaning meaning_of(const Reply& reply) const override;
  void amend(Capabilities& capabilities) const override;
};

}  // namespace firmware_link
