#include "host/output/output_file.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace fs = std::filesystem;
using host::OutputFile;

namespace {

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("rind_output_" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }
  [[nodiscard]] long count() const {
    return std::distance(fs::directory_iterator(path_), fs::directory_iterator{});
  }

 private:
  fs::path path_;
};

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("a file has its name only when it is whole") {
  const Folder folder;
  const std::string path = folder.file("out.gcode");
  const std::string long_text(200'000, 'x');
  {
    core::Result<OutputFile> file = OutputFile::open(path);
    REQUIRE(file.ok());
    REQUIRE(file.value().write("begin ").ok());
    REQUIRE(file.value().write(long_text).ok());
    CHECK_FALSE(fs::exists(path));
    REQUIRE(file.value().commit().ok());
  }
  CHECK_EQ(content(path), "begin " + long_text);
  CHECK_EQ(folder.count(), 1);
}

TEST_CASE("what is not committed leaves nothing, and an older file as it was") {
  const Folder folder;
  const std::string path = folder.file("out.gcode");
  std::ofstream(path) << "older";
  {
    core::Result<OutputFile> file = OutputFile::open(path);
    REQUIRE(file.ok());
    REQUIRE(file.value().write(std::string(200'000, 'x')).ok());
  }
  CHECK_EQ(content(path), "older");
  CHECK_EQ(folder.count(), 1);
}

TEST_CASE("a place that can't be written is told with its path and the cause") {
  const core::Result<OutputFile> file = OutputFile::open("/nowhere/at/all/out.gcode");
  REQUIRE_FALSE(file.ok());
  CAPTURE(file.error().message);
  CHECK_NE(file.error().message.find("/nowhere/at/all/out.gcode"), std::string::npos);
  CHECK_NE(file.error().message.find("No such file"), std::string::npos);
}

TEST_CASE("a full disk is told") {
  core::Result<OutputFile> file = OutputFile::open("/dev/full");
  REQUIRE(file.ok());
  core::Status status = file.value().write("one line\n");
  if (status.ok()) status = file.value().commit();
  REQUIRE_FALSE(status.ok());
  CHECK_NE(status.error().message.find("No space left"), std::string::npos);
}
