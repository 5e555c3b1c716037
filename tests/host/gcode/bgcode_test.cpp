// Binary G-code: what a writer of the tests' own wrote is read, in every form; damage is noticed.
#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

#include "host/gcode/bgcode_text.h"
#include "host/gcode/heatshrink.h"
#include "host/gcode/ready_file.h"
#include "host/gcode/ready_reader.h"
#include "tests/support/bgcode_file.h"
#include "tests/support/part_folder.h"

using test::BgcodeForm;
using test::PartFolder;

namespace {

std::string some_gcode(std::mt19937_64& random) {
  std::string text = "M104 S200\nG28\nG90\nM83\nG1 X1 Y2 Z.2 F1200\n;LAYER_CHANGE\n";
  for (int i = 0; i < 600; ++i) {
    switch (random() % 9) {
      case 0:
        text += "M106 S" + std::to_string(random() % 256) + "\n";
        break;
      case 1:
        text += "; a comment, gr\xC3\xBC\xC3\x9F\n";
        break;
      case 2:
        text += "M117 Layer 5\n";
        break;
      default:
        text += "G1 X" + std::to_string(random() % 200) + "." + std::to_string(random() % 1'000) +
                " Y-" + std::to_string(random() % 9) + " E." + std::to_string(10 + random() % 90) +
                "\n";
    }
  }
  return text + "M104 S0\n";
}

std::vector<std::string> words_of(host::GcodeText& text) {
  std::vector<std::string> words;
  host::ReadyReader reader(text, {}, true);
  while (true) {
    const auto read = reader.next();
    if (!read.ok()) FAIL(read.error().message);
    if (!read.value()) return words;
    words.emplace_back(read.value()->meaning.line.words.text());
  }
}

host::FileBytes bytes_of(const PartFolder& folder, const std::string& bytes) {
  auto opened = host::FileBytes::open(folder.add_text("x.bgcode", bytes));
  if (!opened.ok()) FAIL(opened.error().message);
  return std::move(opened).value();
}

std::string why_not(const PartFolder& folder, const std::string& bytes) {
  host::ReadyFile file(bytes_of(folder, bytes), true);
  const core::Status status = file.scan({}, {});
  return status.ok() ? "" : status.error().message;
}

}  // namespace

TEST_CASE("heatshrink unpacks what was packed, and never reads beyond") {
  const std::uint64_t seed = std::random_device()();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 200; ++i) {
    std::string bytes;
    for (std::size_t n = random() % 3'000; n > 0; --n) {
      bytes.push_back("abcde"[random() % (1 + random() % 5)]);
    }
    const int window = 11 + static_cast<int>(random() % 2);
    const std::string packed = test::heatshrunk(bytes, window, 4);
    std::string unpacked;
    CHECK(host::unpack_heatshrink(packed, {window, 4}, bytes.size(), unpacked));
    CHECK_EQ(unpacked, bytes);
    std::string cut;
    const std::string shorter = packed.substr(0, packed.size() / 2);
    const bool whole = host::unpack_heatshrink(shorter, {window, 4}, bytes.size(), cut);
    CHECK_EQ(whole, bytes.size() <= cut.size() && packed.size() < 2);
  }
}

TEST_CASE("each form holds the same commands") {
  const PartFolder folder;
  const std::uint64_t seed = std::random_device()();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const std::string text = some_gcode(random);
  const host::FileBytes plain = bytes_of(folder, text);
  const std::vector<std::string> wanted = words_of(*host::plain_text(plain));
  REQUIRE_GT(wanted.size(), 300);
  for (int compression = 0; compression < 4; ++compression) {
    for (int encoding = 0; encoding < 3; ++encoding) {
      for (const bool sums : {false, true}) {
        CAPTURE(compression);
        CAPTURE(encoding);
        // Lines that go on in the next block: MeatPack starts anew there.
        const bool cuts = encoding == 0 && random() % 2 == 0;
        const BgcodeForm form{compression, encoding, sums, 300 + random() % 3'000, cuts};
        const PartFolder own;
        host::ReadyFile file(bytes_of(own, test::bgcode_of(text, form)), true);
        const core::Status scanned = file.scan({}, {});
        if (!scanned.ok()) FAIL(scanned.error().message);
        CHECK_EQ(file.summary().told_s, 3'723);
        CHECK_EQ(words_of(*file.text()), wanted);
        CHECK_EQ(file.summary().content.bytes, file.size());
      }
    }
  }
}

TEST_CASE("reading goes on within a block") {
  const PartFolder folder;
  const std::uint64_t seed = std::random_device()();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const std::string text = some_gcode(random);
  for (const int encoding : {0, 1}) {
    BgcodeForm form;
    form.encoding = encoding;
    form.cuts_lines = encoding == 0;
    const host::FileBytes bytes = bytes_of(folder, test::bgcode_of(text, form));
    const std::vector<std::string> wanted = words_of(*host::bgcode_text(bytes));
    const auto whole = host::bgcode_text(bytes);
    host::ReadyReader reader(*whole, {}, true);
    for (std::size_t n = 0; n < wanted.size(); ++n) {
      REQUIRE(reader.next().ok());
      if (n % 17 != 0) continue;
      const host::FilePlace place = reader.before();
      const auto again = host::bgcode_text(bytes);
      REQUIRE(again->go_to(place.text).ok());
      host::ReadyReader rest(*again, {}, true, place);
      for (std::size_t i = n; i < std::min(wanted.size(), n + 40); ++i) {
        const auto read = rest.next();
        REQUIRE(read.ok());
        REQUIRE_EQ(std::string(read.value()->meaning.line.words.text()), wanted[i]);
      }
    }
  }
}

TEST_CASE("damage anywhere is noticed before anything is printed") {
  const PartFolder folder;
  const std::uint64_t seed = std::random_device()();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const std::string file = test::bgcode_of(some_gcode(random), {});
  for (int i = 0; i < 200; ++i) {
    std::string damaged = file;
    const std::size_t at = random() % file.size();
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 8));
    CAPTURE(at);
    CHECK_NE(why_not(folder, damaged), "");
    // In its last block: cut between two, it would be a whole file.
    CHECK_NE(why_not(folder, file.substr(0, file.size() - 1 - random() % 30)), "");
  }
  CHECK_EQ(why_not(folder, file), "");
}

TEST_CASE("what is too long, or not known, is refused by its block") {
  const PartFolder folder;
  const std::string head = "GCDE" + test::low_first(1, 4) + test::low_first(0, 2);
  const std::string huge = head + test::low_first(1, 2) + test::low_first(0, 2) +
                           test::low_first(std::uint64_t{1} << 30, 4) + test::low_first(0, 2);
  CHECK_NE(why_not(folder, huge).find("block 1, byte 10: a block of 1073741824 bytes"),
           std::string::npos);
  const std::string bomb = head + test::low_first(1, 2) + test::low_first(3, 2) +
                           test::low_first(std::uint64_t{1} << 31, 4) + test::low_first(9, 4);
  CHECK_NE(why_not(folder, bomb + std::string(20, 'x')).find("are not read"), std::string::npos);
  CHECK_NE(
      why_not(folder, "GCDE" + test::low_first(2, 4) + test::low_first(0, 2)).find("version 2"),
      std::string::npos);
  CHECK_NE(why_not(folder, head + test::low_first(7, 2) + std::string(6, '\0')).find("kind 7"),
           std::string::npos);
}
