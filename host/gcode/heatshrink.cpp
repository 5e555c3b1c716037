#include "host/gcode/heatshrink.h"

#include <algorithm>
#include <cstdint>

namespace host {
namespace {

class Bits {
 public:
  explicit Bits(std::string_view bytes) : bytes_(bytes) {}

  // The next `count` bits, at most 16. REQUIRES: has(count).
  [[nodiscard]] std::uint32_t take(int count) {
    while (held_ < count) {
      value_ = value_ << 8 | static_cast<unsigned char>(bytes_[at_++]);
      held_ += 8;
    }
    held_ -= count;
    const std::uint32_t bits = value_ >> held_ & ((std::uint32_t{1} << count) - 1);
    value_ &= (std::uint32_t{1} << held_) - 1;
    return bits;
  }
  [[nodiscard]] bool has(int count) const {
    const std::size_t missing = static_cast<std::size_t>(std::max(0, count - held_) + 7) / 8;
    return bytes_.size() - at_ >= missing;
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::uint32_t value_ = 0;
  int held_ = 0;
};

}  // namespace

bool unpack_heatshrink(std::string_view packed, HeatshrinkForm form, std::size_t size,
                       std::string& into) {
  Bits bits(packed);
  const std::size_t start = into.size();
  const std::size_t end = start + size;
  while (into.size() < end) {
    if (!bits.has(1)) return false;
    if (bits.take(1) == 1) {
      if (!bits.has(8)) return false;
      into.push_back(static_cast<char>(bits.take(8)));
      continue;
    }
    if (!bits.has(form.window + form.lookahead)) return false;
    const std::size_t back = bits.take(form.window) + 1;
    std::size_t count = bits.take(form.lookahead) + 1;
    count = std::min(count, end - into.size());
    for (; count > 0; --count) {
      const std::size_t here = into.size();
      into.push_back(here - start >= back ? into[here - back] : '\0');
    }
  }
  return true;
}

}  // namespace host
