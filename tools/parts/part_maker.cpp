#include "tools/parts/part_maker.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <ostream>
#include <utility>

namespace parts {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kFacetBytes = 50;

void put_u32(char* to, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) to[i] = static_cast<char>(value >> (8 * i) & 0xFF);
}

void put_corner(char* to, const Corner& corner) {
  put_u32(to, std::bit_cast<std::uint32_t>(static_cast<float>(corner.x)));
  put_u32(to + 4, std::bit_cast<std::uint32_t>(static_cast<float>(corner.y)));
  put_u32(to + 8, std::bit_cast<std::uint32_t>(static_cast<float>(corner.z)));
}

Corner normal(const Facet& facet) {
  const auto& [a, b, c] = facet;
  const Corner u{b.x - a.x, b.y - a.y, b.z - a.z};
  const Corner v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Corner n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  if (!(length > 0)) return {};
  return {n.x / length, n.y / length, n.z / length};
}

Part sound_box() { return box({0, 0, 0}, 20, 20, 10); }

// Steps that end at whole and at half layers: facets in the plane of a cut.
Part stairs() {
  std::vector<Part> steps;
  for (int i = 0; i < 10; ++i) steps.push_back(box({10.0 * i, 0, 0}, 8, 20, 2 + 0.1 * i));
  return together(std::move(steps));
}

// A ring 1 mm thick, and ribs in it.
Part thin_walls() {
  constexpr double kRadius = 15, kMiddle = kRadius + 1, kHeight = 4;
  std::vector<Part> all = {tube(kRadius, kRadius - 1, kHeight, 128)};
  for (const auto& [y, thickness] :
       {std::pair(-7.0, 0.5), std::pair(0.0, 0.9), std::pair(7.0, 1.4)}) {
    const double half = std::sqrt((kRadius - 0.5) * (kRadius - 0.5) - y * y);
    all.push_back(
        box({kMiddle - half, kMiddle + y - thickness / 2, 0}, 2 * half, thickness, kHeight));
  }
  return together(std::move(all));
}

// A deck on two posts, 16 mm apart.
Part bridge() {
  return together(
      {box({0, 0, 0}, 8, 14, 6), box({24, 0, 0}, 8, 14, 6), box({0, 0, 6}, 32, 14, 1.6)});
}

std::vector<NamedPart> hard_parts(const PartSizes& sizes) {
  return {
      {"pins", "round, 1.8 mm across; see --columns", pins(sizes.columns)},
      {"spikes", "pyramids, all facets from z = 0 up; see --columns", spikes(sizes.columns)},
      {"noisy_ring", "1.3 mm thick, as a scan has it: off by up to 10 um", noisy_ring(2'048)},
      {"koch", "a Koch curve; see --level", koch(sizes.level)},
      {"spiral", "a strip 0.6 mm wide; see --turns", spiral(sizes.turns)},
      {"tubes", "0.8 mm thick, around one another; see --turns", tubes(sizes.turns)},
      {"gyroid", "a sheet between two labyrinths; see --detail", gyroid(sizes.detail)},
  };
}

std::vector<NamedPart> faulty_parts() {
  const auto every_third_flipped = [](const Facet& facet, std::int64_t number) {
    return std::vector<Facet>{number % 3 == 0 ? flipped(facet) : facet};
  };
  const auto first_five_doubled = [](const Facet& facet, std::int64_t number) {
    return number < 5 ? std::vector<Facet>{facet, facet} : std::vector<Facet>{facet};
  };
  const auto all_flipped = [](const Facet& facet, std::int64_t) {
    return std::vector<Facet>{flipped(facet)};
  };
  const auto last_missing = [](const Facet& facet, std::int64_t number) {
    return number == 11 ? std::vector<Facet>{} : std::vector<Facet>{facet};
  };
  const auto flat_ones_added = [](const Facet& facet, std::int64_t number) {
    if (number != 4) return std::vector<Facet>{facet};
    const auto& [a, b, c] = facet;
    const Corner middle{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
    return std::vector<Facet>{facet, {a, b, b}, {a, a, a}, {a, middle, b}};
  };
  return {
      {"hole", "a box, one facet missing", edited(sound_box(), last_missing)},
      {"flipped_all", "a box inside out", edited(sound_box(), all_flipped)},
      {"flipped_some", "a box, every third facet flipped",
       edited(sound_box(), every_third_flipped)},
      {"doubled", "a box, five facets there twice", edited(sound_box(), first_five_doubled)},
      {"zero_area", "a box and facets without area", edited(sound_box(), flat_ones_added)},
      {"crossing_boxes", "two boxes, each partly inside the other",
       together({sound_box(), box({10, 10, 5}, 20, 20, 10)})},
      {"touching_edge", "two boxes that share an edge",
       together({sound_box(), box({20, 20, 0}, 20, 20, 10)})},
      {"inside_out_shell", "a box with a hollow",
       together({sound_box(), edited(box({5, 5, 2}, 10, 10, 5), all_flipped)})},
      {"gap", "a box hanging 4 mm above another",
       together({box({0, 0, 0}, 20, 20, 2), box({5, 5, 6}, 10, 10, 2)})},
      {"soup", "20,000 facets at random", soup(20'000)},
      {"stairs", "steps that end at whole and at half layers", stairs()},
  };
}

}  // namespace

Part together(std::vector<Part> all) {
  return [all = std::move(all)](const FacetSink& sink) {
    for (const Part& part : all) part(sink);
  };
}

Part edited(Part part, FacetEdit edit) {
  return [part = std::move(part), edit = std::move(edit)](const FacetSink& sink) {
    std::int64_t number = 0;
    part([&](const Facet& facet) {
      for (const Facet& other : edit(facet, number)) sink(other);
      ++number;
    });
  };
}

Facet flipped(const Facet& facet) { return {facet[0], facet[2], facet[1]}; }

std::vector<NamedPart> all_parts(std::int64_t layers, double detail) {
  PartSizes sizes;
  sizes.tower.layers = layers;
  sizes.detail = detail;
  return all_parts(sizes);
}

std::vector<NamedPart> all_parts(const PartSizes& sizes) {
  std::vector<NamedPart> all = {
      {"demo", "hose fitting 25 mm tall: flange, slope, overhanging barbs, bore", demo()},
      {"box", "20 x 20 x 10 mm", sound_box()},
      {"pyramid", "very short, lopsided: 100 x 60 x 10 mm", pyramid(10)},
      {"pyramid_short", "the pyramid, 18 layers of 0.2 mm high", pyramid(3.6)},
      {"dome", "hemisphere of radius 25 mm", dome(25)},
      {"screw", "hexagon-head bolt, 88 mm long", screw()},
      {"set_screw", "the same thread, thick and without a head: 44 mm across, 48 mm long",
       set_screw(44, 8)},
      {"tower", "twisted, lobed, with a bore; see --layers, --corners, --scale",
       tower(sizes.tower)},
      {"comb", "separate teeth, 8 facets of each at any height; see --teeth", comb(sizes.teeth)},
      {"vase", "bumpy tubes, 8 islands a layer; see --detail", vase(sizes.detail)},
      {"lattice", "21 x 21 columns on a plate", lattice(21)},
      {"tube", "radii 10 and 6 mm, 20 mm tall", tube(10, 6, 20, 96)},
      {"thin_walls", "a ring 1 mm thick, in it ribs of 0.5, 0.9 and 1.4 mm", thin_walls()},
      {"bridge", "a deck on two posts, 16 mm apart", bridge()},
      {"shelves", "a shaft with a shelf every 2 mm; see --layers", shelves(sizes.tower.layers)},
      {"mushroom", "a hemisphere of radius 12 mm on a stem", mushroom()},
      {"sphere", "of radius 12 mm, flat where it stands", sphere(12)},
      {"ramp_30", "a block that leans outwards by 30 degrees, 15 mm high", ramp(30, 15)},
      {"ramp_45", "by 45 degrees", ramp(45, 15)},
      {"ramp_60", "by 60 degrees", ramp(60, 15)},
      {"arch", "half a ring on two legs, 24 mm apart", arch(24)},
      {"tee", "a deck on a post, 8 mm beyond it on either side", tee()},
      {"bracket", "an angle with holes, a slot, a fillet and two ribs: 60 x 41 x 42 mm", bracket()},
      {"case", "thin walls, ribs, posts for screws, slots: 80 x 50 x 24 mm", electronics_case()},
      {"sign", "raised letters: 64 x 22 mm", sign()},
      {"figure", "balls that run into one another, 48 mm tall; see --detail", figure(sizes.detail)},
      {"perforated", "a plate with holes; see --columns", perforated(sizes.columns)},
      {"engraved", "a plate with pockets of rough outline; see --columns", engraved(sizes.columns)},
  };
  for (NamedPart& part : hard_parts(sizes)) all.push_back(std::move(part));
  for (NamedPart& part : faulty_parts()) all.push_back(std::move(part));
  return all;
}

std::int64_t count_facets(const Part& part) {
  std::int64_t count = 0;
  part([&count](const Facet&) { ++count; });
  return count;
}

void write_binary_stl(const Part& part, std::ostream& out, bool counted) {
  std::array<char, kHeaderBytes + 4> header;
  header.fill(' ');
  const std::string text = "binary STL";
  std::copy(text.begin(), text.end(), header.begin());
  const std::int64_t count = counted ? count_facets(part) : 0;
  put_u32(&header[kHeaderBytes], count <= UINT32_MAX ? static_cast<std::uint32_t>(count) : 0);
  out.write(header.data(), header.size());
  part([&out](const Facet& facet) {
    std::array<char, kFacetBytes> bytes{};
    put_corner(&bytes[0], normal(facet));
    for (std::size_t i = 0; i < 3; ++i) put_corner(&bytes[12 + 12 * i], facet[i]);
    out.write(bytes.data(), bytes.size());
  });
}

void write_ascii_stl(const Part& part, std::ostream& out) {
  const auto put = [&out](const Corner& corner) {
    out << ' ' << corner.x << ' ' << corner.y << ' ' << corner.z << '\n';
  };
  out.precision(9);
  out << "solid part\n";
  part([&](const Facet& facet) {
    out << " facet normal";
    put(normal(facet));
    out << "  outer loop\n";
    for (const Corner& corner : facet) {
      out << "   vertex";
      put(corner);
    }
    out << "  endloop\n endfacet\n";
  });
  out << "endsolid part\n";
}

}  // namespace parts
