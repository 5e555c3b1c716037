#include "host/part/part_file.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <sstream>
#include <string>
#include <vector>

#include "tests/support/part_slices.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"
#include "tests/support/temporary_folder.h"
#include "tools/parts/part_maker.h"

using core::ErrorCode;
using core::Length;
using core::Settings;
using host::open_part;
using host::open_whole_part;
using host::OpenedPart;
using test::all_slices;

namespace {

std::string binary(const parts::Part& part) {
  std::ostringstream out;
  parts::write_binary_stl(part, out);
  return out.str();
}

OpenedPart opened(const test::TemporaryFolder& folder, const parts::Part& part,
                  const Settings& settings) {
  auto result = open_whole_part(folder.write("part.stl", binary(part)), settings);
  REQUIRE_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
  return std::move(result).value();
}

void check_refused(const std::string& path, const Settings& settings, ErrorCode code,
                   const std::vector<std::string>& texts) {
  const auto result = open_whole_part(path, settings);
  REQUIRE_FALSE(result.ok());
  CHECK_EQ(result.error().code, code);
  CAPTURE(result.error().message);
  CHECK(result.error().message.find(path) == 0);
  for (const std::string& text : texts) {
    CAPTURE(text);
    CHECK(result.error().message.find(text) != std::string::npos);
  }
}

}  // namespace

TEST_CASE("a part is centred on the bed, its lowest point at height 0") {
  const test::TemporaryFolder folder;
  Settings settings;
  settings.bed_x = Length::from_mm(100);
  settings.bed_y = Length::from_mm(60);
  OpenedPart part = opened(folder, parts::box({-1000, 300, -7}, 20, 10, 4), settings);
  CHECK_EQ(part.summary.format, "binary STL");
  CHECK_EQ(part.summary.facets, 12);
  CHECK_EQ(part.summary.degenerate, 0);
  CHECK_EQ(part.summary.height.mm(), 4);
  CHECK_EQ(part.summary.layers, 20);
  CHECK(part.summary.warnings.empty());
  CHECK_EQ(part.summary.box, core::Box{{400'000, 250'000}, {600'000, 350'000}});
  const std::vector<core::Slice> slices = all_slices(part);
  REQUIRE_EQ(slices.size(), 20);
  for (const core::Slice& slice : slices) {
    CHECK_EQ(slice.region, test::region_from_text("40:25 60:25 60:35 40:35"));
  }
  CHECK_EQ(slices[3].bottom.mm(), doctest::Approx(0.6));
  CHECK_EQ(part.counters().peak_triangles_held, 8);
  CHECK(part.counters().read_cpu_s > 0);
  CHECK(part.counters().slice_cpu_s > 0);
}

TEST_CASE("a part is set where the settings say") {
  const test::TemporaryFolder folder;
  Settings settings;
  settings.centre = false;
  settings.part_x = Length::from_mm(12.5);
  settings.part_y = Length::from_mm(3);
  OpenedPart part = opened(folder, parts::box({5, 5, 5}, 20, 10, 4), settings);
  CHECK_EQ(all_slices(part)[0].region, test::region_from_text("12.5:3 32.5:3 32.5:13 12.5:13"));
}

TEST_CASE("the demo part: more than 100 layers, all of them sound") {
  const test::TemporaryFolder folder;
  const Settings settings;
  OpenedPart part = opened(folder, parts::demo(), settings);
  CHECK_EQ(part.summary.layers, 125);
  const std::vector<core::Slice> slices = all_slices(part);
  REQUIRE_EQ(slices.size(), 125);
  for (const core::Slice& slice : slices) {
    CHECK_FALSE(slice.region.empty());
    CHECK_FALSE(slice.defects.any());
    CHECK(test::is_clean(slice.region));
  }
}

TEST_CASE("a text and a binary file of one part give the same slices") {
  const test::TemporaryFolder folder;
  const Settings settings;
  std::ostringstream text;
  parts::write_ascii_stl(parts::dome(10, 24, 8), text);
  OpenedPart from_binary = opened(folder, parts::dome(10, 24, 8), settings);
  auto from_text = open_whole_part(folder.write("text", text.str()), settings);
  REQUIRE(from_text.ok());
  CHECK_EQ(from_text.value().summary.format, "ASCII STL");
  const std::vector<core::Slice> a = all_slices(from_binary), b = all_slices(from_text.value());
  REQUIRE_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) CHECK_EQ(a[i].region, b[i].region);
}

TEST_CASE("parts that can't be printed are refused with their measures") {
  const test::TemporaryFolder folder;
  Settings settings;
  const auto refused = [&](const parts::Part& part, ErrorCode code,
                           const std::vector<std::string>& texts) {
    check_refused(folder.write("part.stl", binary(part)), settings, code, texts);
  };
  refused(parts::box({0, 0, 0}, 20, 20, 0), ErrorCode::kBadPart, {"flat"});
  refused(parts::box({0, 0, 0}, 20, 20, 0.05), ErrorCode::kBadPart, {"0.05 mm", "0.2 mm"});
  refused(parts::box({0, 0, 0}, 301, 20, 10), ErrorCode::kOutOfBounds, {"301 × 20", "300 × 300"});
  refused(parts::box({0, 0, 0}, 20, 300.1, 10), ErrorCode::kOutOfBounds, {"20 × 300.1"});
  settings.axis_z = Length::from_mm(9.9);
  refused(parts::box({0, 0, 0}, 20, 20, 10), ErrorCode::kOutOfBounds,
          {"10 mm", "9.9 mm", "axis_z"});
  settings.axis_z = Length::from_mm(10);
  CHECK(
      open_whole_part(folder.write("part.stl", binary(parts::box({0, 0, 0}, 20, 20, 10))), settings)
          .ok());
  settings.centre = false;
  settings.part_x = Length::from_mm(290);
  refused(parts::box({0, 0, 0}, 20, 20, 10), ErrorCode::kOutOfBounds, {"290 … 310", "part_x"});
  settings.part_x = Length::from_mm(-0.5);
  refused(parts::box({0, 0, 0}, 20, 20, 10), ErrorCode::kOutOfBounds, {"-0.5 … 19.5"});
}

TEST_CASE("a part as large as the bed fits, whichever way it is rounded") {
  const test::TemporaryFolder folder;
  Settings settings;
  settings.bed_x = Length::from_units(200'001);
  settings.bed_y = Length::from_units(200'000);
  OpenedPart part = opened(folder, parts::box({0, 0, 0}, 20, 20, 1), settings);
  CHECK(part.summary.box.min.x >= 0);
  CHECK(part.summary.box.max.x <= 200'001);
}

TEST_CASE("on a bed that is no rectangle, a part is placed and checked by its own outline") {
  const test::TemporaryFolder folder;
  Settings settings;
  settings.bed_x = settings.bed_y = Length::from_mm(100);
  settings.bed_origin_x = settings.bed_origin_y = Length::from_mm(-50);
  settings.bed_shape = {{0, -500'000}, {500'000, 0}, {0, 500'000}, {-500'000, 0}};
  OpenedPart part = opened(folder, parts::box({0, 0, 0}, 40, 40, 1), settings);
  CHECK_EQ(part.summary.box, core::Box{{300'000, 300'000}, {700'000, 700'000}});
  // Its corners would be off the bed, all of its sides on it.
  const std::string wide = folder.write("wide.stl", binary(parts::box({0, 0, 0}, 60, 60, 1)));
  check_refused(wide, settings, ErrorCode::kOutOfBounds, {"beyond its outline", "bed_shape"});
  settings.centre = false;
  settings.part_x = settings.part_y = Length::from_mm(25);
  CHECK(opened(folder, parts::box({0, 0, 0}, 50, 50, 1), settings).summary.layers == 5);
  settings.part_x = Length::from_mm(24);
  check_refused(folder.write("left.stl", binary(parts::box({0, 0, 0}, 50, 50, 1))), settings,
                ErrorCode::kOutOfBounds, {"beyond its outline"});
}

TEST_CASE("files that can't be read") {
  const test::TemporaryFolder folder;
  const Settings settings;
  check_refused(folder.path(), settings, ErrorCode::kUnreadable, {"folder"});
  check_refused(folder.path("missing.stl"), settings, ErrorCode::kUnreadable, {"no such file"});
  check_refused(folder.write("empty.stl", ""), settings, ErrorCode::kBadPart, {"empty"});
  const std::string closed = folder.write("closed.stl", binary(parts::demo()));
  std::filesystem::permissions(closed, std::filesystem::perms::none);
  // The superuser may read it all the same.
  if (::geteuid() != 0) {
    check_refused(closed, settings, ErrorCode::kUnreadable, {"not permitted"});
  } else {
    CHECK(open_part(closed, settings).ok());
  }
}

TEST_CASE("facets without area are counted and left out") {
  const test::TemporaryFolder folder;
  for (const parts::NamedPart& named : parts::all_parts()) {
    if (named.name != "zero_area") continue;
    OpenedPart part = opened(folder, named.part, Settings());
    CHECK_EQ(part.summary.facets, 15);
    CHECK_EQ(part.summary.degenerate, 2);
    for (const core::Slice& slice : all_slices(part)) {
      CHECK(slice.region.area_mm2() == doctest::Approx(400));
    }
  }
}

TEST_CASE("'-' is standard input, a pipe included") {
  const std::string bytes = binary(parts::demo());
  int ends[2];
  REQUIRE_EQ(::pipe(ends), 0);
  // Fits the pipe's buffer in two goes at most: a child writes.
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t count = ::write(ends[1], bytes.data() + done, bytes.size() - done);
      if (count <= 0) break;
      done += static_cast<std::size_t>(count);
    }
    ::_exit(0);
  }
  ::close(ends[1]);
  const int before = ::dup(STDIN_FILENO);
  ::dup2(ends[0], STDIN_FILENO);
  ::close(ends[0]);
  auto part = open_whole_part("-", Settings());
  ::dup2(before, STDIN_FILENO);
  ::close(before);
  REQUIRE(part.ok());
  CHECK_EQ(part.value().summary.facets, parts::count_facets(parts::demo()));
  CHECK_EQ(all_slices(part.value()).size(), 125);
}
