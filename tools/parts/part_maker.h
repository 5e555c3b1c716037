// Makes parts for trials, tests and benches, facet by facet: memory does not grow with the part.
//
// A part is a function that passes its facets, counter-clockwise seen from outside, to a sink. It
// gives the same facets each time it is run. Lengths are in mm. Sound parts are closed, stand on
// z = 0 and have positive x and y. The description of a faulty part says what is wrong with it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace parts {

struct Corner {
  double x = 0;
  double y = 0;
  double z = 0;
};

using Facet = std::array<Corner, 3>;
using FacetSink = std::function<void(const Facet&)>;
using Part = std::function<void(const FacetSink&)>;

// Corners x, y, z and x + width, y + depth, z + height; 12 facets, in the order bottom, top, and
// the four sides from y outwards, counter-clockwise.
[[nodiscard]] Part box(Corner at, double width, double depth, double height);

// Low and asymmetric: its right face rises at 6.5° if it is 10 mm high.
[[nodiscard]] Part pyramid(double height);

// Hemisphere on its flat side.
[[nodiscard]] Part dome(double radius, int segments = 128, int rings = 64);

// With a bore from end to end.
[[nodiscard]] Part tube(double outer_radius, double inner_radius, double height, int segments);

// Hexagon-head bolt, head down, M28 × 6; the thread's flanks rise at 25.6°.
[[nodiscard]] Part screw();

// The same thread without a head, `turns` × 6 mm long. REQUIRES: diameter > 12, turns >= 2.
[[nodiscard]] Part set_screw(double diameter, int turns);

// Twisted, lobed, with a vertical bore; `layers` layers of 0.2 mm, 2 · corners points in every
// section. Facets come in order of height.
struct TowerSize {
  std::int64_t layers = 1'000;
  int corners = 64;
  double scale = 1;  // across
};
[[nodiscard]] Part tower(const TowerSize& size);
[[nodiscard]] Part tower(std::int64_t layers);

// Upright square teeth on the bed, 1.6 mm wide and 1 mm high: a plane crosses 8 facets of each.
[[nodiscard]] Part comb(int teeth);

// Bumpy vase, a bumpy tube in its bore and six around it; 720,000 facets at detail 1.
[[nodiscard]] Part vase(double detail);

// columns × columns square columns on one plate.
[[nodiscard]] Part lattice(int columns);

// A round shaft with a shelf all round every 10 layers of 0.2 mm: it overhangs all the way up.
// Facets come in order of height.
[[nodiscard]] Part shelves(std::int64_t layers);

// A stem 10 mm tall under a cap: a hemisphere whose flat side hangs.
[[nodiscard]] Part mushroom();

// Flat where it stands, 15° around its pole.
[[nodiscard]] Part sphere(double radius);

// 20 mm deep; its right side leans outwards by the angle, from 2 mm up, `height` mm high.
[[nodiscard]] Part ramp(double angle_degrees, double height);

// Half a ring on two legs, 10 mm deep.
[[nodiscard]] Part arch(double span);

// A deck 3 mm thick on a post 12 mm high, 8 mm beyond it on either side.
[[nodiscard]] Part tee();

// Hose fitting, 25 mm tall: a hexagon flange, a slope, two barbs that overhang, and a bore.
[[nodiscard]] Part demo();

// Hard ones: columns × columns round pins; a plate with as many round holes; one with as many
// pockets of rough outline, as of engraved text; as many pyramids, so that all facets have the same
// lowest z. A ring 1.3 mm thick, its corners off by up to 10 µm, as a scan has them. A Koch curve.
// A strip 0.6 mm wide in a spiral. Thin tubes around one another. A sheet between two labyrinths;
// 600,000 facets at detail 2. Facets at random.
[[nodiscard]] Part pins(int columns);
[[nodiscard]] Part perforated(int columns);
[[nodiscard]] Part engraved(int columns);
[[nodiscard]] Part spikes(int columns);
[[nodiscard]] Part noisy_ring(int corners);
[[nodiscard]] Part koch(int level);
[[nodiscard]] Part spiral(int turns);
[[nodiscard]] Part tubes(int count);
[[nodiscard]] Part gyroid(double detail);
[[nodiscard]] Part soup(int facets);

// Such as people print: an angle bracket with holes, a slot, a fillet and two ribs; a case with
// thin walls, ribs, posts for screws and slots; a sign with raised letters; a figure of balls that
// run into one another.
[[nodiscard]] Part bracket();
[[nodiscard]] Part electronics_case();
[[nodiscard]] Part sign();
[[nodiscard]] Part figure(double detail);

// The facets of all parts, one part after the other.
[[nodiscard]] Part together(std::vector<Part> all);

// The facets of `part`, each replaced by the result of `edit`: none, one or more. Numbered from 0.
using FacetEdit = std::function<std::vector<Facet>(const Facet&, std::int64_t number)>;
[[nodiscard]] Part edited(Part part, FacetEdit edit);

// The same facet seen from behind.
[[nodiscard]] Facet flipped(const Facet& facet);

struct NamedPart {
  std::string name;
  std::string description;
  Part part;
};

// Every part that make_part knows; `detail` is that of vase, gyroid and figure.
struct PartSizes {
  TowerSize tower;
  double detail = 1;
  int teeth = 6'250;
  int columns = 8;  // of pins, holes, pockets and spikes
  int turns = 6;    // of the spiral; tubes
  int level = 4;    // of the Koch curve
};
[[nodiscard]] std::vector<NamedPart> all_parts(const PartSizes& sizes);
[[nodiscard]] std::vector<NamedPart> all_parts(std::int64_t layers = 1000, double detail = 1);

[[nodiscard]] std::int64_t count_facets(const Part& part);

// Runs the part twice, to write the number of facets first: `out` need not be seekable. Uncounted,
// it runs the part once, and the number is 0; so it is for more facets than the format can count.
void write_binary_stl(const Part& part, std::ostream& out, bool counted = true);
void write_ascii_stl(const Part& part, std::ostream& out);

}  // namespace parts
