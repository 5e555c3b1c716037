#include "host/files/spill_file.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "host/system/memory_budget.h"

using host::SpillFile;

namespace {

constexpr host::SpillUse kUse{"a test", "name another folder"};
constexpr std::int64_t kBlock = 1 << 20;

std::int64_t resident_bytes() {
  std::ifstream pages("/proc/self/statm");
  std::int64_t total = 0, resident = 0;
  pages >> total >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

// Blocks that are written before one is refused, 8 at most; the refusal's text.
struct Filled {
  int blocks = 0;
  std::string refusal;
};

Filled fill(SpillFile& file) {
  const std::string block(static_cast<std::size_t>(kBlock), 'x');
  Filled filled;
  while (filled.blocks < 8) {
    const core::Status written = file.append(block);
    if (!written.ok()) {
      CHECK(written.error().code == core::ErrorCode::kNoMemory);
      filled.refusal = written.error().message;
      break;
    }
    ++filled.blocks;
  }
  return filled;
}

}  // namespace

// /dev/shm is kept in memory wherever there is one.
TEST_CASE("a file in memory counts against the memory limit, until it is closed") {
  for (int round = 0; round < 3; ++round) {
    CAPTURE(round);
    core::Result<SpillFile> file = SpillFile::create("/dev/shm", kUse);
    REQUIRE(file.ok());
    REQUIRE(file.value().in_memory());
    host::set_memory_limit(resident_bytes() + 4 * kBlock + kBlock / 2);
    const Filled filled = fill(file.value());
    CHECK_EQ(filled.blocks, 4);
    CHECK_EQ(file.value().size(), 4 * kBlock);
    CHECK_NE(filled.refusal.find("/dev/shm is kept in memory"), std::string::npos);
    CHECK_NE(filled.refusal.find("name another folder"), std::string::npos);
  }
}

TEST_CASE("a file on a disk does not count") {
  core::Result<SpillFile> file = SpillFile::create("/var/tmp", kUse);
  REQUIRE(file.ok());
  if (file.value().in_memory()) return;  // then it is no disk
  host::set_memory_limit(1);
  CHECK_EQ(fill(file.value()).blocks, 8);
  host::set_memory_limit(0);
}
