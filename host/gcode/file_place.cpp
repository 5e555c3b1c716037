#include "host/gcode/file_place.h"

#include <bit>
#include <cstddef>

#include "core/check.h"
#include "host/gcode/set_up_lines.h"  // kSetUpBytesMax

namespace host {
namespace {

constexpr std::size_t kNumbers = 28;
static_assert(kNumbers * 8 + kSetUpBytesMax <= kPlaceBytesMax);

// Writes or reads 8 bytes a value, lowest first.
class Numbers {
 public:
  explicit Numbers(std::string_view read) : read_(read) {}
  Numbers() : writes_(true) {}

  template <typename Number>
  void pass(Number& value) {
    const std::uint64_t now = next(static_cast<std::uint64_t>(value));
    if (!writes_) value = static_cast<Number>(now);
  }
  void pass(double& value) {
    const std::uint64_t now = next(std::bit_cast<std::uint64_t>(value));
    if (!writes_) value = std::bit_cast<double>(now);
  }
  void pass(std::optional<std::int64_t>& value) {
    bool known = value.has_value();
    std::int64_t number = value.value_or(0);
    pass(known);
    pass(number);
    if (!writes_) value = known ? std::optional(number) : std::nullopt;
  }
  [[nodiscard]] std::string& written() { return written_; }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  std::uint64_t next(std::uint64_t value) {
    ++count_;
    if (writes_) {
      for (int i = 0; i < 8; ++i) written_.push_back(static_cast<char>(value >> (8 * i) & 0xff));
      return value;
    }
    std::uint64_t found = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      found |= static_cast<std::uint64_t>(static_cast<unsigned char>(read_[i])) << (8 * i);
    }
    read_.remove_prefix(8);
    return found;
  }

  bool writes_ = false;
  std::string_view read_;
  std::string written_;
  std::size_t count_ = 0;
};

// Both ways, so that what is written is what is read.
void pass_all(Numbers& numbers, FilePlace& place) {
  numbers.pass(place.text.block);
  numbers.pass(place.text.within);
  numbers.pass(place.lines);
  numbers.pass(place.commands);
  GcodeModes& modes = place.modes;
  numbers.pass(modes.x_um);
  numbers.pass(modes.y_um);
  numbers.pass(modes.z_um);
  numbers.pass(modes.f_mm_min);
  numbers.pass(modes.e_count_10nm);
  numbers.pass(modes.drawn_back_10nm);
  numbers.pass(modes.highest_laid_um);
  numbers.pass(modes.nozzle_tenths);
  numbers.pass(modes.bed_tenths);
  numbers.pass(modes.fan);
  numbers.pass(modes.modes);
  numbers.pass(modes.tool);
  numbers.pass(modes.feed_percent);
  numbers.pass(modes.flow_percent);
  int flags = (modes.shifted ? 1 : 0) | (modes.road_laid ? 2 : 0) |
              (modes.filament_mode_unclear ? 4 : 0) | (place.set_up_whole ? 8 : 0);
  numbers.pass(flags);
  modes.shifted = (flags & 1) != 0;
  modes.road_laid = (flags & 2) != 0;
  modes.filament_mode_unclear = (flags & 4) != 0;
  place.set_up_whole = (flags & 8) != 0;
  numbers.pass(place.layer);
  numbers.pass(place.top_um);
  numbers.pass(place.filament_mm);
  numbers.pass(place.seconds);
  RIND_CHECK(numbers.count() <= kNumbers);
}

}  // namespace

std::string bytes_of(const FilePlace& place) {
  Numbers numbers;
  FilePlace copy = place;
  pass_all(numbers, copy);
  numbers.written().resize(kNumbers * 8, '\0');
  RIND_CHECK(place.set_up.size() <= kSetUpBytesMax);
  return numbers.written() + place.set_up;
}

std::optional<FilePlace> place_of(std::string_view bytes) {
  if (bytes.size() < kNumbers * 8 || bytes.size() > kPlaceBytesMax) return std::nullopt;
  Numbers numbers(bytes);
  FilePlace place;
  pass_all(numbers, place);
  place.set_up = std::string(bytes.substr(kNumbers * 8));
  return place;
}

}  // namespace host
