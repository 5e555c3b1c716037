// A printer's controller that exists only in memory: bytes in, bytes out, time as an argument.
//
// It answers byte for byte as Marlin bugfix-2.1.x with its default configuration was measured to
// (the table is in README.md), and it has the same bottlenecks:
//
//     wire ──> receive ring ──> command slots ──> handler ──> planner of 16 blocks ──> motion
//     (baud)   128 bytes;       4, a line each;   one          15 usable; a full one   lengths,
//              full: bytes      over 95 bytes     command      holds the `ok` back     feeds,
//              are lost         it is cut         at a time                            acceleration
//
// A command's `ok` leaves when its handler is done: at once for a move that the planner takes, late
// for G28, G4, M109, M190, M400, with `echo:busy: processing` every 2 s meanwhile.
//
// Nothing in it grows: what was executed goes to a sink, sums to Totals.
// One thread at a time may call it; it has no thread of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "firmware_link/virtual/virtual_limits.h"  // VirtualLimits
#include "firmware_link/wire/instant.h"            // Instant, Duration

namespace firmware_link {

// One command as the handler took it.
struct ExecutedCommand {
  Instant when;
  std::optional<std::int64_t> number;  // nothing when the line came without N
  std::string_view text;               // without number and checksum, moves spelled out; valid
                                       // during the call only
  bool known = true;                   // false: answered with `echo:Unknown command:`
  std::string_view words = {};         // the text as it was sent; likewise
};

// Whose words it speaks, and by whose rules it takes lines (README.md, dialects/).
enum class VirtualDialect { kMarlin, kKlipper, kRepRap, kPrusa };

// What only Klipper has. Not homed, as after a restart, it refuses every move of an axis.
struct KlipperOptions {
  bool homed = false;                  // at power-up
  bool force_move = false;             // [force_move] enable_force_move: True
  Duration ready_after{0};             // until its microcontrollers are found
  Duration idle_timeout{600'000'000};  // [idle_timeout]: heaters and motors off
  std::string_view config_error;       // never ready, for this reason; empty: none
  // Macros of printer.cfg that are obeyed, with blanks between them; PRINT_START homes.
  std::string_view macros = "PRINT_START PRINT_END";
};

struct VirtualControllerOptions {
  // DEFAULT: kMarlin.
  VirtualDialect dialect = VirtualDialect::kMarlin;

  // Called for every command when its handler starts, in order. May be empty.
  std::function<void(const ExecutedCommand&)> executed;

  // Called when a move has ended, and not only been planned, with the index of its command among
  // those that executed() tells, from 0. Not called for moves that a reset cut off, nor for those
  // too short for a block, which are part of the next. May be empty.
  std::function<void(std::int64_t)> moved;

  // Bits a second on the wire (10 a byte); 0: bytes arrive in no time.
  // REQUIRES: >= 0.  DEFAULT: 0.
  std::int64_t baud = 0;

  // What one command costs the processor. 1.1 ms makes the 900 lines a second that were measured
  // on an ATmega2560.  REQUIRES: >= 0.
  Duration command_cost{0};

  double bed_x_mm = 200;  // Marlin's default; software end stops clamp moves to the bed
  double bed_y_mm = 200;
  double bed_origin_x_mm = 0;  // of the bed's front left corner
  double bed_origin_y_mm = 0;
  double height_z_mm = 1e9;  // Marlin's default is 200; a tower of any height is worth a try

  VirtualLimits limits;  // when it is switched on; Marlin's defaults

  double ambient_celsius = 25.45;
  double nozzle_heating_celsius_s = 4.15;  // 60 W
  double bed_heating_celsius_s = 2;
  double extrude_celsius_min = 170;

  KlipperOptions klipper;

  Duration homing_time{0};  // more than its ways take: probing
  bool busy_lines = true;   // of those that have them

  // Capabilities that vary between builds.
  bool advanced_ok = false;
  bool emergency_parser = false;
  bool meatpack = false;
  bool tells_travel = true;  // M211 is known
};

struct VirtualControllerTotals {
  std::int64_t commands = 0;
  std::int64_t unknown_commands = 0;
  std::int64_t unnumbered_commands = 0;
  std::int64_t moves = 0;
  std::int64_t resends_asked = 0;
  std::int64_t receive_bytes_lost = 0;
  std::int64_t cold_extrusions = 0;
  std::int64_t clamped_moves = 0;  // by the software end stops

  // Net filament pushed, and the length of all moves in x, y, z.
  std::int64_t filament_10nm = 0;
  double filament_mm() const { return static_cast<double>(filament_10nm) * 1e-5; }
  double distance_mm = 0;
  double z_mm_max = 0;  // highest z at which material left the nozzle

  // The longest time that it had nothing to do: nothing planned, no command at hand, and a nozzle
  // that has laid roads and was not told to cool down. There it stands on the part.
  Duration stood_max{0};

  // The planner ran dry while moves still came (a blob on the part), and how long it was below half
  // full while it moved (where Marlin starts to slow down).
  std::int64_t planner_underruns = 0;
  Duration planner_low{0};
  Duration planner_busy{0};  // of moves that have ended
  std::size_t planner_blocks_max = 0;
  std::size_t receive_bytes_max = 0;
};

struct VirtualControllerState {
  double x_mm = 0;
  double y_mm = 0;
  double z_mm = 0;
  double e_mm = 0;
  double nozzle_celsius = 0;
  double nozzle_target_celsius = 0;
  double bed_celsius = 0;
  double bed_target_celsius = 0;
  int fan = 0;
  bool halted = false;
  std::int64_t last_line = 0;
  std::size_t planner_blocks = 0;  // moves that have not ended

  // What commands have set, and holds until others set it again.
  std::int64_t tool = 0;
  std::int64_t feed_percent = 100;
  std::int64_t flow_percent = 100;
  double pressure_advance = 0;  // as it was told: s, or Marlin's K
  VirtualLimits limits;
};

class VirtualController {
 public:
  // Powers up at `now`: the start banner is there to be read.
  VirtualController(const VirtualControllerOptions& options, Instant now);
  ~VirtualController();
  VirtualController(const VirtualController&) = delete;
  VirtualController& operator=(const VirtualController&) = delete;

  // Puts bytes on the wire at `now` and returns how many it took: all, unless the wire has a baud
  // and its 4 KiB driver buffer is full. REQUIRES: `now` never goes back, here and below.
  [[nodiscard]] std::size_t input(std::span<const std::byte> bytes, Instant now);

  // Lives until `now`.
  void advance(Instant now);

  // Takes answers that are waiting to be read; returns how many bytes. A controller whose 4 KiB of
  // answers nobody reads stands still, as a real one does.
  [[nodiscard]] std::size_t output(std::span<std::byte> into);

  // When something next happens by itself: a byte arrives, a handler ends, a report is due.
  // Nothing: never, without input.
  [[nodiscard]] std::optional<Instant> next_event() const;

  // True while bytes are on the wire, a line waits or a command is in its handler: an answer comes.
  [[nodiscard]] bool owes_answer() const;

  // True while the planner holds moves.
  [[nodiscard]] bool moving() const;

  // --- what may go wrong with it ---

  // Halts as if killed, with these words before Marlin's last ("Error:Thermal Runaway …\n");
  // Klipper shuts down with them and answers every line with an alarm.
  void halt(std::string_view words, Instant now);

  // Says something that nobody asked for. REQUIRES: at most 200 bytes, with line end.
  void say(std::string_view words, Instant now);

  // The next command, or the next with this word, takes so much longer, with the usual signs of
  // life.
  void delay_next(Duration delay, std::string_view word = {});

  // The `ok` to the next command with this word (to any, when it is empty) gets lost on its way, or
  // damaged: then `instead` comes, a line with its end.
  void lose_answer(std::string_view word, std::string_view instead);

  // Its count of lines jumps.
  void set_last_line(std::int64_t number, Instant now);

  // From now on it says nothing by itself while a command is in its handler.
  void work_in_silence();

  // Its heaters give no more warmth.
  void break_heaters(Instant now);

  // Klipper's RESTART from elsewhere: all is forgotten but the totals, and it is ready so much
  // later.
  void restart(Duration ready_after, Instant now);

  // Presses the reset button: all is forgotten but the totals, and `start` is said again.
  void reset(Instant now);

  [[nodiscard]] VirtualControllerState state() const;
  [[nodiscard]] const VirtualControllerTotals& totals() const;

 private:
  class Firmware;
  std::unique_ptr<Firmware> firmware_;
};

}  // namespace firmware_link
