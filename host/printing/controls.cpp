#include "host/printing/controls.h"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>

#include "host/system/stop_signals.h"  // pause_signal_count

namespace host {
namespace {

// One that belongs to somebody else's foreground job may be neither read nor set.
bool own_terminal() { return isatty(STDIN_FILENO) == 1 && tcgetpgrp(STDIN_FILENO) == getpgrp(); }

bool readable(int wait_ms) {
  pollfd wait{};
  wait.fd = STDIN_FILENO;
  wait.events = POLLIN;
  return ::poll(&wait, 1, wait_ms) > 0 && (wait.revents & (POLLIN | POLLHUP)) != 0;
}

}  // namespace

std::optional<UserRequest> request_of_key(char key) {
  switch (key) {
    case 'p':
      return UserRequest::kPause;
    case 'r':
      return UserRequest::kResume;
    case ' ':
      return UserRequest::kToggle;
    case 's':
      return UserRequest::kStop;
    case '+':
      return UserRequest::kFeedUp;
    case '-':
      return UserRequest::kFeedDown;
    case '>':
      return UserRequest::kFlowUp;
    case '<':
      return UserRequest::kFlowDown;
    case 'x':
      return UserRequest::kObjects;
    case '?':
    case 'h':
      return UserRequest::kHelp;
    default:
      return std::nullopt;
  }
}

std::string key_help() {
  return "keys: p pause, r resume, s stop, + - feed, > < flow, x cancel an object, ? this line";
}

// The terminal's mode while keys are read.
struct Controls::Terminal {
  termios before{};
  bool raw = false;

  void set_raw() {
    if (raw || ::tcgetattr(STDIN_FILENO, &before) != 0) return;
    termios keys = before;
    // Ctrl-C and its like stay signals.
    keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    keys.c_cc[VMIN] = 0;
    keys.c_cc[VTIME] = 0;
    raw = ::tcsetattr(STDIN_FILENO, TCSANOW, &keys) == 0;
  }

  void set_back() {
    if (raw) (void)::tcsetattr(STDIN_FILENO, TCSANOW, &before);
    raw = false;
  }
};

Controls::Controls(bool keys) : toggles_seen_(pause_signal_count()) {
  if (!keys || !own_terminal()) return;
  terminal_ = std::make_unique<Terminal>();
  terminal_->set_raw();
}

Controls::~Controls() {
  if (terminal_) terminal_->set_back();
}

std::optional<UserRequest> Controls::next() {
  if (toggles_seen_ != pause_signal_count()) {
    ++toggles_seen_;
    return UserRequest::kToggle;
  }
  if (!terminal_ || !own_terminal()) return std::nullopt;
  char key = 0;
  while (readable(0) && ::read(STDIN_FILENO, &key, 1) == 1) {
    if (typed_) {
      take_digit(key);
      continue;
    }
    const std::optional<UserRequest> request = request_of_key(key);
    if (request == UserRequest::kObjects) typed_.emplace();
    if (request) return request;
  }
  return std::nullopt;
}

// Enter ends the number; any other key than a digit gives it up.
void Controls::take_digit(char key) {
  constexpr std::size_t kDigitsMax = 6;
  if (key >= '0' && key <= '9' && typed_->size() < kDigitsMax) {
    *typed_ += key;
    return;
  }
  if (key == '\n' && !typed_->empty()) cancelled_ = std::stoi(*typed_);
  typed_.reset();
}

std::optional<std::string> Controls::ask(const std::string& question,
                                         const std::function<bool()>& given_up) {
  if (!own_terminal()) return std::nullopt;
  if (terminal_) terminal_->set_back();
  std::fprintf(stderr, "%s ", question.c_str());
  std::fflush(stderr);
  std::string line;
  std::optional<std::string> answer;
  while (!answer && !given_up()) {
    if (!readable(100)) continue;
    char letter = 0;
    if (::read(STDIN_FILENO, &letter, 1) != 1) break;
    if (letter == '\n') {
      answer = line;
    } else if (line.size() < 200) {
      line += letter;
    }
  }
  if (!answer) std::fputc('\n', stderr);
  if (terminal_) terminal_->set_raw();
  return answer;
}

}  // namespace host
