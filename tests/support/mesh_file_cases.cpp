#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tests/support/file_cases.h"
#include "tests/support/mesh_files.h"

namespace test {
namespace {

using parts::box;
using parts::Corner;
using parts::Facet;
using parts::Part;
using parts::together;

constexpr double kBox = 4'000;

FileCase mesh(const std::string& name, const Part& part, double volume_mm3, int layers,
              std::vector<std::string> says = {}) {
  return {name + ".stl", stl_file(part), volume_mm3, layers, std::move(says)};
}

Part facets(std::vector<Facet> all) {
  return [all = std::move(all)](const parts::FacetSink& sink) {
    for (const Facet& facet : all) sink(facet);
  };
}

// Both halves of a rectangle.
std::vector<Facet> rectangle(Corner a, Corner b, Corner c, Corner d) {
  return {{a, b, c}, {a, c, d}};
}

Part without(const Part& part, std::vector<std::int64_t> numbers) {
  return parts::edited(part, [numbers](const Facet& facet, std::int64_t number) {
    const bool gone = std::find(numbers.begin(), numbers.end(), number) != numbers.end();
    return gone ? std::vector<Facet>{} : std::vector<Facet>{facet};
  });
}

// The box's wall at x = 20 from four facets around a corner in its middle, that each has elsewhere.
Part cracked(double off) {
  const Corner a{20, 0, 0}, b{20, 20, 0}, c{20, 20, 10}, d{20, 0, 10};
  const Part rest = parts::edited(case_box(), [](const Facet& facet, std::int64_t) {
    for (const Corner& corner : facet) {
      if (corner.x != 20) return std::vector<Facet>{facet};
    }
    return std::vector<Facet>{};
  });
  return together({rest, facets({{Corner{20, 10 + off, 5}, a, b},
                                 {Corner{20, 10, 5}, b, c},
                                 {Corner{20, 10, 5 + off}, c, d},
                                 {Corner{20, 10 - off, 5}, d, a}})});
}

// Walls 50 mm long that cross and lie over one another.
Part grid(double width) {
  std::vector<Part> walls;
  for (int i = 0; i < 6; ++i) {
    const double at = 10.0 * i + 1;
    walls.push_back(box({at, 1, 0}, width, 50 + width, 3));
    walls.push_back(box({1, at, 0}, 50 + width, width, 3));
  }
  return together(walls);
}

double grid_volume(double width) { return 3 * (12 * width * (50 + width) - 36 * width * width); }

// A wall bent to a ring, its points off by up to `jitter`, each time the same.
Part rough_ring(int points, double jitter) {
  const auto ring = [points, jitter](double radius, double z, int i) {
    const double angle = 2 * std::numbers::pi * (i % points) / points;
    const double r = radius + jitter * std::sin(12.9898 * (i % points) + 78.233 * radius);
    return Corner{50 + r * std::cos(angle), 50 + r * std::sin(angle), z};
  };
  return [ring, points](const parts::FacetSink& sink) {
    for (int i = 0; i < points; ++i) {
      const Corner a = ring(40, 0, i), b = ring(40, 0, i + 1), c = ring(40, 1, i + 1),
                   d = ring(40, 1, i);
      const Corner e = ring(38.7, 0, i), f = ring(38.7, 0, i + 1), g = ring(38.7, 1, i + 1),
                   h = ring(38.7, 1, i);
      for (const Facet& facet : {Facet{a, b, c}, Facet{a, c, d}, Facet{f, e, h}, Facet{f, h, g},
                                 Facet{d, c, g}, Facet{d, g, h}, Facet{b, a, e}, Facet{b, e, f}}) {
        sink(facet);
      }
    }
  };
}

// Inner walls, or what else lies within the radius around the middle of a tube of 10 mm.
Part turned_within(const Part& part, double radius) {
  return parts::edited(part, [radius](const Facet& facet, std::int64_t) {
    for (const Corner& corner : facet) {
      if (std::hypot(corner.x - 11, corner.y - 11) > radius) return std::vector<Facet>{facet};
    }
    return std::vector<Facet>{parts::flipped(facet)};
  });
}

double polygon_area(double radius, int corners) {
  return corners * radius * radius * std::sin(2 * std::numbers::pi / corners) / 2;
}

}  // namespace

Part case_box() { return box({0, 0, 0}, 20, 20, 10); }

Part inside_out(Part part) {
  return parts::edited(std::move(part), [](const Facet& facet, std::int64_t) {
    return std::vector<Facet>{parts::flipped(facet)};
  });
}

Part prism(const std::vector<Corner>& polygon, double height) {
  return [polygon, height](const parts::FacetSink& sink) {
    const auto up = [height](Corner c) { return Corner{c.x, c.y, c.z + height}; };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Corner a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      sink({a, b, up(b)});
      sink({a, up(b), up(a)});
      if (i == 0 || i + 1 == polygon.size()) continue;
      sink({polygon[0], b, a});
      sink({up(polygon[0]), up(a), up(b)});
    }
  };
}

std::vector<FileCase> mesh_cases() {
  const Part one = case_box();
  const std::vector<Facet> sheet = rectangle({5, 10, 2}, {15, 10, 2}, {15, 10, 8}, {5, 10, 8});
  std::vector<FileCase> cases = {
      mesh("below_bed", box({0, 0, -5}, 20, 20, 10), kBox, 50),
      mesh("thin_tip", prism({{0, 0, 0}, {30, 0, 0}, {0, 0.8, 0}}, 2), 24, 10),
      mesh("crack", cracked(0.0005), kBox, 50),
      mesh("t_junction", cracked(0), kBox, 50),
      mesh("duplicate", together({one, one}), kBox, 50),
      mesh("triple", together({one, one, one}), kBox, 50),
      mesh("duplicate_shifted", together({one, box({0.001, 0.001, 0}, 20, 20, 10)}), kBox, 50),
      mesh("overlap", together({one, box({10, 5, 0}, 25, 10, 10)}), 5'500, 50),
      mesh("touch_edge", together({one, box({20, 20, 0}, 20, 20, 10)}), 2 * kBox, 50),
      mesh("touch_face", together({one, box({20, 0, 0}, 20, 20, 10)}), 2 * kBox, 50),
      mesh("touch_face_1um", together({one, box({20.001, 0, 0}, 20, 20, 10)}), 2 * kBox, 50),
      mesh("touch_face_20um", together({one, box({20.02, 0, 0}, 20, 20, 10)}), 2 * kBox, 50),
      mesh("stack_gap", together({one, box({0, 0, 10.001}, 20, 20, 10)}), 2 * kBox, 100),
      mesh("stack_overlap", together({one, box({0, 0, 9.95}, 20, 20, 10.05)}), 2 * kBox, 100),
      mesh("sheet_within", together({one, facets(sheet)}), kBox, 50),
      mesh("double_sheet_within", together({one, facets(sheet), inside_out(facets(sheet))}), kBox,
           50),
      mesh("sheet_across",
           together({one, facets(rectangle({0, 10, 0}, {20, 10, 0}, {20, 10, 10}, {0, 10, 10}))}),
           kBox, 50),
      mesh("level_sheet",
           together(
               {one, facets(rectangle({2, 2, 5.1}, {18, 2, 5.1}, {18, 18, 5.1}, {2, 18, 5.1}))}),
           kBox, 50),
      mesh("open_one_facet", without(one, {4}), kBox, 50, {"wider than chain_gap_max"}),
      mesh("open_side", without(one, {4, 5}), kBox, 50,
           {"widest gap 20 mm", "50 of them wider than chain_gap_max"}),
      mesh("open_top", without(one, {2, 3}), kBox, 50),
      mesh("grid_0.4", grid(0.4), grid_volume(0.4), 15),
      mesh("grid_0.6", grid(0.6), grid_volume(0.6), 15),
      mesh("void", together({box({0, 0, 0}, 20, 20, 20), inside_out(box({5, 5, 5}, 10, 10, 10))}),
           7'000, 100),
      mesh("body_in_a_body", together({box({0, 0, 0}, 20, 20, 20), box({5, 5, 5}, 10, 10, 10)}),
           8'000, 100),
      mesh("rough_ring", rough_ring(1'024, 0.01),
           polygon_area(40, 1'024) - polygon_area(38.7, 1'024), 5),
      mesh("flat_text", together({box({0, 0, 0}, 0.5, 8, 0.2), box({3, 0, 0}, 0.5, 8, 0.2)}), 1.6,
           1),
      // Layers are cut halfway: planes at 0.1, 0.3 mm … see the step's corners on them as above.
      mesh("step_0.3", together({one, box({5, 5, 10}, 10, 10, 0.3)}), kBox + 40, 52),
      mesh("inches", box({0, 0, 0}, 0.7874, 0.7874, 0.3937), 0.7874 * 0.7874 * 0.4, 2,
           {"metres", "by 1000", "inches", "25.4"}),
      mesh("metres", box({0, 0, 0}, 0.02, 0.02, 0.01), 0, 0,
           {"less than half a layer", "metres (scale it by 1000)", "inches"}),
      mesh("two_inches", box({0, 0, 0}, 2, 1, 1), 2, 5, {"inches"}),
  };
  for (const double width : {0.2, 0.1999, 0.201, 0.25}) {
    cases.push_back(
        mesh("wall_" + std::to_string(width), box({0, 0, 0}, 20, width, 5), 100 * width, 25));
  }
  cases.push_back(mesh("wall_0.19", box({0, 0, 0}, 20, 0.19, 5), 0, 0, {"road_width_min"}));
  const double c = std::cos(0.5) * 20, s = std::sin(0.5) * 20;
  cases.push_back(mesh(
      "slanted_wall",
      prism(
          {{1, 0, 0}, {1 + c, s, 0}, {1 + c - s / 100, s + c / 100, 0}, {1 - s / 100, c / 100, 0}},
          5),
      20, 25));
  return cases;
}

std::vector<FileCase> inside_out_cases() {
  const Part one = case_box(), other = box({10, 5, 0}, 25, 10, 10);
  const Part tube = parts::tube(10, 5, 10, 64);
  const double tube_volume = 10 * (polygon_area(10, 64) - polygon_area(5, 64));
  const std::string turned = "inside-out contour";
  return {
      mesh("all_inside_out", inside_out(one), kBox, 50),
      mesh("void_all_inside_out",
           inside_out(
               together({box({0, 0, 0}, 20, 20, 20), inside_out(box({5, 5, 5}, 10, 10, 10))})),
           7'000, 100),
      mesh("duplicate_inside_out", together({one, inside_out(one)}), kBox, 50, {"doubled"}),
      mesh("duplicate_shifted_inside_out",
           together({one, inside_out(box({0.001, 0.001, 0}, 20, 20, 10))}), kBox, 50, {turned}),
      mesh("touch_inside_out", together({one, inside_out(box({20, 5, 0}, 20, 10, 10))}), 6'000, 50,
           {turned}),
      mesh("triple_one_inside_out", together({one, inside_out(one), one}), kBox, 50),
      mesh("one_of_two", together({one, inside_out(box({30, 0, 0}, 20, 20, 10))}), 2 * kBox, 50,
           {turned, "on the bed"}),
      mesh("overlap_second", together({one, inside_out(other)}), 5'500, 50, {turned}),
      mesh("overlap_first", together({inside_out(one), other}), 5'500, 50, {turned}),
      mesh("overlap_corner", together({one, inside_out(box({19, 19, 0}, 10, 10, 10))}), kBox + 990,
           50, {turned}),
      mesh("three_one_inside_out", together({one, inside_out(other), box({15, 0, 0}, 5, 40, 10)}),
           5'500 + 1'000, 50, {turned}),
      mesh("three_two_inside_out",
           together({inside_out(one), inside_out(other), box({15, 0, 0}, 5, 40, 10)}),
           5'500 + 1'000, 50, {turned}),
      // A box with a void, inside out as a whole, over the end of a sound one.
      mesh("overlap_with_void",
           together({one, inside_out(together({box({15, 0, 0}, 30, 20, 10),
                                               inside_out(box({25, 5, 2}, 10, 10, 6))}))}),
           9'000 - 600, 50, {turned}),
      // A sound box with a bore, whose other end is in a box that is inside out.
      mesh("void_beside_overlap",
           together({one, inside_out(box({5, 5, 2}, 4, 4, 6)), inside_out(other)}), 5'500 - 96, 50,
           {turned}),
      mesh("body_in_a_void",
           together({box({0, 0, 0}, 20, 20, 20), inside_out(box({3, 3, 3}, 14, 14, 14)),
                     inside_out(box({6, 6, 3}, 8, 8, 14))}),
           8'000 - 2'744 + 896, 100, {turned}),
      mesh("bore_turned", turned_within(tube, 5.1), tube_volume, 50,
           {"turned against their neighbours", "inside-out"}),
      mesh("outside_turned",
           parts::edited(tube,
                         [](const Facet& facet, std::int64_t) {
                           bool outer = true;
                           for (const Corner& c : facet) {
                             outer = outer && std::hypot(c.x - 11, c.y - 11) > 9;
                           }
                           return std::vector<Facet>{outer ? parts::flipped(facet) : facet};
                         }),
           tube_volume, 50, {"turned against their neighbours"}),
      mesh("facet_turned",
           parts::edited(one,
                         [](const Facet& facet, std::int64_t number) {
                           return std::vector<Facet>{number == 6 ? parts::flipped(facet) : facet};
                         }),
           kBox, 50, {"3 edges", "mm in the file"}),
      mesh("lid_turned",
           parts::edited(one,
                         [](const Facet& facet, std::int64_t number) {
                           const bool top = number == 2 || number == 3;
                           return std::vector<Facet>{top ? parts::flipped(facet) : facet};
                         }),
           kBox, 50, {"4 edges"}),
  };
}

}  // namespace test
