#include "firmware_link/session/controller_identity.h"

#include <doctest/doctest.h>

#include <memory>
#include <string>

#include "firmware_link/dialects/marlin_dialect.h"

using namespace firmware_link;

namespace {

ControllerIdentity unknown() { return ControllerIdentity(std::make_unique<MarlinDialect>()); }

void say(ControllerIdentity& identity, const std::string& line) {
  identity.heard(read_reply(line));
}

}  // namespace

TEST_CASE("a known name is believed at once, and its dialect spoken") {
  ControllerIdentity identity = unknown();
  CHECK_FALSE(identity.name_told());
  say(identity, "FIRMWARE_NAME:Marlin 2.1 (x) SOURCE_CODE_URL:y");
  CHECK(identity.name_told());
  CHECK(identity.name() == "Marlin 2.1 (x)");
  CHECK_FALSE(identity.doubts_name());
  CHECK_FALSE(identity.adopt_dialect());
  CHECK(identity.rules().numbered);
}

TEST_CASE("a name that is not known is believed when it comes twice, or after three questions") {
  ControllerIdentity identity = unknown();
  say(identity, "FIRMWARE_NAME:Marxin 2");
  CHECK(identity.doubts_name());
  CHECK_FALSE(identity.name_told());
  SUBCASE("twice the same") { say(identity, "FIRMWARE_NAME:Marxin 2"); }
  SUBCASE("each time another") {
    say(identity, "FIRMWARE_NAME:Mxrlin 2");
    CHECK(identity.doubts_name());
    say(identity, "FIRMWARE_NAME:Marlix 2");
  }
  CHECK_FALSE(identity.doubts_name());
}

TEST_CASE("Klipper's name stands in the ok, and late answers have to come first") {
  ControllerIdentity identity = unknown();
  SUBCASE("whole") { say(identity, "ok FIRMWARE_NAME:Klipper FIRMWARE_VERSION:?"); }
  SUBCASE("damaged") { say(identity, "ok FIRMWARE_NAME:Kl"); }
  CHECK(identity.name() == "Klipper");
  CHECK(identity.adopt_dialect());
  CHECK(identity.dialect().name() == "Klipper");
  CHECK_FALSE(identity.rules().numbered);
  CHECK(identity.capabilities().emergency_parser);
}

TEST_CASE("capabilities are told, and learned from answers") {
  ControllerIdentity identity = unknown();
  say(identity, "Cap:MEATPACK:1");
  CHECK(identity.capabilities().meatpack);
  CHECK_FALSE(identity.capabilities().advanced_ok);
  say(identity, "ok N3 P15 B3");
  say(identity, "ok N4 P9 B3");
  CHECK(identity.capabilities().advanced_ok);
  CHECK(identity.capabilities().planner_blocks == 15);
}
