#include "firmware_link/session/controller_identity.h"

#include <algorithm>
#include <utility>

#include "firmware_link/dialects/dialects.h"  // dialect_for, is_known_firmware
#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

constexpr int kDoubtsMax = 3;

void check_rules(const LinkRules& rules) {
  LINK_CHECK(rules.window_lines >= 1 && rules.window_lines <= kWindowLinesMax);
  LINK_CHECK(rules.window_bytes > kLineBytesMax && rules.window_bytes <= kWindowBytesMax);
  LINK_CHECK(!rules.numbered || !rules.checksummed);
}

}  // namespace

ControllerIdentity::ControllerIdentity(std::unique_ptr<Dialect> dialect)
    : dialect_(std::move(dialect)), rules_(dialect_->rules()) {
  LINK_CHECK(rules_.numbered);
  check_rules(rules_);
}

void ControllerIdentity::heard(const Reply& reply) {
  // Klipper says its name in the `ok` itself. Nobody else does, so a damaged name there is
  // Klipper's, too.
  constexpr std::string_view kName = "FIRMWARE_NAME:";
  if (reply.kind == Reply::Kind::kFirmwareName) named(reply.text);
  if (reply.kind == Reply::Kind::kOk && reply.text.substr(0, kName.size()) == kName) {
    const std::string_view name = reply.text.substr(kName.size());
    named(is_known_firmware(firmware_name_in(name)) ? name : "Klipper");
  }
  if (reply.kind == Reply::Kind::kCapability) note_capability(reply.text, capabilities_);
  if (reply.kind == Reply::Kind::kEcho || reply.kind == Reply::Kind::kUnknown) {
    note_travel(reply.text, capabilities_);
  }
  if (reply.kind == Reply::Kind::kOk && reply.planner_free) {
    capabilities_.advanced_ok = true;
    capabilities_.planner_blocks = std::max(capabilities_.planner_blocks, *reply.planner_free);
  }
}

void ControllerIdentity::named(std::string_view text) {
  name_ = firmware_name_in(text);
  machine_type_ = machine_type_in(text);
  name_told_ = true;
}

bool ControllerIdentity::doubts_name() {
  if (is_known_firmware(name_) || name_ == name_before_ || ++doubts_ >= kDoubtsMax) return false;
  name_before_ = name_;
  name_told_ = false;
  return true;
}

bool ControllerIdentity::adopt_dialect() {
  const bool numbered = rules_.numbered;
  dialect_ = dialect_for(name_);
  dialect_->amend(capabilities_);
  rules_ = dialect_->rules();
  check_rules(rules_);
  return numbered && !rules_.numbered;
}

}  // namespace firmware_link
