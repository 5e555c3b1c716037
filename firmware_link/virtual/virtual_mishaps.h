// What a test lets go wrong with the next command of a virtual controller, or with all that follow.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "firmware_link/wire/instant.h"  // Duration

namespace firmware_link {

class VirtualMishaps {
 public:
  // The next command with this word, any when it is empty, takes so much longer.
  void delay_next(Duration delay, std::string_view word) {
    delay_ = delay;
    delay_word_ = std::string(word);
  }
  // The `ok` to the next command with this word is lost; `instead` comes.
  void lose_answer(std::string_view word, std::string_view instead) {
    lose_word_ = std::string(word);
    instead_ = std::string(instead);
  }
  // It says nothing by itself while it works.
  void work_in_silence() { silent_ = true; }
  [[nodiscard]] bool silent() const { return silent_; }

  // A command with this word starts: how much longer it takes.
  [[nodiscard]] Duration starts(std::string_view word) {
    loses_ = lose_word_ && (lose_word_->empty() || word == *lose_word_);
    if (loses_) lose_word_.reset();
    if (delay_.count() <= 0 || !(delay_word_.empty() || word == delay_word_)) return Duration(0);
    return std::exchange(delay_, Duration(0));
  }
  // It ends: what is said instead of its `ok`; nullopt: the `ok` is not lost.
  [[nodiscard]] std::optional<std::string_view> ends() {
    if (!std::exchange(loses_, false)) return std::nullopt;
    return instead_;
  }

  void forget_delay() { delay_ = Duration(0); }

 private:
  Duration delay_{0};
  std::string delay_word_;
  std::optional<std::string> lose_word_;
  std::string instead_;
  bool loses_ = false;  // the answer to the command at hand
  bool silent_ = false;
};

}  // namespace firmware_link
