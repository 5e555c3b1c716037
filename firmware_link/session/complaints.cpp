#include "firmware_link/session/complaints.h"

#include <utility>

#include "firmware_link/session/command_waits.h"  // word_of

namespace firmware_link {
namespace {

// Whether one of them starts with the other, blanks apart: lines are sent without those that need
// not be.
bool same_start(std::string_view a, std::string_view b) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (true) {
    while (i < a.size() && a[i] == ' ') ++i;
    while (j < b.size() && b[j] == ' ') ++j;
    if (i == a.size() || j == b.size()) return true;
    if (a[i++] != b[j++]) return false;
  }
}

// "M555 P1" in `"M555 P1"`.
std::string_view without_quotes(std::string_view text) {
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    text = text.substr(1, text.size() - 2);
  }
  return text;
}

// Whether such a command was among our last lines: the tail of a damaged one was not.
bool sent_lately(std::string_view command, const SendWindow& window) {
  command = without_quotes(command);
  if (command.empty()) return false;
  for (std::int64_t i = window.oldest(); i < window.sent_end(); ++i) {
    if (same_start(window.text(i), command)) return true;
  }
  return false;
}

}  // namespace

Complaints::Fate Complaints::heard(const Reply& reply, const SendWindow& window, bool numbered) {
  if (!numbered) return Fate::kTell;
  if (reply.kind == Reply::Kind::kUnknownCommand && !sent_lately(reply.text, window)) {
    return Fate::kCount;
  }
  if (reply.kind != Reply::Kind::kError) return Fate::kTell;
  // A request to repeat a line may follow: then it was its reason, damaged on its way.
  held_ = std::string(reply.text);
  return Fate::kHold;
}

bool Complaints::mended() { return std::exchange(held_, std::nullopt).has_value(); }

std::optional<std::string> Complaints::stands() { return std::exchange(held_, std::nullopt); }

bool quotes_what_was_not_sent(std::string_view words, const SendWindow& window) {
  const std::size_t start = words.find('"');
  const std::size_t end = words.rfind('"');
  if (start == std::string_view::npos || end <= start) return false;
  const std::string_view word = word_of(words.substr(start + 1, end - start - 1));
  for (std::int64_t i = window.acknowledged(); i < window.next_to_send(); ++i) {
    if (word_of(window.text(i)) == word) return false;
  }
  return true;
}

}  // namespace firmware_link
