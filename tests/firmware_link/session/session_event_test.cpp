#include "firmware_link/session/session_event.h"

#include <doctest/doctest.h>

#include <string>

using namespace firmware_link;

TEST_CASE("events come out in order; the oldest is dropped and counted when nobody takes them") {
  EventQueue queue;
  CHECK_FALSE(queue.pop().has_value());
  const int count = static_cast<int>(kEventsMax) + 3;
  for (int i = 0; i < count; ++i) queue.push(SessionEvent::Kind::kAction, std::to_string(i));
  CHECK(queue.dropped() == 3);
  for (int i = 3; i < count; ++i) CHECK(queue.pop()->text == std::to_string(i));
  CHECK_FALSE(queue.pop().has_value());
}

TEST_CASE("host actions by their words") {
  using Kind = SessionEvent::Kind;
  CHECK(kind_of_action("pause") == Kind::kPauseAsked);
  CHECK(kind_of_action("paused") == Kind::kPaused);
  CHECK(kind_of_action("cancel") == Kind::kCancelAsked);
  CHECK(kind_of_action("prompt_end") == Kind::kAction);
}
