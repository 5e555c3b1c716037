// Marlin, Prusa's and all that follow them: numbered lines, Resend, `echo:busy:` every 2 s.
#pragma once

#include "firmware_link/dialect.h"  // Dialect

namespace firmware_link {

class MarlinDialect final : public Dialect {
 public:
  [[nodiscard]] std::string_view name() const override { return "Marlin"; }
  [[nodiscard]] LinkRules rules() const override;
  [[nodiscard]] Meaning meaning_of(const Reply& reply) const override;
};

}  // namespace firmware_link
