// The inside of the virtual controller, in the order in which Marlin's main loop does things:
//
//     virtual_firmware.cpp   time: what happens next; wire, receive ring, waiting handlers, reports
//     virtual_queue.cpp      bytes -> lines -> command slots: comments, numbers, checksums, cuts
//     virtual_commands.cpp   moves and waits: what G commands do, and when a handler is done
//     virtual_arc.cpp        G2, G3, and blocks for the planner
//     virtual_machine_codes.cpp   what M commands do
//     virtual_klipper.cpp    Klipper's states, words and refusals
//     virtual_texts.h        long texts: the banner, M115
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "firmware_link/session/planner_watch.h"  // kArcBlockUm
#include "firmware_link/virtual/virtual_controller.h"
#include "firmware_link/virtual/virtual_heater.h"   // VirtualHeater
#include "firmware_link/virtual/virtual_planner.h"  // VirtualPlanner
#include "firmware_link/wire/check.h"
#include "firmware_link/wire/line_codec.h"   // word
#include "firmware_link/wire/meat_pack.h"    // MeatUnpacker
#include "firmware_link/wire/ring_buffer.h"  // RingBuffer

namespace firmware_link {

// Bytes that a driver holds for a slow wire, and answers that wait to be read.
inline constexpr std::size_t kWireBytesMax = 4096;
inline constexpr std::size_t kAnswerBytesMax = 8192;

// How long a temperature must hold before M109 and M190 are done.
inline constexpr Duration kResidency = std::chrono::seconds(10);

// Its members stand by what they belong to, not by size.
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding)
class VirtualController::Firmware {
 public:
  Firmware(const VirtualControllerOptions& options, Instant now);

  std::size_t input(std::span<const std::byte> bytes, Instant now);
  void advance(Instant now);
  std::size_t output(std::span<std::byte> into);
  [[nodiscard]] std::optional<Instant> next_event() const;
  [[nodiscard]] bool owes_answer() const;
  [[nodiscard]] bool moving() const { return !planner_.empty(); }
  void reset(Instant now);
  void restart(Duration ready_after, Instant now);
  void halt(std::string_view words, Instant now);
  void say(std::string_view words, Instant now);
  void delay_next(Duration delay, std::string_view word) {
    delay_next_ = delay;
    delay_word_ = std::string(word);
  }
  void lose_answer(std::string_view word, std::string_view instead);
  void set_last_line(std::int64_t number, Instant now);
  void work_in_silence() { busy_interval_s_ = 0, silent_ = true; }
  void break_heaters(Instant now);
  [[nodiscard]] VirtualControllerState state() const;
  [[nodiscard]] const VirtualControllerTotals& totals();

 private:
  // A line in a command slot, as Marlin keeps it: with number and checksum.
  struct Slot {
    std::array<char, kLineBytesMax> bytes{};
    std::size_t size = 0;
    [[nodiscard]] std::string_view line() const { return {bytes.data(), size}; }
  };

  // Radius 0: not known, as with R.
  struct ArcWay {
    double length_mm = 0;
    double radius_mm = 0;
    std::array<double, 2> centre_mm{};
    double begin = 0;  // angle about the centre, radians
    double turn = 0;   // counter-clockwise
  };

  // What a handler waits for before its `ok` leaves.
  enum class Waiting { kNothing, kTime, kPlannerSlot, kPlannerEmpty, kNozzle, kBed };

  // virtual_firmware.cpp
  bool step();
  void note_standing();
  void receive(char c);
  void print(std::string_view text);
  // As printf; at most 255 characters.
  template <typename... Values>
  void print_format(const char* format, Values... values) {
    char text[256];
    const int size = std::snprintf(text, sizeof text, format, values...);
    LINK_CHECK(size >= 0 && static_cast<std::size_t>(size) < sizeof text);
    print({text, static_cast<std::size_t>(size)});
  }
  [[nodiscard]] bool blocked() const { return answers_.room() < kAnswerBytesMax / 2; }
  bool report();
  void print_temperatures();
  [[nodiscard]] std::string temperatures() const;
  [[nodiscard]] bool speaks(VirtualDialect dialect) const { return options_.dialect == dialect; }
  void kill(std::string_view words);
  void forget_all();

  // virtual_klipper.cpp
  enum class KlipperState { kStartup, kReady, kShutdown, kError };
  void klipper_begin(Duration ready_after);
  [[nodiscard]] bool klipper_turn();
  [[nodiscard]] std::optional<Instant> klipper_next() const;
  [[nodiscard]] std::string klipper_state_message() const;
  void klipper_error(std::string_view message);
  void klipper_shut_down(std::string_view words);
  [[nodiscard]] bool klipper_answers(std::string_view text);
  [[nodiscard]] bool klipper_answers_unready(std::string_view command);
  void klipper_help();
  void klipper_set_position(std::string_view text);
  [[nodiscard]] bool klipper_refuses(const std::array<std::int64_t, 3>& target_um,
                                     std::int64_t filament_10nm);

  // virtual_queue.cpp
  bool read_bytes();
  bool read_character(char c);
  void take_slot(const Slot& slot);
  [[nodiscard]] bool plain_line_accepted(Slot& slot) const;
  void end_line();
  [[nodiscard]] bool number_accepted(std::string_view line);
  void line_error(std::string_view what);
  void flush_and_request_resend();

  // virtual_commands.cpp
  void begin_command();
  bool finish_command();
  bool wait_over();
  bool heated(const VirtualHeater& heater);
  void end_command();
  [[nodiscard]] bool handle(char letter, std::int64_t code, std::string_view text);
  [[nodiscard]] bool handle_g(std::int64_t code, std::string_view text);
  [[nodiscard]] bool handle_m(std::int64_t code, std::string_view text);
  [[nodiscard]] bool handle_m_temperature(std::int64_t code, std::string_view text);
  [[nodiscard]] bool handle_m_host(std::int64_t code, std::string_view text);
  void move(std::string_view text, const ArcWay* way);
  void queue_move(double length_mm, const std::array<double, 3>& delta, double filament_mm,
                  const ArcWay* way);
  void dwell(std::string_view text);
  void home(std::string_view text);
  void set_position(std::string_view text);
  void print_position();
  void print_travel();
  void wait(Waiting waiting);
  void wait_until(Instant when);

  // virtual_arc.cpp
  void arc(std::int64_t code, std::string_view text);
  [[nodiscard]] bool leaves_bed(const ArcWay& way) const;
  void queue_arc(const ArcWay& way, PlannerMove block);
  void queue_blocks(const PlannerMove& block, std::size_t count);
  [[nodiscard]] bool plan_pending();

  VirtualControllerOptions options_;
  VirtualControllerTotals totals_;
  Instant now_;

  RingBuffer<char, kWireBytesMax> wire_;
  Instant wire_ready_;  // when the wire's first byte has arrived
  RingBuffer<char, kControllerReceiveBytes> receive_;
  RingBuffer<char, kAnswerBytesMax> answers_;

  MeatUnpacker unpacker_;
  Slot assembling_;
  bool in_comment_ = false;
  bool escaped_ = false;
  std::int64_t last_number_ = 0;

  RingBuffer<Slot, kControllerCommandSlots> slots_;

  // The command in its handler, always that of the first slot.
  bool handling_ = false;
  bool refused_ = false;  // it did nothing
  Waiting waiting_ = Waiting::kNothing;
  std::optional<std::int64_t> current_number_;
  bool temperatures_asked_ = false;
  bool identity_asked_ = false;
  bool waiting_cancelled_ = false;
  Duration dwell_{0};  // behind the planner's last move
  bool homing_ = false;
  std::array<bool, 3> home_axes_{};
  Instant wait_until_;
  Instant busy_next_;
  Instant heat_report_next_;
  std::optional<Instant> within_window_since_;
  PlannerMove pending_block_;
  std::size_t pending_blocks_ = 0;  // of the command in its handler, not in the planner yet
  std::int64_t pending_command_ = 0;
  double pending_turn_ = 0;  // from one to the next

  int busy_interval_s_ = 2;
  std::optional<Duration> auto_report_;
  Instant auto_report_next_;
  bool halted_ = false;
  KlipperState klipper_ = KlipperState::kReady;
  std::string klipper_words_;             // why it is shut down
  std::optional<Instant> klipper_ready_;  // when it will be
  bool klipper_idle_ = true;              // its motors and heaters are off, or will not be let go
  Instant moved_last_;
  Duration delay_next_{0};
  std::string delay_word_;
  bool silent_ = false;
  std::optional<std::string> lose_word_;  // whose next answer is lost
  std::string lose_instead_;
  bool losing_ = false;  // that of the command at hand
  bool laid_ = false;    // a road, and the nozzle was not cooled since
  std::optional<Instant> standing_since_;
  std::array<char, 4> early_{};  // of the line that comes in, for what acts before its turn
  std::size_t early_size_ = 0;

  VirtualPlanner planner_;
  bool pause_was_asked_ = true;
  VirtualHeater nozzle_;
  VirtualHeater bed_;
  int fan_ = 0;
  std::array<std::int64_t, 3> position_um_{};
  std::array<bool, 3> homed_{};
  std::int64_t e_10nm_ = 0;
  std::int64_t feed_mm_min_ = 1500;
  std::int64_t feed_percent_ = 100;
  bool relative_ = false;
  bool relative_e_ = false;
};

}  // namespace firmware_link
