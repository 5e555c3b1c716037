// MeatPack in a session: begun when nothing is in flight, and left at the first sign of trouble.
//
//     off ──FF FF F9, FF FF FB──> asked ──[MP] … ON──> on ──FF FF F9──> off
//      ▲                            │ no answer, 3 times     (a Resend, a forced mismatch, an end)
//      └──── 8 lines went well ─────┴──> given up
//
// In plain characters a forced mismatch reaches a controller whatever state its unpacker was in:
// the bytes that reset it go before.
#include <algorithm>
#include <chrono>

#include "firmware_link/session/session.h"
#include "firmware_link/wire/line_codec.h"

namespace firmware_link {
namespace {

constexpr Duration kAnswerWait = std::chrono::seconds(1);
constexpr int kTriesMax = 3;
// Lines sent as they are after each trouble.
constexpr std::int64_t kPlainLines = 8;

}  // namespace

// Only where a damaged line is found by its checksum.
bool Session::may_pack() const {
  return options_.pack && capabilities_.meatpack && rules_.numbered && phase_ == Phase::kOpen;
}

// Whether lines may leave as things are. Asks for packing where the time has come.
bool Session::packing_settled(Instant now) {
  if (packing_ == Packing::kAsked) return false;
  const bool wanted = packing_ == Packing::kOff && may_pack() &&
                      state_ == SessionState::kStreaming && calm_lines_missing_ == 0 &&
                      window_.next_to_send() >= packing_from_ &&
                      window_.next_to_send() == window_.sent_end();
  if (!wanted) return true;
  // What is in flight has its answers first, so that the bytes come alone.
  if (window_.lines_in_flight() > 0) return false;
  ask_for_packing(now);
  return false;
}

void Session::ask_for_packing(Instant now) {
  ++packing_tries_;
  packing_ = Packing::kAsked;
  packing_asked_ = now;
  may_unpack_ = true;
  output_.put(kMeatPackReset);
  output_.put(kMeatPackOn);
}

void Session::note_packing(std::string_view state) {
  if (packing_ != Packing::kAsked || state.find(" ON ") == std::string_view::npos) return;
  packing_ = Packing::kOn;
  packing_tries_ = 0;
}

void Session::tick_packing(Instant now) {
  if (packing_ != Packing::kAsked || now - packing_asked_ < kAnswerWait) return;
  if (packing_tries_ < kTriesMax) {
    ask_for_packing(now);
    return;
  }
  stop_packing();
  packing_ = Packing::kGivenUp;
}

// Whatever state the controller is in, it takes plain characters after this.
void Session::stop_packing() {
  if (!may_unpack_ && !may_pack()) return;
  output_.put(kMeatPackReset);
  if (packing_ == Packing::kGivenUp) return;
  packing_ = Packing::kOff;
  packing_from_ = window_.sent_end() + kPlainLines;
}

// The line's bytes with its end; empty: it may not leave yet.
std::string_view Session::on_the_wire(std::string_view line, PackedBuffer& into) {
  if (packing_ == Packing::kOn) {
    const std::string_view packed = meat_packed(line, into);
    if (packed.size() <= line.size()) return packed;
    // Texts get longer.
    if (window_.lines_in_flight() > 0) return {};
    stop_packing();
  }
  std::copy(line.begin(), line.end(), into.begin());
  into[line.size()] = '\n';
  return {into.data(), line.size() + 1};
}

}  // namespace firmware_link
