#include "tools/faults/damaged_wire.h"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

// Lines seen on real wires, and lines that look like answers.
constexpr std::string_view kNonsense[] = {
    "Resend: 34497\n", "Resend: \n",  "Resend: -3\n",  "Resend: 0\n",    "rs 99999999\n",
    "okay\n",          "o\n",         "k\n",           "\xff\xfe\x80\n", "echo:\n",
    "Error:\n",        "T:\n",        "wait\n",        "//\n",           "X:1e999 Y:nan\n",
    "Cap:\n",          "//action:\n", "Last Line: 7\n"};
constexpr std::size_t kLineKeptMax = 512;

}  // namespace

std::uint64_t SplitMix::next() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

std::size_t DamagedWire::room() const {
  // Doubled and inserted lines need more room than the input.
  const std::size_t used = 2 * held_.size();
  return used >= kHeldBytesMax ? 0 : (kHeldBytesMax - used) / 8;
}

bool DamagedWire::happens(double probability) {
  if (probability <= 0 || since_ < damage_.distance) return false;
  if (random_.share() >= probability) return false;
  since_ = 0;
  ++damages_;
  return true;
}

void DamagedWire::start_line(Instant now) {
  cutting_ = cut_next_line_ && now == flipped_at_;
  cut_next_line_ = false;
  if (happens(damage_.insert_line)) held_ += kNonsense[random_.below(std::size(kNonsense))];
  if (happens(damage_.delay_line)) {
    const auto delay = static_cast<Duration::rep>(random_.share() *
                                                  static_cast<double>(damage_.delay_max.count()));
    held_until_ = std::max(held_until_, now) + Duration(delay);
  }
  swallowing_line_ = happens(damage_.lose_line);
}

void DamagedWire::carry_byte(char c, Instant now) {
  if (line_.empty()) start_line(now);
  ++since_;
  if (line_.size() < kLineKeptMax) line_.push_back(c);
  if (cutting_) {
    // Up to the end of "N123".
    const bool number = line_.size() == 1 || (c >= '0' && c <= '9');
    if (number && c != '\n') return;
    cutting_ = false;
  }
  if (!swallowing_line_) {
    const bool end = c == '\n';
    const bool lost = happens(damage_.lose_byte) || (end && happens(damage_.lose_line_end));
    if (!lost) {
      char carried = c;
      if (!end && happens(damage_.cut_behind_number)) {
        carried = static_cast<char>(c ^ 1);
        cut_next_line_ = true;
        flipped_at_ = now;
      }
      if (happens(damage_.flip_byte)) carried = static_cast<char>(c ^ (1 << random_.below(7)));
      held_.push_back(carried);
      if (happens(damage_.double_byte)) held_.push_back(carried);
    }
    if (end && happens(damage_.double_line)) held_ += line_;
  }
  if (c == '\n') line_.clear();
}

void DamagedWire::carry(std::span<const std::byte> bytes, Instant now) {
  LINK_CHECK(bytes.size() <= room());
  for (const std::byte b : bytes) carry_byte(static_cast<char>(b), now);
}

std::string_view DamagedWire::arrived(Instant now) const {
  return held_until_ > now ? std::string_view() : std::string_view(held_);
}

void DamagedWire::drop(std::size_t count) { held_.erase(0, count); }

std::size_t DamagedWire::take(std::span<std::byte> into, Instant now) {
  const std::string_view there = arrived(now);
  const std::size_t count = std::min(there.size(), into.size());
  if (count > 0) std::memcpy(into.data(), there.data(), count);
  drop(count);
  return count;
}

}  // namespace firmware_link
