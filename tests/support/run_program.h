// Runs a command through the shell, usually rind, and keeps its output.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

namespace test {

struct ProgramRun {
  int exit_code = -1;  // 128 + signal if it was killed, as in shells
  std::string output;  // standard output and standard error together
};

inline ProgramRun run_program(const std::string& command) {
  ProgramRun run;
  FILE* pipe = popen(("( " + command + " ) 2>&1").c_str(), "r");
  if (pipe == nullptr) return run;
  std::array<char, 4096> buffer;
  std::size_t count = 0;
  while ((count = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0) {
    run.output.append(buffer.data(), count);
  }
  const int status = pclose(pipe);
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return run;
}

// Whether the program said that.
[[nodiscard]] inline bool says(const ProgramRun& run, const std::string& text) {
  return run.output.find(text) != std::string::npos;
}

// The program under test.
inline const std::string kRind = std::string(RIND_BINARY_DIR) + "/rind";

inline ProgramRun rind(const std::string& arguments) {
  return run_program(kRind + " " + arguments);
}

// A file's bytes; empty when it can't be read.
[[nodiscard]] inline std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace test
