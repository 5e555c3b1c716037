// MeatPack in a session: turned on while nothing is in flight, turned off at the first sign of
// trouble.
//
//     off ──FF FF F9, FF FF FB──> asked ──[MP] … ON──> on ──FF FF F9──> off
//      ▲                            │ no answer, 3 times     (a Resend, a forced mismatch, an end)
//      └──── 8 lines went well ─────┴──> given up
//
// The bytes that turn it off go before a forced mismatch, so that the controller reads that in
// plain characters whatever state its unpacker was in.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "firmware_link/session/output_buffer.h"  // OutputBuffer
#include "firmware_link/wire/instant.h"           // Instant
#include "firmware_link/wire/meat_pack.h"         // PackedBuffer

namespace firmware_link {

class Packing {
 public:
  struct Sight {
    bool allowed = false;  // wanted by the host, offered by the controller, line numbers on
    bool calm = false;     // streaming, and no line was refused lately
    std::int64_t next_to_send = 0;  // as SendWindow counts
    std::int64_t sent_end = 0;
    bool in_flight = false;  // some line is
  };

  // Whether lines may leave now. Asks the controller to unpack where the time for that has come.
  [[nodiscard]] bool may_send(const Sight& sight, Instant now, OutputBuffer& output);

  // The bytes of a line with its end, packed or plain; nullopt: it may not leave yet.
  [[nodiscard]] std::optional<std::string_view> bytes_of(std::string_view line, const Sight& sight,
                                                         PackedBuffer& into, OutputBuffer& output);

  // The controller told the state of its unpacker.
  void heard(std::string_view state);

  // Asks again, or gives up, when no answer came.
  void tick(const Sight& sight, Instant now, OutputBuffer& output);

  // Goes back to plain characters.
  void stop(const Sight& sight, OutputBuffer& output);

  // The host stood still for so long.
  void bridge(Duration gap, Instant now);

  [[nodiscard]] bool on() const { return state_ == State::kOn; }

  // Whether the controller was ever asked to unpack, so that it may still do so.
  [[nodiscard]] bool may_unpack() const { return may_unpack_; }

 private:
  // kAsked: its answer is waited for, nothing is sent. kGivenUp: it did not answer.
  enum class State { kOff, kAsked, kOn, kGivenUp };

  void ask(Instant now, OutputBuffer& output);

  State state_ = State::kOff;
  Instant asked_at_{};
  int tries_ = 0;
  bool may_unpack_ = false;
  std::int64_t plain_before_ = 0;  // lines before this one are sent plain
};

}  // namespace firmware_link
