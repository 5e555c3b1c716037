#include "host/part/plate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/limits.h"
#include "host/part/part_file.h"
#include "tests/support/marked_files.h"
#include "tests/support/part_folder.h"
#include "tests/support/part_slices.h"
#include "tests/support/region_checks.h"

using core::Settings;
using test::all_slices;
using test::PartFolder;

namespace {

host::OpenedPart plate_of(const std::vector<std::string>& paths, const Settings& settings) {
  auto part = host::read_whole(host::open_plate(paths, settings, {}));
  REQUIRE_MESSAGE(part.ok(), (part.ok() ? "" : part.error().message));
  return std::move(part).value();
}

std::string why_refused(const std::vector<std::string>& paths, const Settings& settings) {
  const auto part = host::read_whole(host::open_plate(paths, settings, {}));
  return part.ok() ? "" : part.error().message;
}

// The part alone, put where the plate has this object.
std::vector<core::Slice> alone(const std::string& path, Settings settings,
                               const host::PartObject& object) {
  settings.copies = 1;
  settings.centre = false;
  settings.part_x = core::Length::from_units(object.box.min.x);
  settings.part_y = core::Length::from_units(object.box.min.y);
  auto part = host::open_whole_part(path, settings);
  REQUIRE_MESSAGE(part.ok(), (part.ok() ? "" : part.error().message));
  CHECK(part.value().summary.box == object.box);
  return all_slices(part.value());
}

std::vector<core::Ring> sorted_rings(std::vector<core::Ring> rings) {
  std::sort(rings.begin(), rings.end());
  return rings;
}

// What of it lies on an object, but for two units at its border.
double area_on(const core::Region& region, const host::PartObject& object) {
  const core::Point min = object.box.min, max = object.box.max;
  const auto box = core::Region::from_clean_rings({{min, {max.x, min.y}, max, {min.x, max.y}}});
  return core::intersect(region, box).area_mm2();
}

// A block with a modifier, an enforcer and a blocker that reach far out of it.
std::string marked_block(double density) {
  const std::string percent = std::to_string(density) + "%";
  return test::prusa_threemf(
      {{parts::box({0, 0, 0}, 20, 10, 8), "ModelPart"},
       {parts::box({10, -50, 2}, 300, 200, 4),
        "ParameterModifier",
        {},
        {{"fill_density", percent}}},
       {parts::box({12, 3, 1}, 3, 3, 5), "ParameterModifier", {}, {{"fill_pattern", "gyroid"}}},
       {parts::box({-150, 2, 0}, 300, 4, 3), "SupportEnforcer"},
       {parts::box({5, -150, 0}, 5, 300, 3), "SupportBlocker"}});
}

}  // namespace

TEST_CASE("a plate's slices are those of its parts where these are printed alone") {
  const PartFolder folder;
  const std::string box = folder.add("a box.stl", parts::box({3, 4, 0}, 20, 10, 8));
  const std::string dome = folder.add("dome.stl", parts::dome(9, 64, 32));
  Settings settings;
  settings.copies = 3;
  host::OpenedPart plate = plate_of({box, dome}, settings);
  const std::vector<host::PartObject> objects = plate.summary.objects;
  REQUIRE_EQ(objects.size(), 6);
  CHECK_EQ(objects[0].name, "a_box_1");
  CHECK_EQ(objects[5].name, "dome_6");
  const std::vector<core::Slice> slices = all_slices(plate);
  std::vector<std::vector<core::Slice>> each;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    each.push_back(alone(i < 3 ? box : dome, settings, objects[i]));
  }
  CHECK_EQ(slices.size(), 45);
  CHECK_EQ(plate.summary.layers, 45);
  CHECK_EQ(plate.summary.height.mm(), doctest::Approx(9));
  for (std::size_t layer = 0; layer < slices.size(); ++layer) {
    CAPTURE(layer);
    std::vector<core::Ring> wanted;
    for (const std::vector<core::Slice>& one : each) {
      if (layer >= one.size()) continue;
      const auto& rings = one[layer].region.rings();
      wanted.insert(wanted.end(), rings.begin(), rings.end());
      CHECK_EQ(one[layer].bottom, slices[layer].bottom);
    }
    CHECK((sorted_rings(slices[layer].region.rings()) == sorted_rings(wanted)));
    CHECK(test::is_clean(slices[layer].region));
  }
}

TEST_CASE("each copy has its modifiers and marks, and none of another's") {
  const PartFolder folder;
  const std::string dense = folder.add_text("dense.3mf", marked_block(60));
  const std::string light = folder.add_text("light.3mf", marked_block(5));
  Settings settings;
  settings.supports = core::SupportPlace::kEverywhere;
  settings.copies = 2;
  host::OpenedPart plate = plate_of({dense, light}, settings);
  CHECK_EQ(plate.modifiers.size(), 4);
  CHECK_EQ(plate.modifiers.front().find("dense.3mf: modifier "), 0);
  const std::vector<host::PartObject> objects = plate.summary.objects;
  REQUIRE_EQ(objects.size(), 4);
  const std::vector<core::Slice> slices = all_slices(plate);
  std::vector<std::vector<core::Slice>> each;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    each.push_back(alone(i < 2 ? dense : light, settings, objects[i]));
  }
  for (std::size_t layer = 0; layer < slices.size(); ++layer) {
    CAPTURE(layer);
    std::size_t areas = 0;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const core::Slice& one = each[i][layer];
      REQUIRE_EQ(one.marks != nullptr, slices[layer].marks != nullptr);
      if (one.marks) {
        CHECK_EQ(area_on(slices[layer].marks->enforced, objects[i]),
                 doctest::Approx(area_on(one.marks->enforced, objects[i])));
        CHECK_EQ(area_on(slices[layer].marks->blocked, objects[i]),
                 doctest::Approx(area_on(one.marks->blocked, objects[i])));
        CHECK(test::is_clean(slices[layer].marks->enforced));
      }
      if (!one.areas) continue;
      REQUIRE(slices[layer].areas);
      for (const core::ChangedArea& own : *one.areas) {
        REQUIRE_LT(areas, slices[layer].areas->size());
        const core::ChangedArea& found = (*slices[layer].areas)[areas++];
        CHECK(found.change == own.change);
        for (std::size_t other = 0; other < objects.size(); ++other) {
          const double wanted = other == i ? area_on(own.region, objects[i]) : 0;
          CHECK_EQ(area_on(found.region, objects[other]), doctest::Approx(wanted));
        }
      }
    }
    CHECK_EQ(areas, slices[layer].areas ? slices[layer].areas->size() : 0);
  }
  REQUIRE(slices[12].areas);
  CHECK_EQ(slices[12].areas->size(), 8);
  CHECK_FALSE(slices[32].areas);
  REQUIRE(slices[0].marks);
  CHECK_GT(area_on(slices[0].marks->enforced, objects[3]), 1);
}

TEST_CASE("a part is read once for all of its copies") {
  const PartFolder folder;
  const std::string dome = folder.add("dome.stl", parts::dome(9, 64, 32));
  Settings settings;
  host::OpenedPart one = plate_of({dome}, settings);
  settings.copies = 12;
  host::OpenedPart many = plate_of({dome}, settings);
  (void)all_slices(one);
  (void)all_slices(many);
  CHECK_EQ(many.counters().peak_triangles_held, one.counters().peak_triangles_held);
  CHECK_EQ(many.summary.facets, 12 * one.summary.facets);
}

TEST_CASE("what can't lie beside others is refused with the reason") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", parts::box({3, 4, 0}, 20, 10, 8));
  Settings settings;
  settings.copies = core::kObjectsMax;
  CHECK(why_refused({box, box}, settings).find("512 objects") != std::string::npos);
  settings.copies = 200;
  CHECK(why_refused({box}, settings).find("of the 200 objects fit") != std::string::npos);
  settings.copies = 2;
  settings.spiral_vase = true;
  CHECK(why_refused({box}, settings).find("spiral_vase") != std::string::npos);
  settings.spiral_vase = false;
  CHECK(why_refused({box, folder.file("none.stl")}, settings).find("none.stl") !=
        std::string::npos);
}

TEST_CASE("parts with layers of different heights are refused where they differ") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", parts::box({3, 4, 0}, 20, 10, 8));
  const std::string layers = folder.add_text(
      "part.cli",
      "$$HEADERSTART\n$$ASCII\n$$UNITS/1\n$$HEADEREND\n$$GEOMETRYSTART\n$$LAYER/0\n$$LAYER/0.3\n"
      "$$POLYLINE/1,1,5,5,2,25,2,25,22,5,22,5,2\n$$GEOMETRYEND\n");
  host::OpenedPart plate = plate_of({box, layers}, Settings());
  const auto refused = plate.layers->next();
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().message.find("part.cli, layer 1: it lies from 0 to 0.3 mm") == 0);
  CHECK(refused.error().message.find("box.stl") != std::string::npos);
}

TEST_CASE("both pieces of a part that is cut lie beside each other") {
  const PartFolder folder;
  const std::string cone = folder.add("pyramid.stl", parts::pyramid(12));
  Settings settings;
  settings.cut = "5";
  CHECK(host::is_plate({cone}, settings));
  host::OpenedPart plate = plate_of({cone}, settings);
  const std::vector<host::PartObject> objects = plate.summary.objects;
  REQUIRE_EQ(objects.size(), 2);
  const std::vector<core::Slice> slices = all_slices(plate);
  settings.cut = "5 lower";
  const std::vector<core::Slice> lower = alone(cone, settings, objects[0]);
  settings.cut = "5 upper";
  const std::vector<core::Slice> upper = alone(cone, settings, objects[1]);
  CHECK_EQ(lower.size(), 25);
  REQUIRE_EQ(slices.size(), std::max(lower.size(), upper.size()));
  for (std::size_t layer = 0; layer < slices.size(); ++layer) {
    double area = 0;
    if (layer < lower.size()) area += lower[layer].region.area_mm2();
    if (layer < upper.size()) area += upper[layer].region.area_mm2();
    CHECK(slices[layer].region.area_mm2() == doctest::Approx(area));
  }
}

TEST_CASE("all objects are shown where they lie") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", parts::box({3, 4, 0}, 20, 10, 8));
  const std::string dome = folder.add("dome.stl", parts::dome(9, 64, 32));
  Settings settings;
  settings.copies = 2;
  const host::OpenedPart part = plate_of({box, dome}, settings);
  REQUIRE(static_cast<bool>(part.draw));
  CHECK_FALSE(part.summary.seen_whole);
  core::Box seen;
  std::vector<core::Box> objects(part.summary.objects.size());
  std::int64_t facets = 0, lowest = 1, highest = 0;
  const core::Status drawn = part.draw([&](const core::Triangle& facet) {
    ++facets;
    lowest = std::min(lowest, facet.lowest_z());
    highest = std::max(highest, facet.highest_z());
    for (const core::Vertex& corner : facet.corners) {
      const core::Point at{corner.x, corner.y};
      seen.add(at);
      for (std::size_t i = 0; i < objects.size(); ++i) {
        const core::Box& of = part.summary.objects[i].box;
        const bool within =
            at.x >= of.min.x && at.x <= of.max.x && at.y >= of.min.y && at.y <= of.max.y;
        if (within) objects[i].add(at);
      }
    }
  });
  CHECK(drawn.ok());
  CHECK_EQ(facets, part.summary.facets);
  CHECK_EQ(lowest, 0);
  CHECK_EQ(highest, core::Length::from_mm(9).units());
  CHECK(seen == part.summary.box);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    CHECK(objects[i] == part.summary.objects[i].box);
  }
  // Slices have no facets.
  const std::string layers = folder.add_text(
      "a.cli",
      "$$HEADERSTART\n$$ASCII\n$$UNITS/1\n$$HEADEREND\n$$GEOMETRYSTART\n"
      "$$LAYER/0\n$$LAYER/0.2\n$$POLYLINE/1,1,5,0,0,9,0,9,9,0,9,0,0\n$$GEOMETRYEND\n");
  CHECK_FALSE(static_cast<bool>(plate_of({layers}, settings).draw));
}
