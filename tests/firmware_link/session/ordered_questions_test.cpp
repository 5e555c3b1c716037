#include "firmware_link/session/ordered_questions.h"

#include <doctest/doctest.h>

#include <initializer_list>
#include <string>

using firmware_link::OrderedQuestions;
using firmware_link::SendWindow;

namespace {

struct Bench {
  SendWindow window;
  OrderedQuestions questions;

  void send(std::initializer_list<const char*> texts) {
    for (const char* text : texts) {
      window.push(text, true);
      window.sent(10);
    }
  }
  void ask() {
    questions.ask(window);
    window.sent(5);
  }
};

}  // namespace

TEST_CASE("an answer acknowledges what was sent before its question, and tells what is missing") {
  Bench bench;
  bench.send({"G1X1", "G1X2"});
  bench.ask();
  bench.send({"G1X3"});
  CHECK(OrderedQuestions::in_flight(bench.window) == 1);
  const auto through = bench.questions.answered(bench.window);
  REQUIRE(through.has_value());
  CHECK(*through == 2);
  CHECK(OrderedQuestions::acknowledge_through(bench.window, *through));
  CHECK(bench.window.acknowledged() == 3);
  CHECK_FALSE(bench.questions.answered(bench.window).has_value());
}

TEST_CASE("where all before a question was answered, nothing is missing") {
  Bench bench;
  bench.send({"G1X1"});
  bench.ask();
  CHECK(bench.window.acknowledge_one());
  CHECK_FALSE(
      OrderedQuestions::acknowledge_through(bench.window, *bench.questions.answered(bench.window)));
}

TEST_CASE("questions that stand together have one answer; late ones name nothing behind them") {
  Bench bench;
  bench.send({"G1X1"});
  for (int i = 0; i < 3; ++i) bench.ask();
  CHECK(*bench.questions.answered(bench.window) == 3);
  CHECK(OrderedQuestions::acknowledge_through(bench.window, 3));
  bench.send({"G1X2"});
  bench.ask();
  bool plain = false;
  SUBCASE("two late answers") {}
  SUBCASE("a plain ok between shows that the late ones were lost") { plain = true; }
  if (plain) {
    bench.questions.plain_ok_heard();
  } else {
    CHECK_FALSE(bench.questions.answered(bench.window).has_value());
    CHECK_FALSE(bench.questions.answered(bench.window).has_value());
  }
  CHECK(*bench.questions.answered(bench.window) == 5);
}

TEST_CASE("a question goes before a line that waits for room, and again when it is repeated") {
  Bench bench;
  bench.send({"G1X1"});
  bench.window.push("G1X2", true);
  CHECK(OrderedQuestions::fits(bench.window));
  bench.questions.ask(bench.window);
  CHECK(bench.window.next_text() == "M105");
  CHECK(bench.questions.goes_ahead(bench.window, 1));
  CHECK_FALSE(bench.questions.goes_ahead(bench.window, 2));
  bench.window.sent(5);
  bench.window.restart(0);
  CHECK_FALSE(OrderedQuestions::fits(bench.window));
  CHECK_FALSE(bench.questions.goes_ahead(bench.window, 0));
  CHECK(bench.questions.goes_ahead(bench.window, 1));
}
