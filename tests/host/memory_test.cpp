// The program under limits of memory and disk.
#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/marked_files.h"
#include "tests/support/part_folder.h"
#include "tests/support/run_program.h"

using test::kRind;
using test::PartFolder;
using test::ProgramRun;
using test::says;

namespace {

// Sanitizers need memory of their own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif

ProgramRun run(const std::string& command) { return test::run_program(command); }

std::int64_t peak_rss(const PartFolder& folder, const std::string& part,
                      const std::string& arguments) {
  const std::string stats = folder.file("stats.json");
  // Otherwise malloc keeps the more of what was freed the larger it was (M_MMAP_THRESHOLD), so that
  // the peak is a matter of chance.
  const ProgramRun outcome = run("MALLOC_TRIM_THRESHOLD_=131072 " + kRind + " slice " + part +
                                 " -o /dev/null --quiet --stats " + stats + " " + arguments);
  CAPTURE(outcome.output);
  REQUIRE_EQ(outcome.exit_code, 0);
  std::ifstream file(stats);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return nlohmann::json::parse(text)["peak_rss_bytes"];
}

// Freed memory is kept back by the sanitizers. How threads meet may change a peak by a megabyte;
// what grows with the height does so each time.
void check_same_peak(const PartFolder& folder, const std::string& low_part,
                     const std::string& high_part, const std::string& arguments) {
  std::int64_t low = 0, high = 0;
  for (int attempt = 0; attempt < 3; ++attempt) {
    low = peak_rss(folder, low_part, arguments);
    high = peak_rss(folder, high_part, arguments);
    if (high - low < 1'000'000) break;
  }
  CAPTURE(low);
  CAPTURE(high);
  if (!kSanitized) CHECK_LT(high - low, 1'000'000);
}

parts::Part slim_tower(std::int64_t layers) {
  parts::TowerSize size;
  size.layers = layers;
  size.corners = 4;
  size.scale = 0.15;
  return parts::tower(size);
}

}  // namespace

TEST_CASE("a layer that needs more than --memory-limit is named, with the need and the limit") {
  const PartFolder folder;
  const std::string comb = folder.add("comb.stl", parts::comb(3'000));
  const ProgramRun small = run(kRind + " slice " + comb + " -o " + folder.file("out.gcode") +
                               " --memory-limit 11M --quiet");
  CAPTURE(small.output);
  CHECK_EQ(small.exit_code, 3);
  CHECK(says(small, "memory are needed, 11.5 MB allowed (--memory-limit)"));
  if (!kSanitized) CHECK(says(small, "comb.stl, layer "));
  CHECK_EQ(run(kRind + " slice " + comb + " -o /dev/null --memory-limit 4G --quiet").exit_code, 0);
}

TEST_CASE("a print that runs out of memory ends with code 3") {
  const PartFolder folder;
  const std::string comb = folder.add("comb.stl", parts::comb(3'000));
  const ProgramRun print = run(kRind + " print " + comb +
                               " --port virtual --virtual-speed 0 --memory-limit 12M --quiet");
  CAPTURE(print.output);
  CHECK_EQ(print.exit_code, 3);
  CHECK(says(print, "--memory-limit"));
}

TEST_CASE("where the system gives no more, the program says so instead of dying") {
  const PartFolder folder;
  const std::string comb = folder.add("comb.stl", parts::comb(3'000));
  for (const std::string limit : {"--data=9000000", "--as=24000000"}) {
    CAPTURE(limit);
    const ProgramRun outcome = run((kSanitized ? "" : "prlimit " + limit + " ") + kRind +
                                   " slice " + comb + " -o /dev/null --quiet");
    CAPTURE(outcome.output);
    CHECK_EQ(outcome.exit_code, kSanitized ? 0 : 3);
    if (!kSanitized) CHECK(says(outcome, "the system gives no more memory"));
  }
}

TEST_CASE("ten times the height, the same memory; ten times the facets in a plane, more") {
  const PartFolder folder;
  const std::string settings = "--set perimeters=1";
  const std::int64_t low = peak_rss(folder, folder.add("low.stl", slim_tower(150)), settings);
  const std::int64_t high = peak_rss(folder, folder.add("high.stl", slim_tower(1'500)), settings);
  const std::int64_t wide = peak_rss(folder, folder.add("comb.stl", parts::comb(3'000)), settings);
  CAPTURE(low);
  CAPTURE(high);
  CAPTURE(wide);
  // Freed memory is kept back by the sanitizers.
  if (!kSanitized) CHECK_LT(high - low, 1'000'000);
  CHECK_GT(wide - low, 4'000'000);
}

TEST_CASE("thirty times the height, the same memory, with supports all the way up") {
  const PartFolder folder;
  const std::string settings = "--set supports=everywhere --spool " + folder.file("");
  check_same_peak(folder, folder.add("low.stl", parts::shelves(200)),
                  folder.add("high.stl", parts::shelves(6'000)), settings);
}

TEST_CASE("nor with bodies that enforce and block, and painted facets, all the way up") {
  const PartFolder folder;
  const auto marked = [&](const std::string& name, int layers) {
    const double height = 0.2 * layers;
    std::vector<parts::Part> boxes = {parts::box({0, 0, 0}, 4, 4, height)};
    for (double z = 2; z < height; z += 2) boxes.push_back(parts::box({1, 1, z}, 9, 2, 0.4));
    return folder.add_text(
        name,
        test::prusa_threemf({{parts::together(boxes), "ModelPart",
                              [](std::int64_t facet) { return facet % 7 == 0 ? "8002" : ""; }},
                             {parts::box({0, 0, 1}, 8, 2.5, height), "SupportEnforcer"},
                             {parts::box({7, 0, 1}, 9, 9, height), "SupportBlocker"}}));
  };
  const std::string settings = "--set supports=everywhere --memory 64k --spool " + folder.file("");
  check_same_peak(folder, marked("low.3mf", 200), marked("high.3mf", 2'000), settings);
}

TEST_CASE("five times the height, the same memory, with trees all the way up") {
  const PartFolder folder;
  const std::string settings =
      "--set supports=everywhere --set support_style=tree --spool " + folder.file("");
  check_same_peak(folder, folder.add("low.stl", parts::shelves(300)),
                  folder.add("high.stl", parts::shelves(1'500)), settings);
}

TEST_CASE("thirty times the height, the same memory, where the inside holds up its own roof") {
  const PartFolder folder;
  const std::string settings =
      "--set loose_roof=cone --set loose_pattern=lightning --spool " + folder.file("");
  check_same_peak(folder, folder.add("low.stl", parts::shelves(200)),
                  folder.add("high.stl", parts::shelves(6'000)), settings);
}

TEST_CASE("ten times the file, the same memory, for ready G-code") {
  const PartFolder folder;
  const auto peak_of = [&folder](int commands) {
    std::string text = "M104 S200\nG28\nG90\nM82\nG1 X20 Y20 Z.2 F6000\n";
    for (int i = 0; i < commands; ++i) {
      if (i % 900 == 0) text += ";LAYER_CHANGE\nM204 P" + std::to_string(500 + i % 7) + "\n";
      text += "G1 X" + std::to_string(20 + i % 150) + "." + std::to_string(i % 997) + " Y" +
              std::to_string(20 + i % 90) + " E" + std::to_string(i) + ".125 ; a comment\n";
    }
    const std::string part = folder.add_text("part.gcode", text + "M104 S0\n");
    const std::string stats = folder.file("stats.json");
    const ProgramRun outcome =
        run(kRind + " print " + part + " --port virtual --virtual-speed 0 " + "--quiet --journal " +
            folder.file("journal") + " --stats " + stats);
    CAPTURE(outcome.output);
    REQUIRE_EQ(outcome.exit_code, 0);
    std::ifstream file(stats);
    const std::string written{std::istreambuf_iterator<char>(file), {}};
    return nlohmann::json::parse(written)["peak_rss_bytes"].get<std::int64_t>();
  };
  const std::int64_t low = peak_of(3'000);
  const std::int64_t high = peak_of(kSanitized ? 6'000 : 30'000);
  CAPTURE(low);
  CAPTURE(high);
  if (!kSanitized) CHECK_LT(high - low, 1'000'000);
  if (!kSanitized) CHECK_LT(high, 16'000'000);
}

TEST_CASE("a full disk and a folder that can't be written to end with code 3 and what to do") {
  const PartFolder folder;
  const std::string vase = folder.add("vase.stl", parts::vase(0.2));
  const std::string slice =
      kRind + " slice " + vase + " -o /dev/null --quiet --memory 64k --layer-height 0.3";
  const ProgramRun full = run("ulimit -f 64; " + slice);
  CAPTURE(full.output);
  CHECK_EQ(full.exit_code, 3);
  CHECK(says(full, "make room there"));
  const ProgramRun closed = run("TMPDIR=/nowhere " + slice);
  CAPTURE(closed.output);
  CHECK_EQ(closed.exit_code, 3);
  CHECK(says(closed, "/nowhere"));
  CHECK(says(closed, "--memory"));
  const ProgramRun print = run("TMPDIR=/nowhere " + kRind + " print " + vase +
                               " --port virtual --virtual-speed 0 --memory 64k --quiet");
  CAPTURE(print.output);
  CHECK_EQ(print.exit_code, 3);
  CHECK(says(print, "/nowhere"));
}
