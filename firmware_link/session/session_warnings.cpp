// What of a controller's complaints is for people: not what the link has mended, nor what a damaged
// line was answered.
#include <algorithm>
#include <string>

#include "firmware_link/session/session.h"

namespace firmware_link {
namespace {

// Whether one of them begins with the other, blanks apart: lines go without those that need not be.
bool same_begin(std::string_view a, std::string_view b) {
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

}  // namespace

// Whether such a command was among our last lines: the tail of a damaged one was not.
bool Session::sent_lately(std::string_view command) const {
  command = without_quotes(command);
  if (command.empty()) return false;
  for (std::int64_t i = window_.oldest(); i < window_.sent_end(); ++i) {
    if (same_begin(window_.text(i), command)) return true;
  }
  return false;
}

void Session::hear_safety(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    bytes = bytes.subspan(splitter_.take(bytes));
    const auto line = splitter_.line();
    if (!line) continue;
    const Temperatures heard = read_reply(*line).temperatures;
    if (!heard.nozzle_target_celsius) continue;
    safe_confirmed_ =
        *heard.nozzle_target_celsius <= 0 && heard.bed_target_celsius.value_or(0) <= 0;
  }
}

void Session::complaint_heard(const Reply& reply) {
  if (reply.kind == Reply::Kind::kUnknownCommand && rules().numbered && !sent_lately(reply.text)) {
    ++statistics_.fragments;
    return;
  }
  if (reply.kind == Reply::Kind::kError && rules().numbered) {
    // A request to repeat a line may follow: then it was its reason, damaged on its way.
    complaint_ = std::string(reply.text);
    return;
  }
  warn(reply.text);
}

void Session::complaint_mended() {
  if (!complaint_) return;
  ++statistics_.fragments;
  complaint_.reset();
}

void Session::complaint_stands() {
  if (!complaint_) return;
  const std::string words = *std::exchange(complaint_, std::nullopt);
  warn(words);
}

}  // namespace firmware_link
