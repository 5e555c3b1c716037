// The count of lines that Marlin keeps: which numbered line it accepts.
#pragma once

#include <cstdint>
#include <string_view>

namespace firmware_link {

class VirtualLineNumbers {
 public:
  enum class Verdict {
    kAccepted,
    kSilent,  // dropped without a word
    kNumber,  // refused: another number is due
    kNoChecksum,
    kChecksum,  // refused: the checksum differs
  };

  // A line that starts with N. The number is looked at before the checksum. `silent_repeats`: the
  // last number and the one before it are met with silence.
  [[nodiscard]] Verdict check(std::string_view line, bool silent_repeats);

  [[nodiscard]] std::int64_t last() const { return last_; }
  void set_last(std::int64_t number) { last_ = number; }

 private:
  std::int64_t last_ = 0;
};

// What Marlin says of a refused line, before ", Last Line: ". REQUIRES: the line was refused.
[[nodiscard]] std::string_view words_of(VirtualLineNumbers::Verdict verdict);

}  // namespace firmware_link
