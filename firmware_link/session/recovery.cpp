#include "firmware_link/session/recovery.h"

#include <utility>

namespace firmware_link {
namespace {

// So many of the lines asked for again are worth a warning, once so many were sent.
constexpr double kResendRatioMax = 0.1;
constexpr std::int64_t kResendLinesMin = 100;

// Forced mismatches in a row without the `Resend:` that answers them: so many don't get lost.
constexpr int kMismatchesMax = 16;

}  // namespace

bool Recovery::skips_ok(Instant now) {
  if (quiet_) quiet_since_ = now;
  return std::exchange(skip_next_ok_, false);
}

Recovery::Doubt Recovery::doubt(std::optional<std::int64_t> number) {
  if (number && accounts_.impossible(*number)) return Doubt::kCounterJumped;
  return accounts_.ask_again() && !quiet_ ? Doubt::kAskAgain : Doubt::kIgnore;
}

void Recovery::account_told(bool all_there) {
  accounts_.possible();
  confirmed_ = all_there;
  mismatches_ = 0;
  if (all_there) resynchronisations_in_a_row_ = 0;
}

bool Recovery::repeats(std::int64_t sequence, int repeats_max) {
  if (sequence > repeated_line_) {
    repeated_line_ = sequence;
    repeats_of_a_line_ = 0;
  }
  if (++repeats_of_a_line_ > repeats_max) return false;
  calm_lines_.refused(sequence);
  return true;
}

bool Recovery::tells_frequent(std::int64_t lines_sent, double resend_ratio) {
  if (told_frequent_ || lines_sent < kResendLinesMin || resend_ratio < kResendRatioMax) {
    return false;
  }
  told_frequent_ = true;
  return true;
}

bool Recovery::quiet_over(Duration quiet, bool all_written, Instant now) {
  if (!quiet_ || !all_written || now - quiet_since_ < quiet) return false;
  quiet_ = false;
  return true;
}

bool Recovery::asks() {
  if (++mismatches_ > kMismatchesMax) return false;
  asked_ = true;
  return true;
}

}  // namespace firmware_link
