// What the link itself has to say, as soon as there is room: the most pressing first, each once.
//
//     M220 feed · M221 flow · G1 E correction · G92 E0 · M114 position · M155 reports · G4 P1 awake
//     · M105 temperatures
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "firmware_link/session/line_effort.h"  // LineEffort
#include "firmware_link/wire/instant.h"         // Instant

namespace firmware_link {

class OwnRequests {
 public:
  struct Line {
    enum class Kind {
      kPlain,
      kFilamentReset,  // the controller's count of filament starts at 0
      kPosition,       // its answer tells the position
    };
    Kind kind = Kind::kPlain;
    std::string text;
    LineEffort effort;
  };

  // The last request of a kind counts.
  void set_feed_percent(int percent) { feed_percent_ = percent; }
  void set_flow_percent(int percent) { flow_percent_ = percent; }
  void correct_filament(std::int64_t by_10nm) { filament_10nm_ = by_10nm; }
  void reset_filament() { reset_filament_ = true; }
  void ask_position() { ask_position_ = true; }
  // REQUIRES: whole seconds.
  void report_temperatures(Duration interval);

  // What a streaming session has to ask by itself.
  struct Sight {
    Duration temperature_interval{0};  // 0: only when nothing else is said
    bool reports_by_itself = false;    // temperatures come without being asked for
    Duration keep_awake{0};            // LinkRules::keep_awake
    bool in_flight = false;            // some line is
    Instant heard;                     // the last byte
  };
  void tick(const Sight& sight, Instant now);
  void start(Instant now) { polled_ = now; }

  // No commands come for a while, because the print is paused.
  void hold(bool holding) { holding_ = holding; }
  [[nodiscard]] bool holding() const { return holding_; }

  // Whether a line is due. `position_in_flight`: one question for the position at a time.
  [[nodiscard]] bool due(bool position_in_flight) const;

  // Takes the most pressing one. `count_is_new`: no move has been given since the controller's
  // count of filament started. REQUIRES: due(position_in_flight).
  [[nodiscard]] Line take(bool position_in_flight, bool count_is_new);

  // Forgets all requests.
  void drop();

 private:
  std::optional<int> feed_percent_;
  std::optional<int> flow_percent_;
  std::optional<std::int64_t> filament_10nm_;
  bool reset_filament_ = false;
  bool ask_position_ = false;
  std::optional<std::int64_t> report_interval_s_;
  bool stay_awake_ = false;
  bool ask_temperatures_ = false;
  bool holding_ = false;
  Instant polled_{};
  Instant awake_{};  // when a paused print was last kept awake
};

// "0.0123": filament in mm.
[[nodiscard]] std::string filament_text(std::int64_t length_10nm);

}  // namespace firmware_link
