// Prusa's firmware for its 8-bit printers (MK2, MK3), an older Marlin. It has arcs without saying
// so (`Cap:ARCS`). It refuses a repeated number with `Resend:` where today's Marlin keeps silent;
// the session copes with both.
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
