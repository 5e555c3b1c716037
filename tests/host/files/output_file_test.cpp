#include "host/files/output_file.h"

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

TEST_CASE("what is not whole leaves nothing, where files need a name as well") {
  const Folder folder;
  const std::string path = folder.file("out.gcode");
  for (const auto unfinished :
       {OutputFile::Unfinished::kNameless, OutputFile::Unfinished::kNamed}) {
    {
      core::Result<OutputFile> file = OutputFile::open(path, unfinished);
      REQUIRE(file.ok());
      REQUIRE(file.value().write(std::string(100'000, 'x')).ok());
      CHECK_FALSE(fs::exists(path));
      CHECK_LE(folder.count(), 1);
    }
    CHECK_EQ(folder.count(), 0);
    for (const char* text : {"first", "second"}) {
      core::Result<OutputFile> file = OutputFile::open(path, unfinished);
      REQUIRE(file.ok());
      REQUIRE(file.value().write(text).ok());
      REQUIRE(file.value().commit().ok());
      CHECK_EQ(content(path), text);
      CHECK_EQ(folder.count(), 1);
    }
    fs::remove(path);
  }
}

TEST_CASE("of an older file mode and links to it stay") {
  const Folder folder;
  const std::string path = folder.file("real.gcode"), link = folder.file("link.gcode");
  const std::string hard = folder.file("hard.gcode");
  std::ofstream(path) << "older";
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.gcode", link);
  fs::create_hard_link(path, hard);
  core::Result<OutputFile> file = OutputFile::open(link);
  REQUIRE(file.ok());
  REQUIRE(file.value().write("newer").ok());
  REQUIRE(file.value().commit().ok());
  CHECK(fs::is_symlink(link));
  CHECK_EQ(content(path), "newer");
  CHECK_EQ(content(hard), "older");
  CHECK_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_CASE("a second writer of a name is refused, as long as the first one writes") {
  const Folder folder;
  const std::string path = folder.file("out.gcode");
  fs::create_symlink("out.gcode", folder.file("link.gcode"));
  {
    core::Result<OutputFile> first = OutputFile::open(path);
    REQUIRE(first.ok());
    for (const std::string& other : {path, folder.file("./out.gcode"), folder.file("link.gcode")}) {
      const core::Result<OutputFile> second = OutputFile::open(other);
      REQUIRE_FALSE(second.ok());
      CHECK_NE(second.error().message.find("another rind is writing it"), std::string::npos);
    }
    CHECK(OutputFile::open(folder.file("other.gcode")).ok());
  }
  CHECK(OutputFile::open(path).ok());
}

TEST_CASE("a file that somebody has made meanwhile is kept") {
  const Folder folder;
  const std::string path = folder.file("out.gcode");
  for (const auto unfinished :
       {OutputFile::Unfinished::kNameless, OutputFile::Unfinished::kNamed}) {
    core::Result<OutputFile> file = OutputFile::open(path, unfinished);
    REQUIRE(file.ok());
    REQUIRE(file.value().write("ours").ok());
    std::ofstream(path) << "theirs";
    CHECK_FALSE(file.value().commit().ok());
    CHECK_EQ(content(path), "theirs");
    fs::remove(path);
  }
}

TEST_CASE("folders, devices and other people's links are no places for a file") {
  const Folder folder;
  const auto refused = [](const std::string& path) { return !OutputFile::open(path).ok(); };
  CHECK(refused(folder.file("")));
  CHECK(refused("/dev/there_is_no_such_device"));
  if (fs::exists("/dev/mem")) CHECK(refused("/dev/mem"));
  CHECK_FALSE(refused("/dev/null"));
  // Links that lead in a circle, and to nothing: the latter is made.
  fs::create_symlink("b", folder.file("a"));
  fs::create_symlink("a", folder.file("b"));
  CHECK(refused(folder.file("a")));
  fs::create_symlink("made.gcode", folder.file("c"));
  {
    core::Result<OutputFile> file = OutputFile::open(folder.file("c"));
    REQUIRE(file.ok());
    REQUIRE(file.value().commit().ok());
  }
  CHECK(fs::exists(folder.file("made.gcode")));
  if (geteuid() != 0) return;  // only root can give links away
  fs::permissions(folder.file("."), fs::perms::all | fs::perms::sticky_bit);
  std::ofstream(folder.file("victim")) << "precious";
  fs::create_symlink("victim", folder.file("planted"));
  REQUIRE_EQ(::lchown(folder.file("planted").c_str(), 65'534, 65'534), 0);
  CHECK(refused(folder.file("planted")));
}
