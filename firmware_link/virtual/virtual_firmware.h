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

#include "firmware_link/session/planner_watch.h"   // kArcBlockUm
#include "firmware_link/virtual/virtual_blocks.h"  // VirtualBlocks
#include "firmware_link/virtual/virtual_controller.h"
#include "firmware_link/virtual/virtual_early_commands.h"  // VirtualEarlyCommands
#include "firmware_link/virtual/virtual_heater.h"          // VirtualHeater
#include "firmware_link/virtual/virtual_klipper_state.h"   // VirtualKlipperState
#include "firmware_link/virtual/virtual_line_numbers.h"    // VirtualLineNumbers
#include "firmware_link/virtual/virtual_line_reader.h"     // VirtualLineReader
#include "firmware_link/virtual/virtual_mishaps.h"         // VirtualMishaps
#include "firmware_link/virtual/virtual_planner.h"         // VirtualPlanner
#include "firmware_link/virtual/virtual_position.h"        // VirtualPosition
#include "firmware_link/virtual/virtual_standing.h"        // VirtualStanding
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
  void delay_next(Duration delay, std::string_view word) { mishaps_.delay_next(delay, word); }
  void lose_answer(std::string_view word, std::string_view instead) {
    mishaps_.lose_answer(word, instead);
  }
  void set_last_line(std::int64_t number, Instant now);
  void work_in_silence() {
    reports_.busy_interval_s = 0;
    mishaps_.work_in_silence();
  }
  void break_heaters(Instant now);
  [[nodiscard]] VirtualControllerState state() const;
  [[nodiscard]] const VirtualControllerTotals& totals();

 private:
  // Radius 0: not known, as with R.
  struct ArcWay {
    double length_mm = 0;
    double radius_mm = 0;
    std::array<double, 2> centre_mm{};
    double start = 0;  // angle about the centre, radians
    double turn = 0;   // counter-clockwise
  };

  // What a handler waits for before its `ok` leaves.
  enum class Waiting { kNothing, kTime, kPlannerSlot, kPlannerEmpty, kNozzle, kBed };

  // The command in its handler, always that of the first slot.
  struct Handler {
    bool runs = false;
    bool refused = false;  // it did nothing
    std::optional<std::int64_t> number;
    bool asks_temperatures = false;
    bool asks_identity = false;
    Waiting waiting = Waiting::kNothing;
    bool cancelled = false;  // M108: the wait for heat is over
    Instant until;
    Instant busy_next;
    Duration dwell{0};  // behind the planner's last move
    bool homes = false;
    std::array<bool, 3> home_axes{};
    Instant heat_report_next;
    std::optional<Instant> warm_since;  // within a degree of the target
  };

  // What it says by the clock.
  struct Reports {
    int busy_interval_s = 0;
    std::optional<Duration> temperatures;  // how often
    Instant temperatures_next;
  };

  struct Heaters {
    VirtualHeater nozzle;
    VirtualHeater bed;
    int fan = 0;
    void off() {
      nozzle.set_target(0);
      bed.set_target(0);
    }
    void advance(Instant now) {
      nozzle.advance(now);
      bed.advance(now);
    }
  };

  // What was set, and holds.
  struct Set {
    VirtualLimits limits;
    std::int64_t tool = 0;
    std::int64_t flow_percent = 100;
    double pressure_advance = 0;
  };

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
  void start_klipper(Duration ready_after);
  [[nodiscard]] bool klipper_turn();
  [[nodiscard]] std::optional<Instant> klipper_next() const;
  void klipper_error(std::string_view message);
  void klipper_shut_down(std::string_view words);
  [[nodiscard]] bool klipper_answers(std::string_view text);
  [[nodiscard]] bool klipper_macro(std::string_view text);
  [[nodiscard]] bool klipper_sets(std::string_view text);
  [[nodiscard]] bool klipper_answers_unready(std::string_view command);
  void klipper_help();
  void klipper_set_position(std::string_view text);
  [[nodiscard]] bool klipper_refuses(const VirtualPosition::Target& target);

  // virtual_queue.cpp
  bool read_bytes();
  void take_line(VirtualLine line);
  [[nodiscard]] bool plain_line_accepted(VirtualLine& line) const;
  [[nodiscard]] bool unnumbered_line_accepted(std::string_view text);
  [[nodiscard]] bool numbered_line_accepted(std::string_view text);
  void flush_and_request_resend();

  // virtual_commands.cpp
  void start_command();
  bool finish_command();
  bool wait_over();
  bool heated(const VirtualHeater& heater);
  void end_command();
  [[nodiscard]] bool handle(char letter, std::int64_t code, std::string_view text);
  [[nodiscard]] bool handle_g(std::int64_t code, std::string_view text);
  [[nodiscard]] bool handle_m(std::int64_t code, std::string_view text);
  [[nodiscard]] bool handle_m_set(std::int64_t code, std::string_view text);
  [[nodiscard]] bool handle_m_temperature(std::int64_t code, std::string_view text);
  [[nodiscard]] bool handle_m_host(std::int64_t code, std::string_view text);
  void move(std::string_view text, const ArcWay* way);
  void queue_move(double length_mm, std::array<double, 3> delta, double filament_mm,
                  const ArcWay* way);
  void dwell(std::string_view text);
  void home(std::string_view text);
  void print_position();
  void print_travel();
  void wait(Waiting waiting);
  void wait_until(Instant when);

  // virtual_arc.cpp
  void arc(std::int64_t code, std::string_view text);
  [[nodiscard]] bool leaves_bed(const ArcWay& way) const;
  void queue_arc(const ArcWay& way, PlannerMove block);
  void queue_blocks(const PlannerMove& block, std::size_t count, double turn);

  VirtualControllerOptions options_;
  VirtualControllerTotals totals_;
  Instant now_;
  bool halted_ = false;

  // From the wire to the command slots.
  RingBuffer<char, kWireBytesMax> wire_;
  Instant wire_ready_;  // when the wire's first byte has arrived
  VirtualEarlyCommands early_;
  RingBuffer<char, kControllerReceiveBytes> receive_;
  MeatUnpacker unpacker_;
  VirtualLineReader reader_;
  VirtualLineNumbers numbers_;
  RingBuffer<VirtualLine, kControllerCommandSlots> slots_;

  // What runs, and what is said.
  Handler handler_;
  VirtualMishaps mishaps_;
  Reports reports_;
  RingBuffer<char, kAnswerBytesMax> answers_;
  VirtualKlipperState klipper_;

  // The machine.
  VirtualPosition position_;
  VirtualBlocks blocks_;
  VirtualPlanner planner_;
  Set set_;
  bool pause_was_asked_ = true;
  Heaters heaters_;
  VirtualStanding standing_;
};

}  // namespace firmware_link
