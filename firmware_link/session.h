// One conversation with a controller: greets it, streams lines, recovers from what a wire does to
// them, stops. A pure state machine: bytes in, bytes out, time as an argument.
//
//     connecting ──banner, M110, M115──> streaming ──finish()──> finishing ──> finished
//         │                                  └──────stop_now()──> stopping ───> stopped
//         └──────────────────────────────── any fault ─────────────────────────> faulted
//
// The host's loop, at its own pace (step() in link_step.h is that, over a BytePort):
//
//     while (session.can_take() && there is a command) session.take(command, now);
//     session.written(port.write(session.output()), now);
//     session.input(bytes read, now);
//     session.tick(now);
//
// Every line that was taken is executed once, in order, or the session ends faulted with a reason;
// README.md tells how each loss on the wire is met.
// Nothing in it grows with the number of lines. One thread at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "firmware_link/command.h"      // Command
#include "firmware_link/dialect.h"      // Dialect
#include "firmware_link/instant.h"      // Instant
#include "firmware_link/reply.h"        // Temperatures, LineSplitter
#include "firmware_link/send_window.h"  // SendWindow

namespace firmware_link {

// Commands in the safe sequence of a stop, at most.
inline constexpr std::size_t kSafeSequenceMax = 16;

// Bytes waiting to be written, at most: a window, a forced mismatch, a greeting.
inline constexpr std::size_t kOutputBytesMax = 512;
static_assert(kOutputBytesMax >= kWindowBytesMax + 2 * (kLineBytesMax + 2));

enum class SessionState {
  kConnecting,
  kStreaming,
  kFinishing,  // all was taken; answers are waited for
  kFinished,   // the controller has every line, and has acknowledged it
  kStopping,   // the safe sequence is on its way
  kStopped,    // the safe sequence has been acknowledged
  kFaulted,    // final; reason() says why
};

struct SessionStatistics {
  std::int64_t commands_taken = 0;
  std::int64_t commands_sent = 0;          // without repeats
  std::int64_t commands_acknowledged = 0;  // steps back when a Resend uncovers a false `ok`
  std::int64_t bytes_sent = 0;             // with repeats
  std::int64_t lines_repeated = 0;
  std::int64_t resends = 0;                 // `Resend:` lines obeyed
  std::int64_t resends_ignored = 0;         // outside of what can be repeated
  std::int64_t resyncs = 0;                 // forced mismatches after a silence
  std::int64_t stalls = 0;                  // nothing in flight and nothing to send in mid-stream
  std::int64_t warnings = 0;                // unknown commands, errors that are not fatal
  std::int64_t stray_acknowledgements = 0;  // an `ok` that no line of ours explains
  std::int64_t replies_cut = 0;             // over kReplyBytesMax
  std::size_t lines_in_flight = 0;
  std::size_t bytes_in_flight = 0;
  std::size_t lines_in_flight_max = 0;
  std::size_t bytes_in_flight_max = 0;
  Temperatures temperatures;
};

struct SessionOptions {
  // How long a `start` is waited for before the controller is asked; a boot loader eats what comes
  // in its first 1.5 s.  DEFAULT: 2.5 s.
  Duration banner_wait{2'500'000};

  // How long an asked controller may take to answer before it is asked again, and how often.
  Duration greeting_wait{3'000'000};
  int greetings_max = 5;

  // How often one line may be asked for again, and how many forced mismatches in a row may stay
  // without success.
  int repeats_of_a_line_max = 10;
  int resyncs_in_a_row_max = 4;

  // How long the safe sequence of stop_now() may take.
  Duration stop_limit{10'000'000};

  // Numbering starts again from 1 (by M110) after this line. Lower only in tests.
  std::int32_t line_number_max = kLineNumberMax;
};

class Session {
 public:
  Session(std::unique_ptr<Dialect> dialect, const SessionOptions& options, Instant now);

  [[nodiscard]] SessionState state() const { return state_; }

  // Why it faulted: one sentence, with the controller's own words where it said any.
  [[nodiscard]] const std::string& reason() const { return reason_; }

  // The last line of the controller that was counted as a warning; empty when there is none.
  [[nodiscard]] const std::string& last_warning() const { return last_warning_; }

  // What the controller calls itself (M115's FIRMWARE_NAME); empty before it has said.
  [[nodiscard]] const std::string& firmware_name() const { return firmware_name_; }

  // True when one more command can be taken; at most one that hasn't left is ever held.
  [[nodiscard]] bool can_take() const;

  // Takes a command to be sent. REQUIRES: can_take().
  void take(const Command& command, Instant now);

  // Says that nothing more will be taken. REQUIRES: state() is kStreaming.
  void finish(Instant now);

  // Bytes to be written now; the same until written() says how many of them have left.
  [[nodiscard]] std::span<const std::byte> output() const;
  void written(std::size_t count, Instant now);

  // Bytes that were read.
  void input(std::span<const std::byte> bytes, Instant now);

  // Lets timers run. Call it at least every 50 ms.
  void tick(Instant now);

  // Drops what has been taken and not accepted, and sends `safe_sequence` (lift, heaters off …)
  // behind what has. While still connecting, or when faulted with a controller that may yet live,
  // it goes out unnumbered, as far as a window holds it, and nobody waits for its answers: write
  // output() until it is empty. REQUIRES: at most kSafeSequenceMax commands.
  void stop_now(std::span<const Command> safe_sequence, Instant now);

  // The device has gone: faults with this reason.
  void port_lost(const std::string& reason);

  [[nodiscard]] SessionStatistics statistics() const;

 private:
  // kGreeting comes again, in mid-stream, when the line numbers have run out.
  enum class Phase { kBanner, kGreeting, kAsking, kOpen };

  // session_replies.cpp: what comes in.
  void reply(const Reply& reply, Instant now);
  void reply_while_greeting(const Reply& reply, Meaning meaning, Instant now);
  void acknowledged(const Reply& reply, Instant now);
  void resend_asked(const Reply& reply, Instant now);
  void greeted(Instant now);
  void reset_seen(Instant now);

  // session.cpp: what goes out, and when.
  void fault(const std::string& why, bool controller_may_live);
  void tick_greeting(Instant now);
  void tick_silence(Instant now);
  void greet(Instant now);
  void resynchronise(Instant now);
  void settle(Instant now);
  void pump(Instant now);
  [[nodiscard]] bool send_next(Instant now);
  void put(std::string_view bytes);
  void put_safe_sequence();
  [[nodiscard]] bool ended() const;
  [[nodiscard]] std::size_t window_lines() const;
  [[nodiscard]] std::int64_t wire_number(std::int64_t sequence) const {
    return sequence - numbering_base_;
  }

  std::unique_ptr<Dialect> dialect_;
  SessionOptions options_;
  LinkRules rules_;
  SessionState state_ = SessionState::kConnecting;
  Phase phase_ = Phase::kBanner;
  std::string reason_;
  std::string last_warning_;
  std::string last_refusal_;
  std::string firmware_name_;
  SessionStatistics statistics_;

  SendWindow window_;
  std::int64_t numbering_base_ = -1;  // the first line is N1
  std::int64_t first_command_ = 0;    // sequence of the first command, behind what asks for names
  std::optional<std::int64_t> end_of_commands_;  // where the safe sequence of a stop begins
  std::array<TextBuffer, kSafeSequenceMax> safe_texts_{};
  std::array<std::uint8_t, kSafeSequenceMax> safe_sizes_{};
  std::size_t safe_count_ = 0;
  std::size_t safe_next_ = 0;

  LineSplitter splitter_;
  std::array<std::byte, kOutputBytesMax> output_{};
  std::size_t output_begin_ = 0;
  std::size_t output_end_ = 0;

  Instant phase_began_;
  Instant stop_began_;
  Instant last_heard_;     // any byte
  Instant last_life_;      // any answer that makes sense
  Instant last_progress_;  // an acknowledgement, or work being done
  Instant quiet_since_;    // the last answer that belongs to a Resend's aftermath
  int greetings_ = 0;
  bool start_seen_ = false;
  bool greeting_refused_ = false;
  bool named_ = false;         // what asks for names has been answered, up to its `ok`
  bool skip_next_ok_ = false;  // it belongs to a refused line
  bool recovering_ = false;    // waiting for quiet after a Resend
  bool resync_pending_ = false;
  bool confirmed_ = false;  // a forced mismatch showed that the controller has all lines
  bool controller_may_live_ = true;
  int resyncs_in_a_row_ = 0;
  int repeats_of_a_line_ = 0;
  std::int64_t repeated_line_ = -1;
  int calm_lines_missing_ = 0;
};

// Bytes that stop a controller at once if its EMERGENCY_PARSER is on, otherwise at the end of the
// running command: end of line, M112, end of line. To be written past the session.
[[nodiscard]] std::span<const std::byte> emergency_stop_bytes();

}  // namespace firmware_link
