#include "core/slices/plane_sweep.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/mesh.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Length;
using core::PlaneSweep;
using core::Region;
using core::Slice;
using core::SliceDefects;
using core::Triangle;
using test::exact_options;
using test::sweep;
using test::triangles_of;

namespace {

double middle_mm(const Slice& slice) { return slice.bottom.mm() + slice.height.mm() / 2; }

std::vector<Slice> slices_of(const parts::Part& part) {
  return sweep(triangles_of(part), exact_options()).slices;
}

SliceDefects all_defects(const std::vector<Slice>& slices) {
  SliceDefects sum;
  for (const Slice& slice : slices) sum.add(slice.defects);
  return sum;
}

// A tetrahedron whose facets are a c b, a b d, b c d, c a d.
bool looks_outwards(const core::Vertex& a, const core::Vertex& b, const core::Vertex& c,
                    const core::Vertex& d) {
  const auto from_a = [&a](const core::Vertex& v) {
    return std::array<double, 3>{double(v.x) - a.x, double(v.y) - a.y,
                                 static_cast<double>(v.z - a.z)};
  };
  const auto p = from_a(b), q = from_a(c), r = from_a(d);
  return p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
             p[2] * (q[0] * r[1] - q[1] * r[0]) >
         0;
}

// Of a regular polygon with the given circumradius.
double polygon_area(double radius, int corners) {
  return corners * radius * radius * std::sin(2 * std::numbers::pi / corners) / 2;
}

}  // namespace

TEST_CASE("a box gives the same four points in every layer") {
  const std::vector<Slice> slices = slices_of(parts::box({1, 2, 3}, 20, 15, 10));
  REQUIRE_EQ(slices.size(), 50);
  for (std::size_t i = 0; i < slices.size(); ++i) {
    CHECK_EQ(slices[i].index, static_cast<core::LayerIndex>(i));
    CHECK_EQ(slices[i].bottom.units(), static_cast<std::int64_t>(i) * 2'000);
    CHECK_EQ(slices[i].height.units(), 2'000);
    CHECK_EQ(slices[i].region, test::region_from_text("1:2 21:2 21:17 1:17"));
    CHECK_FALSE(slices[i].defects.any());
  }
}

TEST_CASE("the pyramid's slices are scaled bases") {
  const std::vector<Slice> slices = slices_of(parts::pyramid(10));
  REQUIRE_EQ(slices.size(), 50);
  for (const Slice& slice : slices) {
    const double scale = 1 - middle_mm(slice) / 10;
    CHECK(slice.region.area_mm2() == doctest::Approx(6000 * scale * scale).epsilon(1e-4));
    CHECK_EQ(slice.region.point_count(), 4);
    const core::Box box = slice.region.box();
    CHECK(std::abs(box.min.x - 120'000 * (1 - scale)) <= 1);
    CHECK(std::abs(box.max.x - (1'000'000 - 880'000 * (1 - scale))) <= 1);
  }
}

TEST_CASE("the dome's slices are polygons between the rings of its mesh") {
  constexpr int kSegments = 64, kRings = 32;
  const std::vector<Slice> slices = slices_of(parts::dome(25, kSegments, kRings));
  REQUIRE_EQ(slices.size(), 125);
  for (const Slice& slice : slices) {
    const double z = middle_mm(slice);
    const int ring = static_cast<int>(std::asin(z / 25) / (std::numbers::pi / 2) * kRings);
    const auto at = [](int k) { return std::numbers::pi / 2 * k / kRings; };
    const double z0 = 25 * std::sin(at(ring)), z1 = 25 * std::sin(at(ring + 1));
    const double r0 = 25 * std::cos(at(ring)), r1 = 25 * std::cos(at(ring + 1));
    const double radius = r0 + (r1 - r0) * (z - z0) / (z1 - z0);
    CAPTURE(z);
    // Points that are left out, and rounding, move the contour by at most 2 units.
    CHECK(std::abs(slice.region.area_mm2() - polygon_area(radius, kSegments)) <=
          2e-4 * slice.region.perimeter_mm());
    CHECK_EQ(slice.region.rings().size(), 1);
  }
}

TEST_CASE("a tube has a hole, and equal walls give equal slices") {
  const std::vector<Slice> slices = slices_of(parts::tube(10, 6, 20, 97));
  REQUIRE_EQ(slices.size(), 100);
  const double area = polygon_area(10, 97) - polygon_area(6, 97);
  CHECK(slices[0].region.area_mm2() == doctest::Approx(area).epsilon(1e-5));
  CHECK_EQ(slices[0].region.rings().size(), 2);
  CHECK_EQ(slices[0].region.point_count(), 2 * 97);
  for (const Slice& slice : slices) CHECK_EQ(slice.region, slices[0].region);
}

TEST_CASE("the demo part's slices add up to its volume") {
  double volume = 0, perimeter = 0;
  for (const Slice& slice : slices_of(parts::demo())) {
    CHECK(test::is_clean(slice.region));
    volume += slice.region.area_mm2() * slice.height.mm();
    perimeter += slice.region.perimeter_mm();
  }
  double exact = 0;
  parts::demo()([&exact](const parts::Facet& f) {
    const auto& [a, b, c] = f;
    exact += (a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) +
              a.z * (b.x * c.y - b.y * c.x)) /
             6;
  });
  CHECK(volume == doctest::Approx(exact).epsilon(1e-3));
  CHECK(perimeter > 1000);
}

TEST_CASE("planes through corners, edges and flat facets") {
  // Every ring of the mesh lies in the plane of a layer: at (i + ½) · 0.2 mm.
  const parts::Part raised_rings = [](const parts::FacetSink& sink) {
    for (int i = 0; i < 10; ++i) {
      parts::box({2.0 * i, 0, 0}, 1, 5, 0.1 + 0.2 * i)(sink);
      parts::box({2.0 * i, 10, 0}, 1, 5, 0.2 + 0.2 * i)(sink);
    }
  };
  const std::vector<Slice> slices = slices_of(raised_rings);
  REQUIRE_EQ(slices.size(), 10);
  for (std::size_t i = 0; i < slices.size(); ++i) {
    CAPTURE(i);
    // A top in the plane counts as above it, so it is cut just below.
    CHECK(slices[i].region.area_mm2() ==
          doctest::Approx(5.0 * (10 - static_cast<double>(i)) * 2).epsilon(1e-9));
    CHECK_FALSE(slices[i].defects.any());
    CHECK(test::is_clean(slices[i].region));
  }
}

TEST_CASE("a bottom in the plane is above it") {
  // 0.3 mm above the first box's foot: in the plane of layer 1, which it doesn't reach.
  const std::vector<Slice> slices = slices_of(
      parts::together({parts::box({0, 0, 0}, 5, 5, 0.2), parts::box({10, 0, 0.3}, 5, 5, 1)}));
  REQUIRE_EQ(slices.size(), 7);
  CHECK_EQ(slices[0].region, test::region_from_text("0:0 5:0 5:5 0:5"));
  CHECK(slices[1].region.empty());
  CHECK_EQ(slices[2].region, test::region_from_text("10:0 15:0 15:5 10:5"));
  CHECK_EQ(slices[6].region, test::region_from_text("10:0 15:0 15:5 10:5"));
}

TEST_CASE("a gap in height comes out as empty slices") {
  const std::vector<Slice> slices = slices_of(test::part_named("gap"));
  REQUIRE_EQ(slices.size(), 40);
  for (std::size_t i = 0; i < 40; ++i) {
    CHECK_EQ(slices[i].region.empty(), i >= 10 && i < 30);
    CHECK_EQ(slices[i].index, static_cast<core::LayerIndex>(i));
  }
}

TEST_CASE("mirrored and upside down, a part stays the same part") {
  const std::vector<Triangle> triangles = triangles_of(parts::demo());
  std::int64_t height = 0;
  for (const Triangle& t : triangles) height = std::max(height, t.highest_z());
  // A whole number of layers, so that the planes come to lie in the same places.
  REQUIRE_EQ(height % 2'000, 0);
  std::vector<Triangle> turned = triangles, inside_out = triangles;
  for (Triangle& t : turned) {
    for (core::Vertex& corner : t.corners) corner = {-corner.x, corner.y, height - corner.z};
  }
  for (Triangle& t : inside_out) std::swap(t.corners[0], t.corners[1]);
  const std::vector<Slice> slices = sweep(triangles, exact_options()).slices;
  const std::vector<Slice> turned_slices = sweep(turned, exact_options()).slices;
  const std::vector<Slice> inside_out_slices = sweep(inside_out, exact_options()).slices;
  REQUIRE_EQ(slices.size(), turned_slices.size());
  for (std::size_t i = 0; i < slices.size(); ++i) {
    CAPTURE(i);
    const Region& other = turned_slices[slices.size() - 1 - i].region;
    CHECK(slices[i].region.area_mm2() == doctest::Approx(other.area_mm2()).epsilon(1e-5));
    CHECK(test::widest_difference(slices[i].region, inside_out_slices[i].region) == 0);
    CHECK_FALSE(inside_out_slices[i].defects.any());
  }
}

TEST_CASE("one facet missing: the box stays whole, whichever facet it is") {
  const Region whole = test::region_from_text("0:0 20:0 20:20 0:20");
  for (std::int64_t missing = 0; missing < 12; ++missing) {
    CAPTURE(missing);
    const parts::Part part =
        parts::edited(parts::box({0, 0, 0}, 20, 20, 10), [missing](const auto& facet, auto number) {
          return number == missing ? std::vector<parts::Facet>{} : std::vector{facet};
        });
    const std::vector<Slice> slices = slices_of(part);
    REQUIRE_EQ(slices.size(), 50);
    for (const Slice& slice : slices) CHECK_EQ(slice.region, whole);
    // The first four facets are the bottom and the top, which no plane crosses.
    const SliceDefects defects = all_defects(slices);
    CHECK_EQ(defects.closed_chains, missing < 4 ? 0 : 50);
    CHECK_EQ(defects.dropped_chains, 0);
    CHECK_EQ(defects.widest_gap.units(), missing < 4 ? 0 : 198'000);
  }
}

TEST_CASE("flipped, doubled and inside-out facets are taken as a person would take them") {
  const Region box = test::region_from_text("0:0 20:0 20:20 0:20");
  struct Expected {
    std::string name;
    std::int64_t flipped_a_layer, doubled_a_layer;
  };
  for (const Expected& expected : {Expected{"flipped_all", 0, 0}, Expected{"flipped_some", 2, 0},
                                   Expected{"doubled", 0, 1}, Expected{"zero_area", 0, 0}}) {
    CAPTURE(expected.name);
    const std::vector<Slice> slices = slices_of(test::part_named(expected.name));
    REQUIRE_EQ(slices.size(), 50);
    for (const Slice& slice : slices) {
      CHECK_EQ(slice.region, box);
      CHECK_EQ(slice.defects.flipped_facets, expected.flipped_a_layer);
      CHECK_EQ(slice.defects.doubled_facets, expected.doubled_a_layer);
      CHECK_EQ(slice.defects.closed_chains + slice.defects.dropped_chains, 0);
    }
  }
  CHECK_EQ(slices_of(test::part_named("inside_out_shell"))[20].region.area_mm2(),
           doctest::Approx(300));
  CHECK_EQ(slices_of(test::part_named("crossing_boxes"))[40].region.area_mm2(),
           doctest::Approx(700));
  CHECK_EQ(slices_of(test::part_named("touching_edge"))[40].region.area_mm2(),
           doctest::Approx(800));
}

TEST_CASE("a body that is inside out and higher than what is around it is told") {
  const parts::Part pin =
      parts::edited(parts::box({5, 5, 0}, 10, 10, 20), [](const parts::Facet& facet, std::int64_t) {
        return std::vector<parts::Facet>{parts::flipped(facet)};
      });
  const std::vector<Slice> slices =
      slices_of(parts::together({parts::box({0, 0, 0}, 20, 20, 10), pin}));
  REQUIRE_EQ(slices.size(), 100);
  // Nothing tells a hole from it below; above it stands alone.
  CHECK_FALSE(slices[10].defects.any());
  CHECK_EQ(slices[60].defects.turned_contours, 1);
  CHECK_EQ(slices[60].region.area_mm2(), doctest::Approx(100));
  for (const Slice& slice : slices_of(pin)) CHECK_FALSE(slice.defects.any());
}

TEST_CASE("every single facet flipped or doubled, either way round, leaves the part as it is") {
  const std::vector<Triangle> sound = triangles_of(parts::tube(10, 6, 2, 9));
  const std::vector<Slice> expected = sweep(sound, exact_options()).slices;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    for (int kind = 0; kind < 3; ++kind) {
      CAPTURE(i);
      CAPTURE(kind);
      std::vector<Triangle> mesh = sound;
      if (kind > 0) mesh.push_back(mesh[i]);
      if (kind != 1) std::swap(mesh[i].corners[0], mesh[i].corners[1]);
      const std::vector<Slice> slices = sweep(mesh, exact_options()).slices;
      for (std::size_t layer = 0; layer < slices.size(); ++layer) {
        CHECK_EQ(slices[layer].region, expected[layer].region);
        CHECK_EQ(slices[layer].defects.closed_chains, 0);
      }
      const SliceDefects defects = all_defects(slices);
      const bool is_cut = sound[i].lowest_z() != sound[i].highest_z();
      const std::int64_t count = is_cut ? static_cast<std::int64_t>(slices.size()) : 0;
      CHECK_EQ(kind == 0 ? defects.flipped_facets : defects.doubled_facets, count);
    }
  }
}

TEST_CASE("only what crosses the plane is held") {
  CHECK_EQ(sweep(triangles_of(parts::tower(100)), exact_options()).peak_triangles_held, 256);
  CHECK_EQ(sweep(triangles_of(parts::tower(1000)), exact_options()).peak_triangles_held, 256);
}

TEST_CASE("a part 500 km tall: heights have no bound") {
  const double far_up_mm = 5e8;
  std::vector<Triangle> triangles = triangles_of(parts::pyramid(far_up_mm));
  PlaneSweep::Options options = exact_options();
  options.heights = {Length::from_mm(1e8), Length::from_mm(1e8)};
  const std::vector<Slice> slices = sweep(triangles, options).slices;
  REQUIRE_EQ(slices.size(), 5);
  for (std::size_t i = 0; i < 5; ++i) {
    const double scale = 1 - (static_cast<double>(i) + 0.5) / 5;
    CHECK(slices[i].region.area_mm2() == doctest::Approx(6000 * scale * scale).epsilon(1e-6));
  }
}

TEST_CASE("sections of random closed bodies, oracle: winding numbers by brute force") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const auto corner = [&random] {
      return core::Vertex{random.integer(-40'000, 40'000), random.integer(-40'000, 40'000),
                          random.integer(0, 20'000)};
    };
    std::vector<Triangle> triangles;
    // All of one seed are turned the same way: others would be turned by inside_out.h.
    const bool outwards = seed % 2 == 0;
    for (int body = random.integer(1, 8); body > 0; --body) {
      core::Vertex a = corner(), b = corner();
      const core::Vertex c = corner(), d = corner();
      if (looks_outwards(a, b, c, d) != outwards) std::swap(a, b);
      for (const Triangle& t :
           {Triangle{{a, c, b}}, Triangle{{a, b, d}}, Triangle{{b, c, d}}, Triangle{{c, a, d}}}) {
        triangles.push_back(t);
      }
    }
    for (const Slice& slice : sweep(triangles, exact_options()).slices) {
      CHECK(test::is_clean(slice.region));
      CHECK_FALSE(slice.defects.any());
      // Each facet's cut in floating point, as a ring of its own that goes by a far point: the
      // windings of all of them add up to the section's.
      const double z = static_cast<double>(slice.bottom.units()) + 1'000;
      std::vector<std::array<double, 4>> cuts;
      for (const Triangle& t : triangles) {
        std::array<double, 4> cut{};
        bool crosses = false;
        for (std::size_t i = 0; i < 3; ++i) {
          const core::Vertex &p = t.corners[i], &q = t.corners[(i + 1) % 3];
          const double pz = static_cast<double>(p.z), qz = static_cast<double>(q.z);
          if ((pz >= z) == (qz >= z)) continue;
          crosses = true;
          const double share = (z - pz) / (qz - pz);
          const std::size_t place = pz >= z ? 0 : 2;
          cut[place] = p.x + share * (q.x - p.x);
          cut[place + 1] = p.y + share * (q.y - p.y);
        }
        if (crosses) cuts.push_back(cut);
      }
      for (int probe = 0; probe < 50; ++probe) {
        const double x = random.between(-40'000, 40'000), y = random.between(-40'000, 40'000);
        int winding = 0;
        bool near = false;
        for (const auto& [x0, y0, x1, y1] : cuts) {
          const double length = std::hypot(x1 - x0, y1 - y0);
          const double side = (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0);
          near = near || std::abs(side) <= 3 * length;
          if ((y0 <= y) != (y1 <= y)) winding += (y1 > y0) == (side > 0) ? (y1 > y0 ? 1 : -1) : 0;
        }
        if (near) continue;
        const core::Point point{static_cast<std::int32_t>(std::lround(x)),
                                static_cast<std::int32_t>(std::lround(y))};
        CHECK_EQ(slice.region.contains(point), winding != 0);
      }
    }
  }
}
