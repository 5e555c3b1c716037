// Klipper: exactly one `ok` for each line, whatever was in it; numbers and checksums are read over,
// so that a line sent again would run again. Nothing is ever repeated. Long handlers are silent.
// After the first `!!` the print is over, though every line still gets its `ok`.
//
// It is a program on a computer: it answers before its microcontrollers are found, and after they
// were lost. STATUS tells:
//
//     startup ──> ready ──> shutdown      "Klipper state: Ready", "Klipper state: Shutdown"
//        ▲  └──> error        │           an error of its configuration
//        └── RESTART, FIRMWARE_RESTART    "Klipper state: Disconnect": all is forgotten
//
// A shutdown's reason is not in its first line: it is the `!!` to whatever is asked then.
#pragma once

#include "firmware_link/dialects/dialect.h"  // Dialect

namespace firmware_link {

class KlipperDialect final : public Dialect {
 public:
  [[nodiscard]] std::string_view name() const override { return "Klipper"; }
  [[nodiscard]] LinkRules rules() const override;
  [[nodiscard]] Meaning meaning_of(const Reply& reply) const override;
  [[nodiscard]] std::string_view state_question() const override { return "STATUS"; }
  [[nodiscard]] bool becomes_ready(std::string_view reason) const override;
  [[nodiscard]] bool lost_its_position(std::string_view alarm) const override;
  [[nodiscard]] std::string_view remedy() const override;
  [[nodiscard]] std::string_view no_height_command(const Capabilities& capabilities) const override;
  [[nodiscard]] std::string_view commands_question() const override { return "HELP"; }
  void note_command(std::string_view line, Capabilities& capabilities) const override;
  void amend(Capabilities& capabilities) const override;
};

}  // namespace firmware_link
