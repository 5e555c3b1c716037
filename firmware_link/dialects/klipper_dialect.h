// Klipper: exactly one `ok` for each line, whatever was in it; numbers and checksums are read over,
// so that a line sent again would run again. Nothing is ever repeated. Long handlers are silent.
// After the first `!!` the print is over, though every line still gets its `ok`.
#pragma once

#include "firmware_link/dialects/dialect.h"  // Dialect

namespace firmware_link {

class KlipperDialect final : public Dialect {
 public:
  [[nodiscard]] std::string_view name() const override { return "Klipper"; }
  [[nodiscard]] LinkRules rules() const override;
  [[nodiscard]] Meaning meaning_of(const Reply& reply) const override;
  void amend(Capabilities& capabilities) const override;
};

}  // namespace firmware_link
