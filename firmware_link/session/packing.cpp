#include "firmware_link/session/packing.h"

#include <algorithm>
#include <chrono>

namespace firmware_link {
namespace {

constexpr Duration kAnswerWait = std::chrono::seconds(1);
constexpr int kTriesMax = 3;
// Lines sent plain after each trouble.
constexpr std::int64_t kPlainLines = 8;

}  // namespace

bool Packing::may_send(const Sight& sight, Instant now, OutputBuffer& output) {
  if (state_ == State::kAsked) return false;
  const bool wanted = state_ == State::kOff && sight.allowed && sight.calm &&
                      sight.next_to_send >= plain_before_ && sight.next_to_send == sight.sent_end;
  if (!wanted) return true;
  // What is in flight is answered first, so that these bytes come alone.
  if (!sight.in_flight) ask(now, output);
  return false;
}

void Packing::ask(Instant now, OutputBuffer& output) {
  ++tries_;
  state_ = State::kAsked;
  asked_at_ = now;
  may_unpack_ = true;
  output.put(kMeatPackReset);
  output.put(kMeatPackOn);
}

void Packing::heard(std::string_view state) {
  if (state_ != State::kAsked || state.find(" ON ") == std::string_view::npos) return;
  state_ = State::kOn;
  tries_ = 0;
}

void Packing::tick(const Sight& sight, Instant now, OutputBuffer& output) {
  if (state_ != State::kAsked || now - asked_at_ < kAnswerWait) return;
  if (tries_ < kTriesMax) {
    ask(now, output);
    return;
  }
  stop(sight, output);
  state_ = State::kGivenUp;
}

void Packing::stop(const Sight& sight, OutputBuffer& output) {
  if (!may_unpack_ && !sight.allowed) return;
  output.put(kMeatPackReset);
  if (state_ == State::kGivenUp) return;
  state_ = State::kOff;
  plain_before_ = sight.sent_end + kPlainLines;
}

std::optional<std::string_view> Packing::bytes_of(std::string_view line, const Sight& sight,
                                                  PackedBuffer& into, OutputBuffer& output) {
  if (state_ == State::kOn) {
    const std::string_view packed = meat_packed(line, into);
    if (packed.size() <= line.size()) return packed;
    // A line of plain text would get longer.
    if (sight.in_flight) return std::nullopt;
    stop(sight, output);
  }
  std::copy(line.begin(), line.end(), into.begin());
  into[line.size()] = '\n';
  return std::string_view(into.data(), line.size() + 1);
}

void Packing::bridge(Duration gap, Instant now) { asked_at_ = std::min(now, asked_at_ + gap); }

}  // namespace firmware_link
