// A session talked to by random bytes: it never crashes, its window is kept, it ends in bounded
// time, and no line that was taken leaves before a controller has answered.
//
//     input: pieces of [how long to wait][how many bytes][bytes …]
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>

#include "firmware_link/dialects/marlin_dialect.h"
#include "firmware_link/session/session.h"

using namespace firmware_link;

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

class Host {
 public:
  // A stop waits for one that says that it works, but not all day.
  static SessionOptions impatient() {
    SessionOptions options;
    options.long_stop_limit = options.stop_limit;
    return options;
  }

  explicit Host(bool greeted) : session_(std::make_unique<MarlinDialect>(), impatient(), now_) {
    if (!greeted) return;
    say("start\n");
    pass(std::chrono::milliseconds(400));
    say("Line: 0\nok\n");
    say("FIRMWARE_NAME:Marlin 2 SOURCE_CODE_URL:x\nCap:EMERGENCY_PARSER:1\nok\n");
    require(session_.state() == SessionState::kStreaming);
  }

  void say(std::string_view text) {
    session_.input(std::as_bytes(std::span(text.data(), text.size())), now_);
    turn();
  }

  void pass(Duration time) {
    for (const Instant end = now_ + time; now_ < end; now_ += std::chrono::milliseconds(50)) turn();
  }

  void turn() {
    if (session_.can_take()) {
      Move move;
      move.x_um = ++taken_ * 1000;
      move.e_10nm = 100;
      session_.take(move, now_);
    }
    const auto output = session_.output();
    const std::string_view text(reinterpret_cast<const char*>(output.data()), output.size());
    // Nothing moves before the greeting is over.
    require(taken_ > 0 || text.find('G') == std::string_view::npos);
    session_.written(output.size(), now_);
    session_.tick(now_);
    while (session_.next_event()) {
    }
    const SessionStatistics statistics = session_.statistics();
    require(statistics.lines_in_flight <= kWindowLinesMax);
    require(statistics.bytes_in_flight <= kWindowBytesMax);
    require(session_.accepted() >= 0 && session_.accepted() <= taken_);
    require(session_.state() != SessionState::kFaulted || !session_.reason().empty());
  }

  void end() {
    const Command off = SetTemperature{};
    session_.stop_now({&off, 1}, now_);
    pass(std::chrono::seconds(15));
    require(session_.state() == SessionState::kStopped ||
            session_.state() == SessionState::kFaulted);
  }

 private:
  Instant now_{};
  Session session_;
  std::int64_t taken_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0 || size > 4096) return 0;
  Host host((data[0] & 1U) != 0);
  std::size_t at = 1;
  while (at + 2 <= size) {
    const int wait = data[at];
    const std::size_t count = std::min<std::size_t>(data[at + 1], size - at - 2);
    // Short waits mostly, a few of many seconds.
    host.pass(wait < 200 ? std::chrono::milliseconds(wait) : std::chrono::seconds(wait - 199));
    host.say({reinterpret_cast<const char*>(data) + at + 2, count});
    at += 2 + count;
  }
  host.end();
  return 0;
}
