#include "host/part/part_transform.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"
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

namespace {

using Corner = parts::Corner;
using Move = std::function<Corner(Corner)>;

// A box, and a smaller one on it that tells its sides apart.
parts::Part marked_box() {
  return [](const auto& emit) {
    parts::box({3, 4, 0}, 20, 10, 8)(emit);
    parts::box({3, 4, 8}, 5, 4, 2)(emit);
  };
}

// Each corner by a computation of its own.
parts::Part each_corner(const parts::Part& part, const Move& move, bool flips) {
  return [=](const auto& emit) {
    part([&](std::array<Corner, 3> corners) {
      for (Corner& corner : corners) corner = move(corner);
      if (flips) std::swap(corners[1], corners[2]);
      emit(corners);
    });
  };
}

void check_same_slices(const std::string& path, const Settings& settings,
                       const std::string& expected) {
  host::OpenedPart is = opened(path, settings), should_be = opened(expected, Settings());
  CHECK_EQ(is.summary.layers, should_be.summary.layers);
  CHECK_EQ(is.summary.height, should_be.summary.height);
  const std::vector<core::Slice> slices = all_slices(is);
  const std::vector<core::Slice> wanted = all_slices(should_be);
  REQUIRE_EQ(slices.size(), wanted.size());
  for (std::size_t i = 0; i < slices.size(); ++i) {
    CAPTURE(i);
    const core::Region differ = core::exclusive_or(slices[i].region, wanted[i].region);
    CHECK_LT(differ.area_mm2(), 1e-3);
  }
}

}  // namespace

namespace {

struct Case {
  const char* scale;
  const char* rotation;
  core::PartMirror mirror;
  Move move;
  bool flips;
};

std::vector<Case> transforms() {
  constexpr double kRoot = 0.70710678118654752;
  return {
      {"150%", "0", core::PartMirror::kNone,
       [](Corner c) -> Corner {
         return {1.5 * c.x, 1.5 * c.y, 1.5 * c.z};
       },
       false},
      {"1,2,0.5", "0", core::PartMirror::kNone,
       [](Corner c) -> Corner {
         return {c.x, 2 * c.y, c.z / 2};
       },
       false},
      {"1", "0", core::PartMirror::kX,
       [](Corner c) -> Corner {
         return {-c.x, c.y, c.z};
       },
       true},
      {"1", "0", core::PartMirror::kZ,
       [](Corner c) -> Corner {
         return {c.x, c.y, -c.z};
       },
       true},
      {"1", "90", core::PartMirror::kNone,
       [](Corner c) -> Corner {
         return {-c.y, c.x, c.z};
       },
       false},
      {"1", "45", core::PartMirror::kNone,
       [](Corner c) -> Corner {
         return {kRoot * (c.x - c.y), kRoot * (c.x + c.y), c.z};
       },
       false},
      {"1", "90,0,0", core::PartMirror::kNone,
       [](Corner c) -> Corner {
         return {c.x, -c.z, c.y};
       },
       false},
      // About x, then y: z goes to -y, and x to -z.
      {"2", "90,90,0", core::PartMirror::kNone,
       [](Corner c) -> Corner {
         return {2 * c.y, -2 * c.z, -2 * c.x};
       },
       false},
      {"to 40mm", "0", core::PartMirror::kNone,
       [](Corner c) -> Corner {
         return {2 * c.x, 2 * c.y, 2 * c.z};
       },
       false},
  };
}

}  // namespace

// The part as transformed here is the mesh transformed outside.
TEST_CASE("scaled, mirrored and turned, the part is the mesh that was transformed outside") {
  const PartFolder folder;
  const parts::Part box = marked_box();
  const std::string path = folder.add("box.stl", box);
  for (const Case& one : transforms()) {
    CAPTURE(one.scale);
    CAPTURE(one.rotation);
    Settings settings;
    settings.part_scale = one.scale;
    settings.part_rotation = one.rotation;
    settings.part_mirror = one.mirror;
    check_same_slices(path, settings,
                      folder.add("moved.stl", each_corner(box, one.move, one.flips)));
  }
}

TEST_CASE("a file in metres is read as finely as one in millimetres") {
  const PartFolder folder;
  const auto text = [](double unit) {
    std::ostringstream out;
    out.precision(12);
    const std::array<Corner, 4> corners = {Corner{0, 0, 0}, Corner{12.3456, 0, 0},
                                           Corner{0, 9.8765, 0}, Corner{0, 0, 7.6543}};
    for (const Corner& corner : corners) {
      out << "v " << corner.x / unit << ' ' << corner.y / unit << ' ' << corner.z / unit << '\n';
    }
    out << "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    return out.str();
  };
  const std::string expected = folder.add_text("mm.obj", text(1));
  Settings settings;
  settings.part_units = core::PartUnits::kMetre;
  check_same_slices(folder.add_text("m.obj", text(1'000)), settings, expected);
  settings.part_units = core::PartUnits::kInch;
  check_same_slices(folder.add_text("inch.obj", text(25.4)), settings, expected);
}

TEST_CASE("what can't be understood of a transform is refused") {
  Settings settings;
  for (const char* wrong :
       {"", "0", "-1", "2,3", "1,1,1,1", "big", "20000", "to", "to -3", "1,x,1"}) {
    settings.part_scale = wrong;
    CAPTURE(wrong);
    CHECK_FALSE(host::check_part_transform(settings).ok());
  }
  settings.part_scale = "1";
  for (const char* wrong : {"", "1,2", "north", "1,2,3,4", "1e9"}) {
    settings.part_rotation = wrong;
    CAPTURE(wrong);
    CHECK_FALSE(host::check_part_transform(settings).ok());
  }
  settings.part_rotation = "-90, 0,45.5";
  CHECK(host::check_part_transform(settings).ok());
}

TEST_CASE("layers are turned, mirrored and scaled sideways; their heights stay") {
  const PartFolder folder;
  const std::string path = folder.add_text("square.cli", kLayers);
  Settings settings;
  settings.part_scale = "2,3,1";
  settings.part_rotation = "90";
  settings.part_mirror = core::PartMirror::kY;
  host::OpenedPart part = opened(path, settings);
  const core::Box& box = part.summary.box;
  CHECK_EQ(mm(box.max.x - box.min.x), doctest::Approx(60));
  CHECK_EQ(mm(box.max.y - box.min.y), doctest::Approx(40));
  for (const core::Slice& slice : all_slices(part)) {
    CHECK_EQ(slice.region.area_mm2(), doctest::Approx(2'400));
  }
  for (const auto& [scale, rotation] :
       {std::pair("2", "0"), {"1", "90,0,0"}, {"to 10", "0"}, {"1,1,2", "0"}}) {
    settings.part_scale = scale;
    settings.part_rotation = rotation;
    CHECK_FALSE(host::open_whole_part(path, settings).ok());
  }
}
