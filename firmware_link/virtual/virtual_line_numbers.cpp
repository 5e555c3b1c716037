#include "firmware_link/virtual/virtual_line_numbers.h"

#include <charconv>

#include "firmware_link/wire/line_codec.h"  // checksum_of

namespace firmware_link {
namespace {

// As strtol reads: blanks, a sign, digits; 0 when there are none.
std::int64_t leading_integer(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  std::int32_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

VirtualLineNumbers::Verdict VirtualLineNumbers::check(std::string_view line, bool silent_repeats) {
  std::size_t number_at = 0;
  const bool sets_number = line.find("M110") != std::string_view::npos;
  if (sets_number) {
    const std::size_t second = line.find('N', 4);
    if (second != std::string_view::npos) number_at = second;
  }
  const std::int64_t number = leading_integer(line.substr(number_at + 1));
  if (number != last_ + 1 && !sets_number) {
    const bool repeat = number >= last_ - 1 && number <= last_;
    return silent_repeats && repeat ? Verdict::kSilent : Verdict::kNumber;
  }
  const std::size_t star = line.rfind('*');
  if (star == std::string_view::npos) return Verdict::kNoChecksum;
  if (leading_integer(line.substr(star + 1)) != checksum_of(line.substr(0, star))) {
    return Verdict::kChecksum;
  }
  last_ = number;
  return Verdict::kAccepted;
}

std::string_view words_of(VirtualLineNumbers::Verdict verdict) {
  switch (verdict) {
    case VirtualLineNumbers::Verdict::kNumber:
      return "Line Number is not Last Line Number+1";
    case VirtualLineNumbers::Verdict::kNoChecksum:
      return "No Checksum with line number";
    case VirtualLineNumbers::Verdict::kChecksum:
      return "checksum mismatch";
    case VirtualLineNumbers::Verdict::kAccepted:
    case VirtualLineNumbers::Verdict::kSilent:
      break;
  }
  return {};
}

}  // namespace firmware_link
