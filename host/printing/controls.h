// What a user may request of a running print, and where requests come from: keys, where standard
// input is a terminal, and signals.
//
//     p pause   r resume   s stop   + - feed   > < flow   ? which keys there are
//     SIGUSR1   pause, or resume
//
// Keys are read at once, without an end of line, and are not shown. The terminal gets its own mode
// back when the object is destroyed, and while a question is asked.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

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

  [[nodiscard]] bool has_keys() const { return terminal_ != nullptr; }

  // Asks a person; nothing when there is none, when input ends, or `given_up` says so.
  [[nodiscard]] std::optional<std::string> ask(const std::string& question,
                                               const std::function<bool()>& given_up);

 private:
  struct Terminal;
  std::unique_ptr<Terminal> terminal_;  // null: none to read
  int toggles_seen_ = 0;
};

}  // namespace host
