// What the controller is: its name, the dialect that goes with the name, what it can do.
#pragma once

#include <memory>
#include <string>

#include "firmware_link/dialects/dialect.h"   // Dialect
#include "firmware_link/wire/capabilities.h"  // Capabilities
#include "firmware_link/wire/reply.h"         // Reply

namespace firmware_link {

class ControllerIdentity {
 public:
  // `dialect` is taken to be its own until adopt_dialect(). REQUIRES: it numbers lines.
  explicit ControllerIdentity(std::unique_ptr<Dialect> dialect);

  [[nodiscard]] const Dialect& dialect() const { return *dialect_; }
  [[nodiscard]] const LinkRules& rules() const { return rules_; }
  [[nodiscard]] const Capabilities& capabilities() const { return capabilities_; }
  [[nodiscard]] Capabilities& capabilities() { return capabilities_; }
  // FIRMWARE_NAME of M115; empty before it was told.
  [[nodiscard]] const std::string& name() const { return name_; }

  // MACHINE_TYPE of M115; empty: it told none.
  [[nodiscard]] const std::string& machine_type() const { return machine_type_; }

  // Learns from any line that comes.
  void heard(const Reply& reply);

  // Whether M115 has been answered, up to its `ok`.
  [[nodiscard]] bool name_told() const { return name_told_; }
  // M115 will be asked again, or was refused.
  void ask_again() { name_told_ = false; }
  void name_refused() { name_told_ = true; }

  // Whether to ask for the name once more, because a name that is not known may be a damaged one.
  // It is believed when it comes twice, or after three questions.
  [[nodiscard]] bool doubts_name();

  // Speaks the dialect that goes with the name. True when that numbers nothing where the one before
  // did: then an `ok` to a question that was asked twice can't be told from one to a command, and
  // all answers must come first.
  [[nodiscard]] bool adopt_dialect();

 private:
  void named(std::string_view text);

  std::unique_ptr<Dialect> dialect_;
  LinkRules rules_;
  Capabilities capabilities_;
  std::string name_;
  std::string machine_type_;
  std::string name_before_;  // the answer before to the same question
  int doubts_ = 0;
  bool name_told_ = false;
};

}  // namespace firmware_link
