// One conversation with a controller: greets it, finds out how it speaks, streams lines, recovers
// from what a wire does to them, watches, stops. A pure state machine: bytes in, bytes out, time as
// an argument.
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
//     while (auto event = session.next_event()) …
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

#include "firmware_link/session/controller_identity.h"  // ControllerIdentity
#include "firmware_link/session/greeting.h"             // Greeting, Phase
#include "firmware_link/session/heater_watch.h"         // HeaterWatch
#include "firmware_link/session/life_signs.h"           // LifeSigns
#include "firmware_link/session/ordered_questions.h"    // OrderedQuestions
#include "firmware_link/session/output_buffer.h"        // OutputBuffer
#include "firmware_link/session/packing.h"              // Packing
#include "firmware_link/session/planner_watch.h"        // PlannerWatch
#include "firmware_link/session/position_watch.h"       // PositionWatch
#include "firmware_link/session/readiness.h"            // Readiness
#include "firmware_link/session/recovery.h"             // Recovery
#include "firmware_link/session/send_window.h"          // SendWindow
#include "firmware_link/session/session_event.h"        // SessionEvent
#include "firmware_link/session/session_parts.h"        // OwnRequests, DeferredCommand
#include "firmware_link/session/session_types.h"        // SessionState, SessionOptions
#include "firmware_link/session/shutdown_reason.h"      // ShutdownReason
#include "firmware_link/session/silence_watch.h"        // SilenceWatch
#include "firmware_link/wire/command.h"                 // Command
#include "firmware_link/wire/instant.h"                 // Instant
#include "firmware_link/wire/reply.h"                   // LineSplitter

namespace firmware_link {

class Session {
 public:
  // Speaks `dialect` until the controller has said what it is; then its own (dialects.h).
  Session(std::unique_ptr<Dialect> dialect, const SessionOptions& options, Instant now);

  [[nodiscard]] SessionState state() const { return state_; }

  // Why it faulted: one sentence, with the controller's own words where it said any.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] FaultKind fault_kind() const { return fault_kind_; }

  // The last line of the controller that was counted as a warning; empty when there is none.
  [[nodiscard]] const std::string& last_warning() const { return last_warning_; }

  // What the controller calls itself (M115's FIRMWARE_NAME); empty before it has said.
  [[nodiscard]] const std::string& firmware_name() const { return identity_.name(); }
  [[nodiscard]] std::string_view dialect_name() const { return dialect().name(); }
  [[nodiscard]] const Dialect& dialect() const { return identity_.dialect(); }
  [[nodiscard]] const LinkRules& rules() const { return identity_.rules(); }
  // Whether lines can be asked for again; if not, all that leaves is taken to be executed.
  [[nodiscard]] bool numbers_lines() const { return rules().numbered; }
  [[nodiscard]] const Capabilities& capabilities() const { return identity_.capabilities(); }

  // What came from the controller by itself since the last call, oldest first. COSTS: kEventsMax
  // are kept, so ask after each step.
  [[nodiscard]] std::optional<SessionEvent> next_event() { return events_.pop(); }

  // --- commands ---

  // True when one more command can be taken; at most one that hasn't left is ever held.
  [[nodiscard]] bool can_take() const;

  // Takes the print's next command. REQUIRES: can_take().
  void take(const Command& command, Instant now);

  // Takes a command that is none of the print's and is not counted as one: parking, priming, a
  // user's request. It keeps its place among the others. REQUIRES: can_take().
  void insert(const Command& command, Instant now);

  // How many of the print's commands, from its first, the controller has accepted: each once and in
  // order, nothing behind them. What a journal writes: command number accepted() (counted from 0)
  // is the one to go on with. Accepted moves may still wait in the planner (see planner_blocks()),
  // and a reset or a power cut loses those. Takes a step back, by at most kWindowLinesMax, when a
  // Resend uncovers a false `ok`.
  [[nodiscard]] std::int64_t accepted() const {
    return window_.commands_before(window_.acknowledged());
  }

  // Moves that the planner is taken to hold still, at most kPlannerBlocks: told by ADVANCED_OK,
  // otherwise estimated from their lengths and feeds.
  [[nodiscard]] std::size_t planner_blocks() const { return planner_.blocks(); }

  // Whether the controller was ever asked to unpack lines (MeatPack), so that bytes past the
  // session need kMeatPackReset before them: one too many does no harm.
  [[nodiscard]] bool may_unpack() const { return packing_.may_unpack(); }

  // The line number (N) of the last line that was accepted, and how many of the print's commands
  // have been accepted with any line number of the last 32. With the answer of a controller that
  // did not reset (found_line()), a host that was killed learns which of its last commands ran.
  [[nodiscard]] std::int32_t accepted_line() const;
  [[nodiscard]] std::optional<std::int64_t> commands_through_line(std::int32_t line) const;
  // The line that the controller had last when we came: nothing when it said `start`, cannot tell,
  // or options.ask_found_line is off. Known once state() is kStreaming.
  [[nodiscard]] std::optional<std::int32_t> found_line() const { return greeting_.found_line(); }

  // Where such a controller was when we came, as it was commanded last, and whether it knows that
  // it is there; for those that number nothing and tell it (Klipper). Known likewise.
  [[nodiscard]] const std::optional<Position>& found_position() const {
    return readiness_.found_position();
  }
  [[nodiscard]] std::optional<bool> found_homed() const { return readiness_.found_homed(); }

  // Says that nothing more will be taken. REQUIRES: state() is kStreaming.
  void finish(Instant now);

  // Says that no commands will come for a while (true), because the print is paused, or that they
  // come again (false): a gap is then no stall. The controller is still watched.
  void hold(bool holding, Instant now);

  // --- requests while printing: each goes before the next command that is taken ---

  // M220, M221: percent of the feed and of the flow that was commanded. The last request counts.
  // Acts on moves that are not in the planner yet. REQUIRES: 10 <= percent <= 500.
  void set_feed_percent(int percent, Instant now);
  void set_flow_percent(int percent, Instant now);

  // Asks by M114 whether the controller is where it should be, as soon as may be; call it where a
  // layer begins. Also done by itself after each repeated line. What a difference leads to is in
  // README.md: filament is put right and told, a wrong place is a fault. Nothing happens where
  // the dialect's M114 is not to be relied on.
  void check_position(Instant now);

  // --- bytes and time ---

  // Bytes to be written now; the same until written() says how many of them have left.
  [[nodiscard]] std::span<const std::byte> output() const;
  void written(std::size_t count, Instant now);

  // Bytes that were read.
  void input(std::span<const std::byte> bytes, Instant now);

  // Lets timers run. Call it at least every 50 ms.
  void tick(Instant now);

  // --- ends ---

  // Drops what has been taken and not accepted, and sends `safe_sequence` (lift, heaters off …)
  // behind what has. While still connecting, or when faulted with a controller that may yet live,
  // it goes out unnumbered, as far as a window holds it, and nobody waits for its answers: write
  // output() until it is empty. REQUIRES: at most kSafeSequenceMax commands.
  void stop_now(std::span<const Command> safe_sequence, Instant now);

  // Whether the controller has told, behind such a safe sequence, that its heaters are off: it
  // reads in order, so all of the sequence was obeyed. Go on with input() for that.
  [[nodiscard]] bool safe_confirmed() const { return safe_confirmed_; }

  // The printer waits for a button (SessionEvent::kWaitsForUser), and its user presses ours: M108.
  // A controller without EMERGENCY_PARSER and display does not heed it.
  void answer_user(Instant now);

  // The device has gone: faults with this reason.
  void port_lost(const std::string& reason);

  [[nodiscard]] SessionStatistics statistics() const;

 private:
  [[nodiscard]] bool talks() const {
    return phase_ == Phase::kAsking || phase_ == Phase::kReadying || phase_ == Phase::kOpen;
  }

  // session_greeting.cpp: how it begins.
  void tick_greeting(Instant now);
  void greet(Instant now);
  void reply_while_greeting(const Reply& reply, Meaning meaning, Instant now);
  void greeted(Instant now);
  void tick_asking(Instant now);
  [[nodiscard]] bool asks_name_again(Instant now);
  [[nodiscard]] bool adopt_dialect();
  void open(Instant now);

  // session_readiness.cpp: whether it is ready, where it is, why it has shut down.
  void start_readying(Instant now);
  void ask_whether_ready(Instant now);
  void go_on_readying(Readiness::Step step, Instant now);
  void tick_readying(Instant now);
  void reply_while_readying(const Reply& reply, Meaning meaning, Instant now);
  void shut_down_seen(std::string_view words, Instant now);
  void tick_shut_down(Instant now);
  void end_shut_down(std::string_view reason);
  void halted(const std::string& why);

  // session_time.cpp: how long things may take.
  void bridge_gap(Instant now);
  void note_stop_behind(Instant now);
  void tick_stop(Instant now);

  // session_warnings.cpp: what is for people, and what they may be told of a safe stop.
  [[nodiscard]] bool sent_lately(std::string_view command) const;
  void hear_safety(std::span<const std::byte> bytes);
  void complaint_heard(const Reply& reply);
  void complaint_mended();
  void complaint_stands();

  // session_replies.cpp: what comes in.
  void reply(const Reply& reply, Instant now);
  void reply_while_open(const Reply& reply, Meaning meaning, Instant now);
  void acknowledged(const Reply& reply, Instant now);
  void note_accepted(std::int64_t from, Instant now);
  void resend_asked(const Reply& reply, Instant now);
  void resend_doubted(const Reply& reply);
  [[nodiscard]] bool can_go_back_to(std::int64_t sequence) const;
  [[nodiscard]] bool repeat_from(std::int64_t sequence);
  void reset_seen(Instant now);

  // session_watch.cpp: the link's own lines and what it watches.
  void give(const Command& command, bool is_command, Instant now);
  void push_command(const Command& command, bool is_command);
  void push_own(std::string_view text, const LineEffort& effort = {});
  [[nodiscard]] bool own_line_due() const;
  [[nodiscard]] bool push_own_line(Instant now);
  void tick_watch(Instant now);
  void note_temperatures(const Reply& reply, Instant now);
  void note_action(std::string_view action);
  void warn(std::string_view words);
  void settle_position();
  void end_confirming();
  void filament_differs(std::int64_t excess_10nm);

  // session_asking.cpp: an answer is missing.
  void tick_silence(Instant now);
  [[nodiscard]] SilenceWatch::Sight sight(Instant now) const;
  void ask(const SilenceWatch::Sight& sight, Instant now);
  void push_question(Instant now);
  [[nodiscard]] bool may_ask_in_order(bool behind_long) const;
  void ask_for_answer(Instant now);
  [[nodiscard]] bool names_a_line(const Reply& reply) const;
  void acknowledge_through(std::int64_t sequence);
  void answers_missing();
  [[nodiscard]] bool damaged_by(const Reply& reply) const;
  void resynchronise(Instant now);
  void put_forced_mismatch();

  // session.cpp: what goes out, and when.
  void fault(FaultKind kind, const std::string& why, bool controller_may_live);
  void settle(Instant now);
  void pump(Instant now);
  [[nodiscard]] bool send_next(Instant now);
  void put_safe_sequence();
  void put_wait_no_more();
  [[nodiscard]] bool ended() const;
  [[nodiscard]] std::size_t window_lines(Instant now) const;
  [[nodiscard]] Packing::Sight packing_sight() const;
  [[nodiscard]] bool goes_behind_others(std::int64_t sequence) const;

  ControllerIdentity identity_;
  SessionOptions options_;
  SessionState state_ = SessionState::kConnecting;
  FaultKind fault_kind_ = FaultKind::kNone;
  Phase phase_ = Phase::kBanner;
  std::string reason_;
  std::string last_warning_;
  std::string last_refusal_;
  SessionStatistics statistics_;
  EventQueue events_;

  SendWindow window_;
  std::optional<std::int64_t> end_of_commands_;  // where the safe sequence of a stop begins
  std::array<TextBuffer, kSafeSequenceMax> safe_texts_{};
  std::array<std::uint8_t, kSafeSequenceMax> safe_sizes_{};
  std::size_t safe_count_ = 0;
  std::size_t safe_next_ = 0;

  OwnRequests own_requests_;
  std::optional<DeferredCommand> deferred_;
  std::optional<PositionQuestion> question_;
  int questions_in_a_row_ = 0;  // that found a difference, or no answer
  bool confirming_ = false;     // a difference was told: no move until it is sure
  std::optional<Position> told_last_;
  PositionWatch position_;
  PlannerWatch planner_;
  HeaterWatch nozzle_watch_{"the nozzle", nozzle_watch_limits()};
  HeaterWatch bed_watch_{"the bed", bed_watch_limits()};

  std::optional<std::string> complaint_;  // until it is known whether it was about a mended line

  std::optional<std::string> stop_behind_;  // a stop waits for this command
  bool stop_told_ = false;
  bool listens_ = false;  // behind the safe sequence of a fault
  bool safe_confirmed_ = false;

  LineSplitter splitter_;
  OutputBuffer output_;
  Packing packing_;

  LifeSigns signs_;
  Greeting greeting_;
  Readiness readiness_;
  ShutdownReason shutdown_;
  Recovery recovery_;
  SilenceWatch silence_;
  OrderedQuestions questions_;
  Instant stop_began_;
  Instant last_polled_;
  Instant last_awake_{};  // a paused print was kept awake
  bool controller_may_live_ = true;
  bool holding_ = false;
  bool waits_for_user_ = false;
};

}  // namespace firmware_link
