#include "firmware_link/session/silence_watch.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace firmware_link {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

// Questions without an answer: each takes room in a busy controller's receive ring. The time
// between them doubles from the third on.
constexpr int kAsksMax = 5;

// How long a command may take while it says that it is being worked at.
constexpr Duration kBusyMax = minutes(15);
constexpr Duration kUserMax = minutes(30 * 24 * 60);  // away for days

constexpr Duration kTellAfter = seconds(5);

std::string seconds_text(Duration duration) {
  return std::to_string(std::chrono::duration_cast<seconds>(duration).count()) + " s";
}

}  // namespace

SilenceWatch::Step SilenceWatch::look(const LinkRules& rules, const Sight& sight, Instant now) {
  if (head_ != sight.head) {
    head_ = sight.head;
    began_ = now;
    told_ = false;
  }
  const Duration busy_max =
      std::max({user_awaited_ ? kUserMax : kBusyMax, sight.command.limit, limit_});
  if (works_ && now - began_ > busy_max) {
    return give_up("the controller has been busy with " + what_of(sight) + " for " +
                   seconds_text(now - began_));
  }
  return sight.command.is_long() ? look_long(rules, sight, now) : look_prompt(rules, sight, now);
}

bool SilenceWatch::ask_due(Duration patience, const Sight& sight, Instant now) const {
  if (!sight.may_ask) return false;
  const Instant since = asks_ > 0 ? std::max(sight.last_progress, last_ask_) : sight.last_progress;
  return now - since > patience * (1 << std::max(0, asks_ - 1));
}

SilenceWatch::Step SilenceWatch::look_long(const LinkRules& rules, const Sight& sight,
                                           Instant now) {
  // One question waits behind it, so that the end is seen though its answer is lost; another
  // follows where that one's was lost, too.
  const bool first = sight.questions == 0 && now - began_ > rules.ask_after_idle;
  if (first && sight.may_ask) return Step::kAsk;
  const Duration again =
      rules.numbered ? rules.ask_after - rules.ask_after_idle : rules.ask_after_idle;
  if (sight.questions > 0 && ask_due(again, sight, now)) return Step::kAsk;
  // One that says when it is busy, and doesn't, has not got the command, or has ended it.
  // Temperatures come by themselves all the while.
  const bool says_busy = rules.numbered && worked_once_;
  if (says_busy) {
    const Instant since =
        asks_ > 0 ? std::max(sight.last_progress, last_ask_) : sight.last_progress;
    if (now - since > rules.silence_max) {
      if (sight.may_resynchronise) return Step::kResynchronise;
      return give_up("the controller does not answer any more, during " + what_of(sight));
    }
  }
  const Duration limit = says_busy ? rules.idle_talk_max : sight.command.limit;
  const Duration silent = now - std::max(sight.last_progress, began_);
  if (silent <= std::max(limit, limit_)) return Step::kWait;
  return give_up("the controller has not answered for " + seconds_text(silent) + ", during " +
                 what_of(sight));
}

SilenceWatch::Step SilenceWatch::look_prompt(const LinkRules& rules, const Sight& sight,
                                             Instant now) {
  const Duration silent = now - sight.last_life;
  if (silent > std::max(rules.silence_max, rules.numbered ? Duration(0) : limit_)) {
    if (sight.may_resynchronise) return Step::kResynchronise;
    return give_up("the controller has not answered for " + seconds_text(now - began_));
  }
  // Something talks, and no work shows: temperatures that come by themselves hide a lost `ok`.
  const Duration idle = now - std::max(sight.last_progress, began_);
  if (idle > std::max(rules.idle_talk_max + sight.planner_time, limit_)) {
    return give_up("the controller talks, but has not answered for " + seconds_text(idle));
  }
  // Asking does no harm. And a nozzle that stands on the part for want of an `ok` leaves a blob.
  const Duration patience = sight.stands && !works_ ? rules.ask_after_idle : rules.ask_after;
  return asks_ < kAsksMax && ask_due(patience, sight, now) ? Step::kAsk : Step::kWait;
}

bool SilenceWatch::tells_wait(const Sight& sight, Instant now) {
  if (told_ || head_ == kNothing || now - began_ < kTellAfter) return false;
  // A move may wait for room in the planner; that is no news.
  if (!sight.command.is_long() && asks_ < 2 && !(works_ && now - began_ > 3 * kTellAfter)) {
    return false;
  }
  told_ = true;
  return true;
}

std::string SilenceWatch::what_of(const Sight& sight) {
  const std::string word(word_of(sight.text));
  if (word.empty()) return "an answer";
  if (!sight.command.is_long()) return "an answer to " + word;
  return std::string(sight.command.what) + " (" + word + ")";
}

SilenceWatch::Step SilenceWatch::give_up(std::string why) {
  reason_ = std::move(why);
  return Step::kGiveUp;
}

}  // namespace firmware_link
