// A program that runs beside the test, to send it signals and read its output.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/check.h"  // RIND_CHECK

namespace test {

class RunningProgram {
 public:
  // The first word is its path. Its standard input is an open pipe without data.
  explicit RunningProgram(const std::vector<std::string>& words) {
    std::array<int, 2> in{}, out{};
    RIND_CHECK(::pipe2(in.data(), O_CLOEXEC) == 0 && ::pipe2(out.data(), O_CLOEXEC) == 0);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out[1], STDERR_FILENO);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    RIND_CHECK(
        ::posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), environ) == 0);
    posix_spawn_file_actions_destroy(&actions);
    ::close(in[0]);
    ::close(out[1]);
    input_ = in[1];
    output_ = out[0];
  }
  ~RunningProgram() {
    if (process_ > 0) {
      ::kill(process_, SIGKILL);
      (void)::waitpid(process_, nullptr, 0);
    }
    ::close(input_);
    ::close(output_);
  }
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  // Waits until it has written that; false if it ended before, or the time is over.
  [[nodiscard]] bool wait_for(const std::string& words, double limit_s) {
    const double until_s = now_s() + limit_s;
    while (said_.find(words) == std::string::npos) {
      if (!read_more(until_s - now_s())) return false;
    }
    return true;
  }

  void tell(int signal) const { ::kill(process_, signal); }

  // Its exit code, 128 + signal if it was killed; nullopt if it still runs when the time is over.
  [[nodiscard]] std::optional<int> end(double limit_s) {
    const double until_s = now_s() + limit_s;
    while (now_s() < until_s) {
      if (!read_more(until_s - now_s())) break;  // closed: it ends, or has ended
    }
    int status = 0;
    while (::waitpid(process_, &status, WNOHANG) == 0) {
      if (now_s() > until_s) return std::nullopt;
      pause(0.002);
    }
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  [[nodiscard]] const std::string& said() const { return said_; }

  static double now_s() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
  }
  static void pause(double seconds) {
    const timespec time{0, static_cast<long>(seconds * 1e9)};
    (void)::nanosleep(&time, nullptr);
  }

 private:
  bool read_more(double limit_s) {
    pollfd ready{output_, POLLIN, 0};
    if (limit_s <= 0 || ::poll(&ready, 1, static_cast<int>(limit_s * 1e3)) <= 0) return false;
    std::array<char, 4'096> bytes{};
    const ssize_t count = ::read(output_, bytes.data(), bytes.size());
    if (count <= 0) return false;
    said_.append(bytes.data(), static_cast<std::size_t>(count));
    return true;
  }

  pid_t process_ = 0;
  int input_ = -1;
  int output_ = -1;
  std::string said_;
};

}  // namespace test
