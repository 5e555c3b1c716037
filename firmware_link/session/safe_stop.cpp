#include "firmware_link/session/safe_stop.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "firmware_link/wire/check.h"
#include "firmware_link/wire/limits.h"  // kWindowBytesMax

namespace firmware_link {
namespace {

// A stop that waits is told after this.
constexpr Duration kTellAfter = std::chrono::seconds(2);

}  // namespace

void SafeStop::set_sequence(std::span<const Command> commands) {
  LINK_CHECK(commands.size() <= kSafeSequenceMax);
  count_ = commands.size();
  next_ = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    sizes_[i] = static_cast<std::uint8_t>(encode(commands[i], texts_[i]).size());
  }
}

void SafeStop::start(std::optional<std::string> behind, Instant now) {
  since_ = now;
  behind_ = std::move(behind);
  told_wait_ = false;
}

std::string_view SafeStop::take() {
  LINK_CHECK(!all_taken());
  return text(next_++);
}

void SafeStop::put_plain(OutputBuffer& output) const {
  output.put("\n");
  std::size_t bytes = 1;
  for (std::size_t i = 0; i < count_; ++i) {
    bytes += text(i).size() + 1;
    if (bytes > kWindowBytesMax) break;
    output.put(text(i));
    output.put("\n");
  }
  // Its answer tells that all before it was obeyed.
  output.put("M105\n");
}

void SafeStop::acknowledged(std::int64_t before, Instant now) {
  if (!behind_ || !start_ || before <= *start_) return;
  behind_.reset();
  since_ = now;
}

bool SafeStop::tells_wait(bool works, Instant now) {
  if (told_wait_ || !(behind_ || works) || now - since_ <= kTellAfter) return false;
  told_wait_ = true;
  return true;
}

std::optional<Duration> SafeStop::overdue(const SessionOptions& options, bool works,
                                          Instant planner_end, Instant now) const {
  const Duration taken = now - std::max(since_, std::min(planner_end, now));
  const Duration limit = behind_ || works ? options.long_stop_limit : options.stop_limit;
  if (taken <= limit) return std::nullopt;
  return taken;
}

void SafeStop::told(const Temperatures& temperatures) {
  if (!temperatures.nozzle_target_celsius) return;
  confirmed_ =
      *temperatures.nozzle_target_celsius <= 0 && temperatures.bed_target_celsius.value_or(0) <= 0;
}

}  // namespace firmware_link
