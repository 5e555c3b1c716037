// What a user may request of a running print, and where requests come from: keys, where standard
// input is a terminal, and signals.
//
//     p pause   r resume   s stop   + - feed   > < flow   ? which keys there are
//     x 3 Enter   cancel object 3
//     SIGUSR1   pause, or resume
//
// Keys are read at once, without an end of line, and are not shown. The terminal gets its own mode
// back when the object is destroyed, and while a question is asked.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace host {

enum class UserRequest {
  kPause,
  kResume,
  kToggle,
  kStop,
  kFeedUp,
  kFeedDown,
  kFlowUp,
  kFlowDown,
  kObjects,  // which objects there are; the number of one of them is typed now
  kHelp,
};

// Nothing: the key means nothing.
[[nodiscard]] std::optional<UserRequest> request_of_key(char key);

// What the keys are, in one line.
[[nodiscard]] std::string key_help();

class Controls {
 public:
  // `keys`: whether to read the keyboard, where there is one.
  explicit Controls(bool keys);
  ~Controls();
  Controls(const Controls&) = delete;
  Controls& operator=(const Controls&) = delete;

  // The oldest request that nobody took; never waits.
  [[nodiscard]] std::optional<UserRequest> next();

  // The number of an object that somebody has typed, and that nobody took. The first is 1.
  [[nodiscard]] std::optional<int> next_cancelled() { return std::exchange(cancelled_, {}); }

  [[nodiscard]] bool has_keys() const { return terminal_ != nullptr; }

  // Asks a person; nothing when there is none, when input ends, or `given_up` says so.
  [[nodiscard]] std::optional<std::string> ask(const std::string& question,
                                               const std::function<bool()>& given_up);

 private:
  void take_digit(char key);

  struct Terminal;
  std::unique_ptr<Terminal> terminal_;  // null: none to read
  int toggles_seen_ = 0;
  std::optional<std::string> typed_;  // digits of a number, behind an x
  std::optional<int> cancelled_;
};

}  // namespace host
