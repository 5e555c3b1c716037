#include "firmware_link/session/ordered_questions.h"

#include <string_view>

namespace firmware_link {
namespace {

constexpr std::string_view kQuestion = "M105";

}  // namespace

bool OrderedQuestions::is_question(const SendWindow& window, std::int64_t sequence) {
  return window.text(sequence) == kQuestion;
}

int OrderedQuestions::in_flight(const SendWindow& window) {
  int count = 0;
  for (std::int64_t i = window.acknowledged(); i < window.next_to_send(); ++i) {
    count += is_question(window, i) ? 1 : 0;
  }
  return count;
}

bool OrderedQuestions::fits(const SendWindow& window) {
  return window.next_to_send() == window.sent_end() && window.end() - window.next_to_send() <= 1;
}

void OrderedQuestions::ask(SendWindow& window) {
  last_asked_ = window.next_to_send();
  window.push_ahead(kQuestion);
}

std::optional<std::int64_t> OrderedQuestions::answered(const SendWindow& window) {
  std::int64_t at = window.acknowledged();
  while (at < window.next_to_send() && !is_question(window, at)) ++at;
  if (at == window.next_to_send()) return std::nullopt;
  if (at > window.acknowledged() && late_answers_ > 0) {
    --late_answers_;
    return std::nullopt;
  }
  while (at + 1 < window.next_to_send() && is_question(window, at + 1)) {
    ++at;
    ++late_answers_;
  }
  return at;
}

bool OrderedQuestions::acknowledge_through(SendWindow& window, std::int64_t sequence) {
  bool missing = false;
  for (std::int64_t i = window.acknowledged(); i <= sequence; ++i) {
    missing = missing || !is_question(window, i);
  }
  window.acknowledge_before(sequence + 1);
  return missing;
}

}  // namespace firmware_link
