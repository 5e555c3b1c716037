// Readers that hold a mesh give its triangles once more without reading the file again.
#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "host/files/input_file.h"
#include "host/formats/formats.h"
#include "host/part/part_items.h"
#include "host/part/part_transform.h"
#include "tests/support/file_cases.h"
#include "tests/support/format_samples.h"
#include "tests/support/part_folder.h"

namespace {

using host::TriangleSource;

// Corners: of as many as there are, or the first ones.
std::vector<core::Vertex> taken(TriangleSource& triangles, std::size_t most = 1'000'000) {
  std::vector<core::Vertex> all;
  while (triangles.facets() < static_cast<std::int64_t>(most)) {
    const auto next = triangles.next();
    REQUIRE(next.ok());
    if (!next.value()) break;
    const core::Triangle triangle = *next.value();
    all.insert(all.end(), triangle.corners.begin(), triangle.corners.end());
  }
  return all;
}

// Null: it holds no triangles alone.
std::unique_ptr<TriangleSource> opened(const std::string& path) {
  auto file = host::InputFile::open(path);
  REQUIRE(file.ok());
  const auto kind = host::kind_of(file.value());
  if (!kind.ok() || host::is_layers(kind.value())) return nullptr;
  auto triangles = host::open_triangles(kind.value(), std::move(file).value());
  return triangles.ok() ? std::move(triangles).value() : nullptr;
}

// How many triangles were given again.
std::size_t check_rewound(TriangleSource& triangles) {
  const std::vector<core::Vertex> first = taken(triangles);
  const auto count = static_cast<std::size_t>(triangles.facets());
  const std::vector<std::string> warnings = triangles.warnings();
  auto rewound = triangles.rewind();
  REQUIRE(rewound.ok());
  if (!rewound.value()) return 0;
  CHECK_EQ(triangles.facets(), 0);
  static_cast<void>(taken(triangles, count / 2));
  REQUIRE(triangles.rewind().value());
  CHECK(taken(triangles) == first);
  CHECK_EQ(triangles.facets(), static_cast<std::int64_t>(count));
  CHECK_EQ(triangles.warnings(), warnings);
  return count;
}

}  // namespace

TEST_CASE("the same triangles, from the end and from the middle, in every format that holds them") {
  const test::PartFolder folder;
  std::size_t again = 0;
  std::vector<test::FileCase> cases;
  for (const auto& some : {test::threemf_cases(), test::threemf_role_cases(), test::amf_cases()}) {
    cases.insert(cases.end(), some.begin(), some.end());
  }
  for (const test::FormatSample& sample : test::format_samples()) {
    cases.push_back({sample.name, sample.bytes, 0, 0, {}});
  }
  for (const test::FileCase& each : cases) {
    CAPTURE(each.name);
    const std::string path = folder.add_text(each.name, each.bytes);
    const auto triangles = opened(path);
    // A refused file may fail later.
    if (triangles && (each.volume_mm3 > 0 || each.says.empty())) again += check_rewound(*triangles);
  }
  CHECK_GE(again, 200);
}

TEST_CASE("transformed and watched ones, too") {
  const test::PartFolder folder;
  const test::FileCase box = test::threemf_cases().front();
  auto triangles = opened(folder.add_text("box.3mf", box.bytes));
  REQUIRE(triangles);
  core::Settings settings;
  settings.part_scale = "1.5,1,1";
  host::OpenTriangles none;
  REQUIRE(host::transform(triangles, none, settings, "box").ok());
  const auto items = std::make_shared<host::PartItems>(std::vector<std::string>{"a"});
  triangles = host::watched(std::move(triangles), items);
  CHECK_GE(check_rewound(*triangles), 12);
}

TEST_CASE("a binary STL is read again instead") {
  const test::PartFolder folder;
  const auto triangles = opened(folder.add_text("box.stl", test::stl_cases().front().bytes));
  REQUIRE(triangles);
  CHECK_EQ(check_rewound(*triangles), 0);
}
