#include "firmware_link/session/complaints.h"

#include <doctest/doctest.h>

using namespace firmware_link;
using Fate = Complaints::Fate;

namespace {

SendWindow window_with(const char* text) {
  SendWindow window;
  window.push(text, true);
  window.sent(20);
  return window;
}

}  // namespace

TEST_CASE("an unknown command is told when it was sent, and counted when it was not") {
  const SendWindow window = window_with("M556S1");
  Complaints complaints;
  const auto heard = [&](const char* line, bool numbered) {
    return complaints.heard(read_reply(line), window, numbered);
  };
  CHECK(heard("echo:Unknown command: \"M556 S1\"", true) == Fate::kTell);
  CHECK(heard("echo:Unknown command: \"54 E0.27\"", true) == Fate::kCount);
  CHECK(heard("echo:Unknown command: \"\"", true) == Fate::kCount);
  CHECK(heard("echo:Unknown command: \"54 E0.27\"", false) == Fate::kTell);
}

TEST_CASE("an error waits for what follows it") {
  const SendWindow window = window_with("G1X1");
  Complaints complaints;
  CHECK(complaints.heard(read_reply("Error:checksum mism"), window, true) == Fate::kHold);
  CHECK(complaints.mended());
  CHECK_FALSE(complaints.mended());
  CHECK_FALSE(complaints.stands().has_value());
  CHECK(complaints.heard(read_reply("Error:volume.init failed"), window, true) == Fate::kHold);
  CHECK(complaints.stands() == "volume.init failed");
  CHECK_FALSE(complaints.stands().has_value());
}

TEST_CASE("the last refusal is kept") {
  Complaints complaints;
  CHECK(complaints.last_refusal().empty());
  complaints.refused("one");
  complaints.refused("two");
  CHECK(complaints.last_refusal() == "two");
}

TEST_CASE("words that quote a command which is not in flight are about a damaged line") {
  const SendWindow window = window_with("LINE_PURGE");
  CHECK_FALSE(quotes_what_was_not_sent("Unknown command:\"LINE_PURGE\"", window));
  CHECK(quotes_what_was_not_sent("Unknown command:\"INE_PURGE\"", window));
  CHECK_FALSE(quotes_what_was_not_sent("no quotes", window));
  CHECK_FALSE(quotes_what_was_not_sent("one \" only", window));
}
