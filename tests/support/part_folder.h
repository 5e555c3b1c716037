// A folder for one test, with parts as files in it; deleted at the end.
#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>

#include "tools/parts/part_maker.h"

namespace test {

class PartFolder {
 public:
  PartFolder() {
    static std::atomic<int> count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("rind_test_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~PartFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;

  // Paths are for programs: absolute.
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

  [[nodiscard]] std::string add(const std::string& name, const parts::Part& part) const {
    std::ofstream out(file(name), std::ios::binary);
    parts::write_binary_stl(part, out);
    return file(name);
  }

  [[nodiscard]] std::string add_text(const std::string& name, const std::string& text) const {
    std::ofstream(file(name), std::ios::binary) << text;
    return file(name);
  }

 private:
  std::filesystem::path path_;
};

}  // namespace test
