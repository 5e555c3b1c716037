// Marlin and all that follow it: numbered lines, Resend, `echo:busy:` every 2 s.
#pragma once

#include "firmware_link/dialects/dialect.h"  // Dialect

namespace firmware_link {

class MarlinDialect : public Dialect {
 public:
  [[nodiscard]] std::string_view name() const override { return "Marlin"; }
  [[nodiscard]] LinkRules rules() const override;
  [[nodiscard]] Meaning meaning_of(const Reply& reply) const override;
};

}  // namespace firmware_link
