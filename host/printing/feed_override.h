// Feed and flow in percent of what was sliced: what the user asks for, and what geometry can follow
// (underrun_watch.h).
//
//     feed = requested × throttle × file's        flow = requested × file's
//
// each within kFeedPercentMin … kFeedPercentMax. A ready file sets its own (M220, M221), so do
// the user's lines; else 100.
#pragma once

#include <algorithm>
#include <optional>

#include "host/system/limits.h"

namespace host {

class FeedOverride {
 public:
  // By so many steps of kFeedPercentStep; negative: less.
  void change_feed(int steps) { change(requested_feed_, steps); }
  void change_flow(int steps) { change(requested_flow_, steps); }
  void set_throttle(int percent) { throttle_ = percent; }

  [[nodiscard]] int requested_feed() const { return requested_feed_; }
  [[nodiscard]] int requested_flow() const { return requested_flow_; }
  [[nodiscard]] int throttle() const { return throttle_; }

  // What the controller was told; 100 before.
  [[nodiscard]] int told_feed() const { return told_feed_; }

  // The file's own line has told the controller.
  void file_set_feed(int percent) { file_feed_ = told_feed_ = percent; }
  void file_set_flow(int percent) { file_flow_ = percent; }

  [[nodiscard]] int flow_to_tell() const {
    return std::clamp(requested_flow_ * file_flow_ / 100, kFeedPercentMin, kFeedPercentMax);
  }

  // What the controller has to be told; nothing: it knows. Counts as told then.
  [[nodiscard]] std::optional<int> feed_to_tell() {
    const int wanted = requested_feed_ * throttle_ / 100;
    // What the file says by itself may be any percentage.
    const int percent =
        wanted == 100 ? file_feed_
                      : std::clamp(wanted * file_feed_ / 100, kFeedPercentMin, kFeedPercentMax);
    if (percent == told_feed_) return std::nullopt;
    told_feed_ = percent;
    return percent;
  }

  // A new session was told nothing but what the file has set up.
  void start_session() { told_feed_ = file_feed_; }

 private:
  static void change(int& percent, int steps) {
    percent = std::clamp(percent + steps * kFeedPercentStep, kFeedPercentMin, kFeedPercentMax);
  }

  int requested_feed_ = 100;
  int requested_flow_ = 100;
  int throttle_ = 100;
  int told_feed_ = 100;
  int file_feed_ = 100;
  int file_flow_ = 100;
};

}  // namespace host
