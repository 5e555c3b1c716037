#include "host/part/shrinkage.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "host/part/part_file.h"
#include "tests/support/part_folder.h"
#include "tests/support/part_slices.h"
#include "tests/support/region_checks.h"

using core::Settings;
using test::all_slices;
using test::PartFolder;

namespace {

Settings shrinking(double xy, double z) {
  Settings settings;
  settings.shrinkage_xy = xy;
  settings.shrinkage_z = z;
  return settings;
}

double mm(std::int64_t units) { return static_cast<double>(units) / core::kUnitsPerMm; }

host::OpenedPart opened(const std::string& path, const Settings& settings) {
  auto part = host::open_whole_part(path, settings);
  REQUIRE_MESSAGE(part.ok(), (part.ok() ? "" : part.error().message));
  return std::move(part).value();
}

// A square of 20 mm at (5, 2), as a file of layers.
const char* const kLayers =
    "$$HEADERSTART\n$$ASCII\n$$UNITS/1\n$$HEADEREND\n$$GEOMETRYSTART\n$$LAYER/0\n$$LAYER/0.2\n"
    "$$POLYLINE/1,1,5,5,2,25,2,25,22,5,22,5,2\n$$GEOMETRYEND\n";

}  // namespace

// The literal formula: what measures 99 mm instead of 100 has shrunk by 1 %.
TEST_CASE("a mesh that shrinks gets the size that was asked for") {
  const PartFolder folder;
  for (const bool many : {false, true}) {
    CAPTURE(many);
    // A box, and a part of more facets than the look-ahead holds, which is read twice.
    const std::string path =
        folder.add(many ? "tower.stl" : "box.stl", many ? parts::tower(parts::TowerSize{200, 64, 1})
                                                        : parts::box({3, 4, 0}, 20, 10, 8));
    host::OpenedPart plain = opened(path, Settings());
    for (const auto& [xy_share, z_share] :
         std::vector<std::pair<double, double>>{{0.01, 0}, {0.004, 0.02}}) {
      const double xy = xy_share, z = z_share;
      CAPTURE(xy);
      host::OpenedPart larger = opened(path, shrinking(xy, z));
      const core::Box &was = plain.summary.box, &is = larger.summary.box;
      CHECK(mm(is.max.x - is.min.x) * (1 - xy) ==
            doctest::Approx(mm(was.max.x - was.min.x)).epsilon(2e-5));
      CHECK(mm(is.max.y - is.min.y) * (1 - xy) ==
            doctest::Approx(mm(was.max.y - was.min.y)).epsilon(2e-5));
      CHECK(larger.summary.height.mm() * (1 - z) ==
            doctest::Approx(plain.summary.height.mm()).epsilon(2e-5));
      CHECK_EQ(larger.summary.facets, plain.summary.facets);
      CHECK_EQ(larger.summary.format, plain.summary.format);
    }
  }
}

TEST_CASE("slices of a shrinking mesh have the area that is left of it by the formula") {
  const PartFolder folder;
  const std::string path = folder.add("box.stl", parts::box({3, 4, 0}, 20, 10, 8));
  host::OpenedPart part = opened(path, shrinking(0.02, 0.5));
  const std::vector<core::Slice> slices = all_slices(part);
  CHECK_EQ(slices.size(), 80);  // 16 mm, of which 8 are left
  for (const core::Slice& slice : slices) {
    CHECK(slice.region.area_mm2() * 0.98 * 0.98 == doctest::Approx(200).epsilon(1e-5));
  }
}

TEST_CASE("a file of layers is made larger sideways, and refused where heights would change") {
  const PartFolder folder;
  const std::string path = folder.add_text("part.cli", kLayers);
  host::OpenedPart part = opened(path, shrinking(0.01, 0));
  const std::vector<core::Slice> slices = all_slices(part);
  REQUIRE_EQ(slices.size(), 1);
  CHECK(slices[0].region.area_mm2() * 0.99 * 0.99 == doctest::Approx(400).epsilon(1e-5));
  CHECK(test::is_clean(slices[0].region));
  const auto refused = host::open_whole_part(path, shrinking(0.01, 0.01));
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().message.find("shrinkage_z") != std::string::npos);
  CHECK(refused.error().message.find(path) == 0);
}

TEST_CASE("what gets too far from the origin is told") {
  const PartFolder folder;
  const std::string path = folder.add("far.stl", parts::box({50'000, 0, 0}, 20, 10, 8));
  CHECK(host::open_whole_part(path, Settings()).ok());
  const auto refused = host::open_whole_part(path, shrinking(0.2, 0));
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().message.find("shrinkage_xy") != std::string::npos);
}
