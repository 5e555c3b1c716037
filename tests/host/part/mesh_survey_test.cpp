#include "host/part/mesh_survey.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/slices/plane_sweep.h"
#include "tests/support/mesh.h"
#include "tests/support/random_regions.h"
#include "tools/parts/part_maker.h"

using core::Length;
using core::Triangle;
using host::MeshSurvey;

namespace {

MeshSurvey surveyed(const std::vector<Triangle>& triangles, std::size_t window = 8) {
  MeshSurvey survey(window);
  for (const Triangle& t : triangles) survey.add(t);
  return survey;
}

// By the definition: no triangle has more than `room` before it that are higher.
bool fits_window(const std::vector<Triangle>& triangles, std::size_t room) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto higher =
        std::count_if(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(i),
                      [&](const Triangle& t) { return t.lowest_z() > triangles[i].lowest_z(); });
    if (higher > static_cast<std::ptrdiff_t>(room)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("closed surfaces are told from open ones") {
  for (const parts::NamedPart& named : parts::all_parts(40, 0.1)) {
    CAPTURE(named.name);
    // What is wrong with these is in their surface.
    const std::set<std::string> open = {"hole", "flipped_some", "doubled", "zero_area", "soup"};
    CHECK_EQ(surveyed(test::triangles_of(named.part)).closed(), !open.contains(named.name));
  }
  std::vector<Triangle> dome = test::triangles_of(parts::dome(10));
  for (const std::size_t i : {std::size_t{0}, dome.size() / 2, dome.size() - 1}) {
    std::vector<Triangle> holed = dome;
    holed.erase(holed.begin() + static_cast<std::ptrdiff_t>(i));
    CHECK_FALSE(surveyed(holed).closed());
    holed = dome;
    std::swap(holed[i].corners[0], holed[i].corners[1]);
    CHECK_FALSE(surveyed(holed).closed());
    holed = dome;
    ++holed[i].corners[1].x;
    CHECK_FALSE(surveyed(holed).closed());
  }
}

TEST_CASE("parts of one body enclose what their shape has") {
  const auto volume_mm3 = [](const parts::Part& part) {
    double sum = 0;
    part([&sum](const parts::Facet& facet) {
      const auto& [a, b, c] = facet;
      sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
             a.z * (b.x * c.y - b.y * c.x);
    });
    return sum / 6;
  };
  const auto polygon_mm2 = [](int corners, double radius) {
    return corners / 2.0 * radius * radius * std::sin(2 * M_PI / corners);
  };
  CHECK(volume_mm3(parts::pins(3)) == doctest::Approx(9 * polygon_mm2(24, 0.9)));
  CHECK(volume_mm3(parts::perforated(4)) == doctest::Approx(16 * 4 * (9 - polygon_mm2(40, 1))));
  CHECK(volume_mm3(parts::spikes(3)) == doctest::Approx(9 * 1.8 * 1.8));
  const double triangle_mm2 = polygon_mm2(3, 50);
  CHECK(volume_mm3(parts::koch(0)) == doctest::Approx(2 * triangle_mm2));
  CHECK(volume_mm3(parts::koch(3)) ==
        doctest::Approx(2 * triangle_mm2 * (1.6 - 0.6 * std::pow(4.0 / 9, 3))));
  CHECK(volume_mm3(parts::spiral(2)) == doctest::Approx(2 * 0.6 * 4 * M_PI * 3.2).epsilon(1e-2));
  CHECK(volume_mm3(parts::figure(0.5)) ==
        doctest::Approx(volume_mm3(parts::figure(1))).epsilon(0.02));
  // Each body's own volume, where they run into one another.
  CHECK_GT(volume_mm3(parts::bracket()), 60 * 40 * 5);
  CHECK_GT(volume_mm3(parts::electronics_case()), 256 * 24 * 1.6);
  CHECK_GT(volume_mm3(parts::sign()), 64 * 22 * 2 * 0.95);
}

TEST_CASE("edges that run the same way twice are counted, with their place") {
  const auto turned_at = [](std::vector<Triangle> mesh, std::vector<std::size_t> numbers) {
    for (const std::size_t i : numbers) std::swap(mesh[i].corners[0], mesh[i].corners[1]);
    return surveyed(mesh).turned();
  };
  const std::vector<Triangle> box = test::triangles_of(parts::box({10, 20, 0}, 20, 20, 10));
  CHECK_FALSE(turned_at(box, {}));
  // The lid: four edges at the top, around the whole box.
  const auto lid = turned_at(box, {2, 3});
  REQUIRE(lid);
  CHECK_EQ(lid->edges, 4);
  CHECK(lid->exact);
  CHECK(lid->placed);
  CHECK_EQ(lid->lowest.z, 100'000);
  CHECK_EQ(lid->box, core::Box{{100'000, 200'000}, {300'000, 400'000}});
  for (std::size_t i = 0; i < box.size(); ++i) {
    const auto one = turned_at(box, {i});
    REQUIRE(one);
    CHECK_EQ(one->edges, 3);
  }
  // All of it is sound again, seen from behind.
  CHECK_FALSE(turned_at(box, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
  // A facet that is missing is no facet turned over; both are told apart.
  std::vector<Triangle> holed = box;
  holed.erase(holed.begin());
  CHECK_FALSE(surveyed(holed).turned());
  const auto both = turned_at(holed, {5});
  REQUIRE(both);
  CHECK_EQ(both->edges, 3);
  // More than have a place of their own: about so many, anywhere.
  std::vector<std::size_t> many;
  const std::vector<Triangle> dome = test::triangles_of(parts::dome(10));
  for (std::size_t i = 0; i < dome.size(); i += 7) many.push_back(i);
  const auto everywhere = turned_at(dome, many);
  REQUIRE(everywhere);
  CHECK_FALSE(everywhere->exact);
  CHECK_FALSE(everywhere->placed);
  CHECK_GT(everywhere->edges, static_cast<std::int64_t>(many.size()));
}

TEST_CASE("what the gauge calls in order, a window of that size puts in order") {
  test::Random random(1);
  int yes = 0, no_although_it_fits = 0;
  for (int seed = 0; seed < 2'000; ++seed) {
    const int count = random.integer(1, 60), jumble = random.integer(0, 12);
    std::vector<Triangle> triangles;
    for (int i = 0; i < count; ++i) {
      const std::int64_t z = i + random.integer(0, jumble);
      triangles.push_back({{core::Vertex{0, 0, z}, {1, 0, z + 3}, {0, 1, z + 2}}});
    }
    const bool in_order = surveyed(triangles, 8).in_order(), fits = fits_window(triangles, 8);
    if (in_order) CHECK(fits);
    yes += in_order ? 1 : 0;
    no_although_it_fits += fits && !in_order ? 1 : 0;
    host::ReorderWindow window;
    std::int64_t last = INT64_MIN;
    bool sorted = true;
    std::size_t next = 0;
    while (next < triangles.size() || !window.empty()) {
      while (next < triangles.size() && window.size() <= 8) window.push(triangles[next++]);
      const std::int64_t z = window.pop().lowest_z();
      sorted = sorted && z >= last;
      last = z;
    }
    CHECK_EQ(sorted, fits);
  }
  CHECK_GT(yes, 200);
  CHECK_GT(no_although_it_fits, 0);
}

TEST_CASE("the window gives the lowest of those it holds, whatever comes") {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const int count = random.integer(0, 200), jumble = seed % 3 == 0 ? 2 : 400;
    const auto triangle = [&](int i) {
      const std::int64_t z = i + random.integer(0, jumble);
      return Triangle{{core::Vertex{i, 0, z}, {1, 0, z + 3}, {0, 1, z + 2}}};
    };
    std::vector<Triangle> start;
    std::multiset<std::int64_t> held;
    for (int i = random.integer(0, 40); i > 0; --i) start.push_back(triangle(0));
    for (const Triangle& t : start) held.insert(t.lowest_z());
    host::ReorderWindow window(start);
    for (int i = 0; i < count || !held.empty(); ++i) {
      if (i < count && (held.empty() || random.integer(0, 9) < 6)) {
        const Triangle pushed = triangle(i);
        window.push(pushed);
        held.insert(pushed.lowest_z());
      } else {
        REQUIRE_EQ(window.pop().lowest_z(), *held.begin());
        held.erase(held.begin());
      }
      REQUIRE_EQ(window.size(), held.size());
      REQUIRE_EQ(window.empty(), held.empty());
    }
  }
}

TEST_CASE("layers that hold nothing are found, whatever the order of the facets") {
  test::Random random(2);
  const Length layer = Length::from_mm(0.2);
  for (int seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    std::vector<parts::Part> boxes;
    double z = 0;
    const int count = random.integer(1, 30);
    for (int i = 0; i < count; ++i) {
      const double height = 0.01 * random.integer(1, 200);
      boxes.push_back(parts::box({0, 0, z}, 5, 5, height));
      z += height + 0.01 * random.integer(-5, 60);
    }
    std::vector<Triangle> triangles = test::triangles_of(parts::together(boxes));
    const auto slices = test::sweep(triangles, test::exact_options()).slices;
    core::LayerIndex empty = 0, first = 0;
    for (const core::Slice& slice : slices) {
      if (!slice.region.empty()) continue;
      if (empty++ == 0) first = slice.index;
    }
    test::shuffle(triangles, random);
    MeshSurvey survey = surveyed(triangles);
    const MeshSurvey::EmptyLayers found = survey.empty_layers({layer, layer});
    CHECK_EQ(found.count, empty);
    CHECK_EQ(found.first, first);
  }
}

TEST_CASE("more gaps than it keeps: it tells fewer, and none that is not there") {
  std::vector<parts::Part> boxes;
  for (int i = 0; i < 700; ++i) boxes.push_back(parts::box({0, 0, 2.0 * i}, 5, 5, 1));
  test::Random random(3);
  std::vector<Triangle> triangles = test::triangles_of(parts::together(boxes));
  test::shuffle(triangles, random);
  MeshSurvey survey = surveyed(triangles);
  const core::LayerIndex found =
      survey.empty_layers({Length::from_mm(0.2), Length::from_mm(0.2)}).count;
  CHECK_GT(found, 200 * 5);
  CHECK_LE(found, 699 * 5);
}

TEST_CASE("a size that no print has makes one think of another unit") {
  const auto warning_of = [](double mm) {
    return host::unit_warning(
               surveyed(test::triangles_of(parts::box({0, 0, 0}, mm, mm, mm))).extent())
        .value_or("none");
  };
  CHECK_NE(warning_of(0.03).find("metres"), std::string::npos);
  // 20 inches, or 20 mm in inches: a person knows.
  CHECK_NE(warning_of(0.8).find("metres"), std::string::npos);
  CHECK_NE(warning_of(0.8).find("inches"), std::string::npos);
  CHECK_NE(warning_of(3).find("inches"), std::string::npos);
  CHECK_EQ(warning_of(6), "none");
}

TEST_CASE("where nothing is said to hang, each slice lies within the one below, or nearly") {
  int found = 0;
  const double height_mm = 0.2;
  for (const parts::NamedPart& named : parts::all_parts(40, 0.1)) {
    CAPTURE(named.name);
    const std::vector<Triangle> triangles = test::triangles_of(named.part);
    if (!surveyed(triangles).nothing_hangs_over(Length::from_mm(height_mm / 2))) continue;
    ++found;
    const std::vector<core::Slice> slices = test::sweep(triangles, test::exact_options()).slices;
    for (std::size_t n = 1; n < slices.size(); ++n) {
      CAPTURE(n);
      const core::Region reached = core::offset(
          slices[n - 1].region, Length::from_mm(-height_mm / 60), Length::from_units(10));
      CHECK(core::subtract(slices[n].region, reached).empty());
    }
  }
  CHECK_GT(found, 2);
}

TEST_CASE("a surface that leans outwards, or is not sure, is not said to hang nowhere") {
  const auto hangs = [](const parts::Part& part, bool turned = false) {
    std::vector<Triangle> triangles = test::triangles_of(part);
    if (turned) {
      for (Triangle& t : triangles) std::swap(t.corners[0], t.corners[1]);
    }
    return !surveyed(triangles).nothing_hangs_over(Length::from_mm(0.1));
  };
  const parts::Part box = parts::box({0, 0, 0}, 10, 10, 10);
  CHECK_FALSE(hangs(box));
  CHECK_FALSE(hangs(parts::dome(8)));
  CHECK(hangs(parts::together({box, parts::box({2, 2, 10}, 12, 6, 10)})));
  CHECK(hangs(parts::mushroom()));
  CHECK(hangs(box, true));
  std::vector<Triangle> open = test::triangles_of(box);
  open.pop_back();
  CHECK_FALSE(surveyed(open).nothing_hangs_over(Length::from_mm(0.1)));
}
