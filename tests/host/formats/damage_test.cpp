// Each sample cut at every byte, and with every byte changed: read or refused, never a crash, an
// endless loop or more than the file can hold.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/format_samples.h"
#include "tests/support/mesh_files.h"
#include "tools/parts/part_maker.h"

namespace {

// A sample has a few slices or facets, and damage multiplies none of them by much.
constexpr std::size_t kMost = 1'000;

// Whoever refuses says which file, and something about it.
void check_outcome(const core::Result<test::ReadFile>& read) {
  if (read.ok()) return;
  CAPTURE(read.error().message);
  const bool named =
      read.error().message.starts_with("part: ") || read.error().message.starts_with("part (");
  CHECK(named);
  CHECK(read.error().message.size() > 20);
}

}  // namespace

TEST_CASE("the samples are fine") {
  for (const test::FormatSample& sample : test::format_samples()) {
    CAPTURE(sample.name);
    const auto read = test::read_bytes(sample.bytes, kMost);
    REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().message));
    CHECK(read.value().slices.size() + read.value().triangles.size() > 1);
  }
}

TEST_CASE("they are the fuzzers' first inputs") {
  const std::filesystem::path folder =
      std::filesystem::path(RIND_BINARY_DIR) / "tests" / "format_samples";
  std::filesystem::create_directories(folder);
  std::vector<test::FormatSample> seeds = test::format_samples();
  seeds.push_back({"mesh.model", test::threemf_model(parts::box({0, 0, 0}, 4, 3, 2))});
  seeds.push_back({"slices.model", test::sliced_threemf_model()});
  seeds.push_back({"roles.config", test::negative_volume_roles()});
  seeds.push_back(
      {"late.obj", "# C:\\a\\\nbevel on\nf 1 2 \\\n 3\nf 1 2\nv 0 0 0\nv 9 0 0 \\\n1\nv 0 9 1\n"});
  std::string list;
  for (const test::FormatSample& sample : seeds) {
    std::ofstream(folder / sample.name, std::ios::binary) << sample.bytes;
    CHECK_EQ(std::filesystem::file_size(folder / sample.name), sample.bytes.size());
    list += (list.empty() ? "" : ",") + (folder / sample.name).string();
  }
  std::ofstream(folder / "list") << list;
}

TEST_CASE("cut at every byte") {
  for (const test::FormatSample& sample : test::format_samples()) {
    CAPTURE(sample.name);
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      CAPTURE(size);
      check_outcome(test::read_bytes(sample.bytes.substr(0, size), kMost));
    }
  }
}

TEST_CASE("every byte changed") {
  for (const test::FormatSample& sample : test::format_samples()) {
    CAPTURE(sample.name);
    std::string bytes = sample.bytes;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      CAPTURE(i);
      for (const char flip : {'\x01', '\x90'}) {
        const char was = bytes[i];
        bytes[i] = static_cast<char>(was ^ flip);
        check_outcome(test::read_bytes(bytes, kMost));
        bytes[i] = was;
      }
    }
  }
}

TEST_CASE("bytes taken out, and there twice") {
  for (const test::FormatSample& sample : test::format_samples()) {
    CAPTURE(sample.name);
    for (std::size_t i = 0; i < sample.bytes.size(); ++i) {
      CAPTURE(i);
      std::string bytes = sample.bytes;
      bytes.erase(i, 1);
      check_outcome(test::read_bytes(bytes, kMost));
      bytes = sample.bytes;
      bytes.insert(i, 1, bytes[i]);
      check_outcome(test::read_bytes(bytes, kMost));
    }
  }
}
