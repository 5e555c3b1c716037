// RepRapFirmware 3: one `ok` for each command. A line with a number must have the right checksum,
// otherwise it is dropped without a word: no `Resend:`, no `ok` (its StringParser::LineFinished).
// So lines carry both, which keeps a damaged one from running. One line is in flight at a time:
// when its `ok` does not come, nobody can know whether it ran, and the print ends for that reason.
#pragma once

#include "firmware_link/dialects/dialect.h"  // Dialect

namespace firmware_link {

class RepRapDialect final : public Dialect {
 public:
  [[nodiscard]] std::string_view name() const override { return "RepRapFirmware"; }
  [[nodiscard]] LinkRules rules() const override;
  [[nodiscard]] Meaning meaning_of(const Reply& reply) const override;
  void amend(Capabilities& capabilities) const override;
};

}  // namespace firmware_link
