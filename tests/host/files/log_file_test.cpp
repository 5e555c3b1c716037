#include "host/files/log_file.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "host/system/limits.h"
#include "tests/support/temporary_folder.h"

TEST_CASE("a log is of bounded size, however much is written, and keeps the latest") {
  const test::TemporaryFolder folder;
  auto log = host::LogFile::open(folder.path("rind.log"));
  REQUIRE(log.ok());
  const std::string line(1'000, 'x');
  for (int i = 0; i < 5'000; ++i) log.value()->write(line + std::to_string(i));
  std::size_t files = 0, bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    ++files;
    bytes += entry.file_size();
  }
  CHECK_EQ(files, host::kLogFilesMax + 1);
  CHECK_LE(bytes, (host::kLogFilesMax + 1) * host::kLogBytesMax);
  CHECK_GT(bytes, host::kLogFilesMax * (host::kLogBytesMax - 2'000));
  std::ifstream file(folder.path("rind.log"), std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  CHECK_NE(text.find("x4999\n"), std::string::npos);
}

TEST_CASE("a log that can't be written is an error with its name") {
  const auto log = host::LogFile::open("/dev/null/rind.log");
  REQUIRE_FALSE(log.ok());
  CHECK_NE(log.error().message.find("/dev/null/rind.log"), std::string::npos);
}
