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
// Every command taken is executed once, in order, or the session ends faulted with a reason;
// README.md tells how each loss on the wire is met. The class keeps order and state. Each algorithm
// is a state machine of its own, in a file of its name. An `ok` is followed through
// session_replies.cpp and session_sending.cpp.
// Nothing in it grows with the number of lines. One thread at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "firmware_link/session/complaints.h"           // Complaints
#include "firmware_link/session/controller_identity.h"  // ControllerIdentity
#include "firmware_link/session/greeting.h"             // Greeting, Phase
#include "firmware_link/session/life_signs.h"           // LifeSigns
#include "firmware_link/session/ordered_questions.h"    // OrderedQuestions
#include "firmware_link/session/output_buffer.h"        // OutputBuffer
#include "firmware_link/session/own_requests.h"         // OwnRequests
#include "firmware_link/session/packing.h"              // Packing
#include "firmware_link/session/planner_watch.h"        // PlannerWatch
#include "firmware_link/session/position_check.h"       // PositionCheck
#include "firmware_link/session/readiness.h"            // Readiness
#include "firmware_link/session/recovery.h"             // Recovery
#include "firmware_link/session/safe_stop.h"            // SafeStop
#include "firmware_link/session/send_window.h"          // SendWindow
#include "firmware_link/session/session_event.h"        // SessionEvent
#include "firmware_link/session/session_types.h"        // SessionState, SessionOptions
#include "firmware_link/session/shutdown_reason.h"      // ShutdownReason
#include "firmware_link/session/silence_watch.h"        // SilenceWatch
#include "firmware_link/session/temperature_watch.h"    // TemperatureWatch
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
  [[nodiscard]] const std::string& reason() const { return fault_.reason; }
  [[nodiscard]] FaultKind fault_kind() const { return fault_.kind; }

  // What the controller calls itself (M115's FIRMWARE_NAME); empty before it has said.
  [[nodiscard]] const std::string& firmware_name() const { return identity_.name(); }
  // What the printer calls itself (M115's MACHINE_TYPE); empty: it did not say.
  [[nodiscard]] const std::string& machine_type() const { return identity_.machine_type(); }
  [[nodiscard]] std::string_view dialect_name() const { return dialect().name(); }
  [[nodiscard]] const Dialect& dialect() const { return identity_.dialect(); }
  [[nodiscard]] const LinkRules& rules() const { return identity_.rules(); }
  // Whether lines can be asked for again; if not, all that leaves is taken to be executed.
  [[nodiscard]] bool numbers_lines() const { return rules().numbered; }
  [[nodiscard]] const Capabilities& capabilities() const { return identity_.capabilities(); }

  // What the controller said by itself since the last call, oldest first. kEventsMax are kept, so
  // ask after each step.
  [[nodiscard]] std::optional<SessionEvent> next_event() { return events_.pop(); }

  // --- commands ---

  // True when one more command can be taken; at most one that hasn't left is ever held.
  [[nodiscard]] bool can_take() const;

  // Takes the print's next command. REQUIRES: can_take().
  void take(const Command& command, Instant now);

  // Takes a command that is not the print's, and is not counted as one: parking, priming, a user's
  // request. It is sent in the order in which it was taken. REQUIRES: can_take().
  void insert(const Command& command, Instant now);

  // How many of the print's commands the controller has accepted: the first ones, each once and in
  // order. A journal writes it: a print resumes with command number accepted(), counted from 0.
  // Accepted moves may still wait in the planner (planner_blocks()); a reset or a power cut loses
  // those. The number goes back, by at most kWindowLinesMax, when a Resend uncovers a false `ok`.
  [[nodiscard]] std::int64_t accepted() const {
    return window_.commands_before(window_.acknowledged());
  }

  // How many moves the planner is taken to hold, at most kPlannerBlocks. ADVANCED_OK tells it;
  // otherwise it is estimated from lengths and feeds.
  [[nodiscard]] std::size_t planner_blocks() const { return planner_.blocks(); }

  // Whether the controller was ever asked to unpack lines (MeatPack). Then bytes that go past the
  // session need kMeatPackReset before them; one too many does no harm.
  [[nodiscard]] bool may_unpack() const { return packing_.may_unpack(); }

  // The number (N) of the last line that was accepted; and how many of the print's commands had
  // been accepted with a line, for the last 32 line numbers. A host that was killed learns from
  // both, and from found_line(), which of its last commands ran.
  [[nodiscard]] std::int32_t accepted_line() const;
  [[nodiscard]] std::optional<std::int64_t> commands_through_line(std::int32_t line) const;
  // The last line that the controller had accepted when this session started. nullopt: it said
  // `start`, cannot tell, or options.ask_found_line is off. Known once state() is kStreaming.
  [[nodiscard]] std::optional<std::int32_t> found_line() const { return greeting_.found_line(); }

  // For controllers that number nothing (Klipper), with ask_found_line: the position that it was
  // commanded to last when this session started, and whether it is homed. Known likewise.
  [[nodiscard]] const std::optional<Position>& found_position() const {
    return readiness_.found_position();
  }
  [[nodiscard]] std::optional<bool> found_homed() const { return readiness_.found_homed(); }

  // Says that nothing more will be taken. REQUIRES: state() is kStreaming.
  void finish(Instant now);

  // The print is paused (true) or continues (false). While it is paused, a gap between commands is
  // no stall. The controller is watched all the while.
  void hold(bool holding, Instant now);

  // --- requests while printing: each goes before the next command that is taken ---

  // M220, M221: percent of the feed and of the flow that was commanded. The last request counts.
  // Acts on moves that are not in the planner yet. REQUIRES: 10 <= percent <= 500.
  void set_feed_percent(int percent, Instant now);
  void set_flow_percent(int percent, Instant now);

  // Asks by M114 whether the controller is where it should be. Call it at the start of a layer; the
  // session does it by itself after each repeated line. A difference of filament is corrected and
  // told, a wrong position is a fault (README.md). Does nothing where LinkRules::tells_position is
  // false.
  void check_position(Instant now);

  // --- bytes and time ---

  // Bytes to be written now; the same until written() says how many of them have left.
  [[nodiscard]] std::span<const std::byte> output() const { return output_.pending(); }
  void written(std::size_t count, Instant now);

  // Bytes that were read.
  void input(std::span<const std::byte> bytes, Instant now);

  // Lets timers run. Call it at least every 50 ms.
  void tick(Instant now);

  // --- ends ---

  // Drops all commands that were not accepted, and sends `safe_sequence` (lift, heaters off …)
  // behind the others. While connecting, or after a fault that the controller may have survived, it
  // goes out as plain lines, as many as a window holds, and no answer is waited for: write output()
  // until it is empty. REQUIRES: at most kSafeSequenceMax commands.
  void stop_now(std::span<const Command> safe_sequence, Instant now);

  // Whether the controller has told, behind such plain lines, that its heaters are to be off. It
  // reads in order, so all of them were obeyed. Call input() until then.
  [[nodiscard]] bool safe_confirmed() const { return stop_.confirmed(); }

  // The printer waits for a button (SessionEvent::kWaitsForUser), and its user presses ours: M108.
  // A controller without EMERGENCY_PARSER and display does not heed it.
  void answer_user(Instant now);

  // The device has gone: faults with this reason.
  void port_lost(const std::string& reason);

  [[nodiscard]] SessionStatistics statistics() const;

 private:
  // Taken, and not in the window yet, because a line of the link's own goes before it.
  struct Deferred {
    Command command;
    bool is_command = false;
  };

  // Its last words: state() is kFaulted. `controller_may_live`: a safe sequence may reach it.
  struct Fault {
    FaultKind kind = FaultKind::kNone;
    std::string reason;
    bool controller_may_live = true;
  };

  // --- session.cpp: requests of the host, time, ends ---

  void give(const Command& command, bool is_command, Instant now);
  [[nodiscard]] std::optional<std::string> command_that_waits() const;
  void bridge_gap(Instant now);
  void tick_open(Instant now);
  void tick_greeting(Instant now);
  void tick_asking(Instant now);
  void tick_readying(Instant now);
  void tick_shut_down(Instant now);
  void tick_silence(Instant now);
  void tick_stop(Instant now);
  void restart_conversation();
  void greet(Instant now);
  void start_readying(Instant now);
  void ask_whether_ready(Instant now);
  void go_on_readying(Readiness::Step step, Instant now);
  void open(Instant now);
  void warn(std::string_view words);
  void halted(const std::string& why);
  void fault(FaultKind kind, const std::string& why, bool controller_may_live);
  [[nodiscard]] bool ended() const;

  // --- session_replies.cpp: what comes in ---

  void reply(const Reply& reply, Instant now);
  [[nodiscard]] bool reply_ends(const Reply& reply, Meaning meaning, Instant now);
  void reply_while_connecting(const Reply& reply, Meaning meaning, Instant now);
  void reply_while_readying(const Reply& reply, Meaning meaning, Instant now);
  void reply_while_open(const Reply& reply, Meaning meaning, Instant now);
  void greeted(Instant now);
  void reset_seen(Instant now);
  void shut_down_seen(std::string_view words, Instant now);
  void complaint_heard(const Reply& reply);
  void note_temperatures(const Temperatures& told, Instant now);
  void note_position(const Position& told, Instant now);
  void acknowledged(const Reply& reply, Instant now);
  [[nodiscard]] bool acknowledge(const Reply& reply);
  [[nodiscard]] bool answers_question(const Reply& reply) const;
  void acknowledge_through(std::int64_t sequence);
  void note_accepted(std::int64_t from, Instant now);
  void resend_asked(const Reply& reply, Instant now);
  void resend_doubted(const Reply& reply);
  [[nodiscard]] bool can_go_back_to(std::int64_t sequence) const;
  [[nodiscard]] bool repeat_from(std::int64_t sequence);

  // --- session_sending.cpp: what goes out, and when ---

  void settle(Instant now);
  [[nodiscard]] bool settle_asking(Instant now);
  void pump(Instant now);
  [[nodiscard]] bool send_next(Instant now);
  [[nodiscard]] bool goes_behind_others(std::int64_t sequence, Instant now) const;
  [[nodiscard]] bool put_line(std::int64_t sequence, bool ahead, Instant now);
  [[nodiscard]] bool has_next_line(Instant now);
  [[nodiscard]] Packing::Sight packing_sight() const;
  [[nodiscard]] bool own_line_due() const;
  [[nodiscard]] bool push_own_line(Instant now);
  void push_own(std::string_view text, const LineEffort& effort = {});
  void push_command(const Command& command, bool is_command);
  void settle_position();
  void correct_filament(std::int64_t excess_10nm);
  [[nodiscard]] SilenceWatch::Sight silence_sight(Instant now) const;
  void ask(const SilenceWatch::Sight& sight, Instant now);
  [[nodiscard]] bool may_ask_in_order(bool behind_long) const;
  void push_question(Instant now);
  void ask_for_answer(Instant now);
  void resynchronise(Instant now);
  void put_forced_mismatch();
  void put_wait_no_more();

  SessionOptions options_;
  SessionState state_ = SessionState::kConnecting;
  Fault fault_;
  Phase phase_ = Phase::kBanner;
  SessionStatistics statistics_;
  EventQueue events_;

  // What is sent, in order.
  SendWindow window_;
  std::optional<Deferred> deferred_;
  OwnRequests requests_;
  SafeStop stop_;
  Packing packing_;
  OutputBuffer output_;

  // What comes in, and what it means for the order.
  LineSplitter splitter_;
  LifeSigns signs_;
  Recovery recovery_;
  OrderedQuestions questions_;
  SilenceWatch silence_;
  Complaints complaints_;

  // How the conversation starts, and why it may have ended.
  ControllerIdentity identity_;
  Greeting greeting_;
  Readiness readiness_;
  ShutdownReason shutdown_;

  // What the machine does.
  PositionCheck position_;
  PlannerWatch planner_;
  TemperatureWatch temperatures_;
};

}  // namespace firmware_link
