// One direction of a wire that damages bytes and lines and delays them. Each run with the same seed
// is the same.
//
//     carry(bytes) ──lose, flip, double, insert──> held while late ──> take()
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "firmware_link/wire/instant.h"  // Instant

namespace firmware_link {

// Probabilities for each byte or line. After a fault, some bytes pass undamaged: Marlin's checksum,
// an exclusive or, does not detect two flips of the same bit in one line.
struct WireDamage {
  double lose_byte = 0;
  double flip_byte = 0;
  double double_byte = 0;
  double lose_line_end = 0;
  double lose_line = 0;
  double double_line = 0;
  double insert_line = 0;  // a line of `nonsense` before a line
  double delay_line = 0;   // by up to delay_max; lines behind it wait, too
  Duration delay_max{0};
  // A flipped byte, and then all to the end of the next line's number is gone, as if the
  // controller's flush had cut exactly there: the tail is a whole command without a number. Only of
  // a line that was on its way together with the damaged one.
  double cut_behind_number = 0;
  std::size_t distance = 100;
};

// SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014).
class SplitMix {
 public:
  explicit SplitMix(std::uint64_t seed) : state_(seed) {}
  [[nodiscard]] std::uint64_t next();
  [[nodiscard]] double share() { return static_cast<double>(next() >> 11U) * 0x1p-53; }
  // REQUIRES: count > 0.
  [[nodiscard]] std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(next() % count);
  }

 private:
  std::uint64_t state_;
};

class DamagedWire {
 public:
  // Most bytes that can wait; check room() first.
  static constexpr std::size_t kHeldBytesMax = 16384;

  DamagedWire(const WireDamage& damage, std::uint64_t seed) : damage_(damage), random_(seed) {}

  // REQUIRES: bytes.size() <= room().
  void carry(std::span<const std::byte> bytes, Instant now);
  [[nodiscard]] std::size_t room() const;

  // Takes the bytes that have arrived; returns their number.
  [[nodiscard]] std::size_t take(std::span<std::byte> into, Instant now);
  // The bytes that have arrived, without taking them.
  [[nodiscard]] std::string_view arrived(Instant now) const;
  void drop(std::size_t count);

  // When the delayed bytes arrive; `now` or earlier if there are none.
  [[nodiscard]] Instant held_until() const { return held_until_; }
  [[nodiscard]] bool empty() const { return held_.empty(); }
  [[nodiscard]] std::int64_t damages() const { return damages_; }

 private:
  [[nodiscard]] bool happens(double probability);
  void carry_byte(char c, Instant now);
  void start_line(Instant now);

  WireDamage damage_;
  SplitMix random_;
  std::string held_;
  std::string line_;  // the current line, for doubling
  Instant held_until_{};
  std::size_t since_ = 10'000;
  std::int64_t damages_ = 0;
  bool swallowing_line_ = false;
  bool cut_next_line_ = false;
  Instant flipped_at_{};
  bool cutting_ = false;
};

}  // namespace firmware_link
