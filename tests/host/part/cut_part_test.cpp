// A cut part equals one that was cut outside and put on the bed: boxes made in two pieces, and
// random turned parts whose facets are clipped here, in floating point.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "host/part/cut_plane.h"
#include "host/part/part_file.h"
#include "host/part/transform_words.h"
#include "tests/support/marked_files.h"
#include "tests/support/part_folder.h"
#include "tests/support/part_slices.h"
#include "tests/support/region_checks.h"

using core::Settings;
using parts::Corner;
using parts::Facet;
using test::all_slices;
using test::PartFolder;

namespace {

// Corners stay: what is clipped here has more of them.
Settings exact() {
  Settings settings;
  settings.simplify_tolerance = core::Length();
  return settings;
}

Settings cut_at(const std::string& words) {
  Settings settings = exact();
  settings.cut = words;
  return settings;
}

host::OpenedPart opened(const std::string& path, const Settings& settings,
                        const host::OpenOptions& options = {}) {
  auto part = host::open_whole_part(path, settings, options);
  REQUIRE_MESSAGE(part.ok(), (part.ok() ? "" : part.error().message));
  return std::move(part).value();
}

std::string refusal(const std::string& path, const Settings& settings) {
  const auto part = host::open_whole_part(path, settings);
  REQUIRE_FALSE(part.ok());
  CHECK(part.error().message.find(path) == 0);
  return part.error().message;
}

bool says(const host::OpenedPart& part, const std::string& word) {
  for (const std::string& warning : part.summary.warnings) {
    if (warning.find(word) != std::string::npos) return true;
  }
  return false;
}

// Slices equal but for rounding, layers and box, too.
void check_alike(host::OpenedPart& is, host::OpenedPart& should, double width_units) {
  CHECK_EQ(is.summary.layers, should.summary.layers);
  CHECK(std::abs((is.summary.height - should.summary.height).units()) <= 1);
  const core::Box &a = is.summary.box, &b = should.summary.box;
  for (const auto& [x, y] : {std::pair{a.min, b.min}, std::pair{a.max, b.max}}) {
    CHECK(std::abs(x.x - y.x) <= width_units);
    CHECK(std::abs(x.y - y.y) <= width_units);
  }
  const std::vector<core::Slice> these = all_slices(is), those = all_slices(should);
  REQUIRE_EQ(these.size(), those.size());
  for (std::size_t i = 0; i < these.size(); ++i) {
    CAPTURE(i);
    CHECK_EQ(these[i].index, those[i].index);
    CHECK_EQ(these[i].bottom, those[i].bottom);
    CHECK_EQ(these[i].height, those[i].height);
    CHECK_FALSE(these[i].defects.any());
    CHECK(test::widest_difference(these[i].region, those[i].region) <= width_units);
  }
}

// The piece of a facet on one side, without a cut face: no plane of a slice needs one.
std::vector<Facet> clipped(const Facet& facet, double z, bool upper) {
  const auto in = [&](const Corner& c) { return upper ? c.z >= z : c.z <= z; };
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner &a = facet[i], &b = facet[(i + 1) % 3];
    if (in(a)) kept.push_back(a);
    if (in(a) == in(b)) continue;
    const double t = (z - a.z) / (b.z - a.z);
    kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), z});
  }
  std::vector<Facet> pieces;
  for (std::size_t i = 2; i < kept.size(); ++i) pieces.push_back({kept[0], kept[i - 1], kept[i]});
  return pieces;
}

parts::Part piece_of(const parts::Part& part, double z, bool upper) {
  return parts::edited(part,
                       [=](const Facet& facet, std::int64_t) { return clipped(facet, z, upper); });
}

// About two axes, then lifted onto z = 0.
parts::Part turned(const parts::Part& part, double a, double b) {
  const auto turn = [=](const Corner& c) {
    const Corner d{c.x, c.y * std::cos(a) - c.z * std::sin(a),
                   c.y * std::sin(a) + c.z * std::cos(a)};
    return Corner{d.x * std::cos(b) + d.z * std::sin(b), d.y,
                  d.z * std::cos(b) - d.x * std::sin(b)};
  };
  double lowest = 1e9;
  part([&](const Facet& facet) {
    for (const Corner& c : facet) lowest = std::min(lowest, turn(c).z);
  });
  return parts::edited(part, [=](const Facet& facet, std::int64_t) {
    Facet made = facet;
    for (Corner& c : made) {
      c = turn(c);
      c.z -= lowest;
      // As a file has it: on whole units, so that both sides read the same corners.
      c = {std::round(c.x * 1e4) / 1e4, std::round(c.y * 1e4) / 1e4, std::round(c.z * 1e4) / 1e4};
    }
    return std::vector<Facet>{made};
  });
}

double height_of(const parts::Part& part) {
  double highest = 0;
  part([&](const Facet& facet) {
    for (const Corner& c : facet) highest = std::max(highest, c.z);
  });
  return highest;
}

}  // namespace

TEST_CASE("where a part is cut is read as people write it") {
  const auto read = [](const char* text) { return host::read_cut(text); };
  for (const char* none : {"", " ", "off"}) CHECK_FALSE(read(none).value());
  const std::vector<std::pair<const char*, host::CutPiece>> all = {
      {"20", host::CutPiece::kBoth},         {" 20 mm", host::CutPiece::kBoth},
      {"20 lower", host::CutPiece::kLower},  {"20mm  upper ", host::CutPiece::kUpper},
      {"20\tlower", host::CutPiece::kLower}, {"20 both", host::CutPiece::kBoth}};
  for (const auto& one : all) {
    const char* text = one.first;
    const host::CutPiece piece = one.second;
    CAPTURE(text);
    REQUIRE(read(text).ok());
    REQUIRE(read(text).value());
    CHECK_EQ(read(text).value()->height_mm, 20);
    CHECK(read(text).value()->piece == piece);
  }
  for (const char* wrong : {"0", "-1", "upper", "20 middle", "20%", "nan", "20 lower upper", "1e12",
                            "lower 20", "20,3"}) {
    CAPTURE(wrong);
    CHECK_FALSE(read(wrong).ok());
  }
}

TEST_CASE("the pieces of a box are the boxes that it was made of") {
  const PartFolder folder;
  const std::string whole = folder.add("whole.stl", parts::box({3, 4, 7}, 20, 10, 8));
  const std::string lower = folder.add("lower.stl", parts::box({3, 4, 0}, 20, 10, 3.3));
  const std::string upper = folder.add("upper.stl", parts::box({3, 4, 0}, 20, 10, 4.7));
  for (const bool adaptive : {false, true}) {
    for (const bool up : {false, true}) {
      CAPTURE(up);
      const std::string& path = up ? upper : lower;
      const std::string words = up ? "3.3 upper" : "3.3 lower";
      Settings settings;
      settings.adaptive_layer_height = adaptive;
      host::OpenedPart should = opened(path, settings);
      settings.cut = words;
      host::OpenedPart is = opened(whole, settings);
      CHECK(is.summary.warnings.empty());
      CHECK_EQ(is.summary.height, should.summary.height);
      CHECK_EQ(is.summary.highest_layer, should.summary.highest_layer);
      CHECK_EQ(is.summary.nothing_hangs, should.summary.nothing_hangs);
      check_alike(is, should, 0);
    }
  }
}

// A foot, a wide plate on top: the piece decides where it lies, and what fits.
TEST_CASE("a piece is placed by itself, and only it has to fit") {
  const PartFolder folder;
  const std::string path = folder.add(
      "part.stl",
      parts::together({parts::box({0, 0, 0}, 10, 10, 20), parts::box({30, 0, 20}, 50, 10, 4)}));
  Settings settings = cut_at("20 lower");
  settings.bed_x = settings.bed_y = core::Length::from_mm(40);
  settings.axis_z = core::Length::from_mm(21);
  host::OpenedPart foot = opened(path, settings);
  CHECK_EQ(foot.summary.box.min, core::Point{150'000, 150'000});
  CHECK_EQ(foot.summary.box.max, core::Point{250'000, 250'000});
  CHECK_EQ(foot.summary.layers, 100);
  settings.cut = "20 upper";
  CHECK(refusal(path, settings).find("50 × 10 mm, the bed 40 × 40") != std::string::npos);
  settings.cut = "off";
  CHECK(refusal(path, settings).find("80 × 10 mm") != std::string::npos);
}

TEST_CASE("random turned parts, cut at random heights, in each way of reading") {
  constexpr int kCases = 12;
  for (int seed = 0; seed < kCases; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const auto between = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    const std::vector<parts::Part> kinds = {parts::box({0, 0, 0}, 12, 9, 7), parts::tee(),
                                            parts::dome(8, 24, 12), parts::demo()};
    const parts::Part whole =
        turned(kinds[random() % kinds.size()], between(-1, 1), between(-1, 1));
    const double height = height_of(whole);
    const double z = std::round(between(0.1, 0.9) * height * 1e4) / 1e4;
    const bool upper = random() % 2 == 0;
    CAPTURE(z);
    CAPTURE(upper);
    const PartFolder folder;
    const std::string path = folder.add("whole.stl", whole);
    const std::string outside = folder.add("piece.stl", piece_of(whole, z, upper));
    // All in memory, out of order, and spilled.
    for (const std::size_t window : std::vector<std::size_t>{8'192, 2, 40}) {
      CAPTURE(window);
      host::OpenOptions options;
      options.reorder_triangles = window;
      host::OpenedPart is =
          opened(path, cut_at(std::to_string(z) + (upper ? " upper" : " lower")), options);
      host::OpenedPart should = opened(outside, exact());
      CHECK_FALSE(says(is, "turned"));
      CHECK_FALSE(says(is, "hold nothing"));
      check_alike(is, should, 4);
    }
  }
}

TEST_CASE("a file in order is read again, and its piece is not kept in memory") {
  const PartFolder folder;
  const parts::Part tower = parts::tower(parts::TowerSize{300, 64, 1});
  const std::string path = folder.add("tower.stl", tower);
  for (const bool upper : {false, true}) {
    CAPTURE(upper);
    const std::string outside = folder.add("piece.stl", piece_of(tower, 31.05, upper));
    host::OpenedPart is = opened(path, cut_at(upper ? "31.05 upper" : "31.05 lower"));
    host::OpenedPart should = opened(outside, exact());
    check_alike(is, should, 4);
    CHECK_EQ(is.counters().spilled_bytes, 0);
    CHECK(is.counters().peak_triangles_held < 600);
  }
}

TEST_CASE("the heights count after scaling, turning and shrinking") {
  const PartFolder folder;
  const std::string path = folder.add("box.stl", parts::box({0, 0, 0}, 20, 10, 8));
  Settings settings = cut_at("16 lower");
  settings.part_scale = "2";
  settings.part_rotation = "90,0,0";
  CHECK_EQ(opened(path, settings).summary.height.mm(), doctest::Approx(16));
  settings.cut = "16 upper";
  CHECK_EQ(opened(path, settings).summary.height.mm(), doctest::Approx(4));
  settings.shrinkage_z = 0.2;  // 25 mm hot, cut at 20 of them
  CHECK_EQ(opened(path, settings).summary.height.mm(), doctest::Approx(5));
}

TEST_CASE("what can't be cut is told") {
  const PartFolder folder;
  const std::string path = folder.add("box.stl", parts::box({3, 4, 0}, 20, 10, 8));
  CHECK(refusal(path, cut_at("5")).find("--cut '5 lower'") != std::string::npos);
  CHECK(refusal(path, cut_at("8 lower")).find("8 mm high") != std::string::npos);
  CHECK(refusal(path, cut_at("100 upper")).find("8 mm high") != std::string::npos);
  CHECK(refusal(path, cut_at("0.05 lower")).find("less than half a layer") != std::string::npos);
  CHECK(refusal(path, cut_at("7.95 upper")).find("less than half a layer") != std::string::npos);
}

TEST_CASE("a cut face is no hole, and a hole stays one") {
  const PartFolder folder;
  const parts::Part box = parts::box({3, 4, 0}, 20, 10, 8);
  const std::string sound = folder.add("box.stl", box);
  const std::string open =
      folder.add("open.stl", parts::edited(box, [](const Facet& facet, std::int64_t number) {
                   return number >= 6 ? std::vector<Facet>{} : std::vector<Facet>{facet};
                 }));
  host::OpenOptions refuse;
  refuse.plane_check = host::PlaneCheck::kRefuse;
  for (const char* words : {"3 lower", "3 upper"}) {
    CHECK(host::open_whole_part(sound, cut_at(words), refuse).ok());
    CHECK_FALSE(host::open_whole_part(open, cut_at(words), refuse).ok());
  }
}

namespace {

// 4 layers of 0.2 mm; the upper two are narrower.
const char* const kLayers =
    "$$HEADERSTART\n$$ASCII\n$$UNITS/1\n$$HEADEREND\n$$GEOMETRYSTART\n$$LAYER/0\n"
    "$$LAYER/0.2\n$$POLYLINE/1,1,5,5,2,25,2,25,22,5,22,5,2\n"
    "$$LAYER/0.4\n$$POLYLINE/1,1,5,5,2,25,2,25,22,5,22,5,2\n"
    "$$LAYER/0.6\n$$POLYLINE/1,1,5,5,2,15,2,15,22,5,22,5,2\n"
    "$$LAYER/0.8\n$$POLYLINE/1,1,5,5,2,15,2,15,22,5,22,5,2\n$$GEOMETRYEND\n";

}  // namespace

TEST_CASE("a file of layers is cut where a layer begins") {
  const PartFolder folder;
  const std::string path = folder.add_text("part.cli", kLayers);
  for (const auto& [words, area, layers, moved] :
       {std::tuple{"0.4 lower", 400.0, 2, false}, std::tuple{"0.4 upper", 200.0, 2, false},
        std::tuple{"0.45 lower", 400.0, 2, true}, std::tuple{"0.55 upper", 200.0, 1, true}}) {
    const std::string given = words;
    CAPTURE(given);
    host::OpenedPart part = opened(path, cut_at(words));
    CHECK_EQ(part.summary.layers, layers);
    CHECK_EQ(part.summary.height.mm(), doctest::Approx(0.2 * layers));
    CHECK_EQ(says(part, "where a layer begins"), moved);
    const std::vector<core::Slice> slices = all_slices(part);
    REQUIRE_EQ(slices.size(), layers);
    for (std::size_t i = 0; i < slices.size(); ++i) {
      CHECK_EQ(slices[i].index, i);
      CHECK_EQ(slices[i].bottom.mm(), doctest::Approx(0.2 * static_cast<double>(i)));
      CHECK_EQ(slices[i].region.area_mm2(), doctest::Approx(area));
      const core::Box box = slices[i].region.box();
      CHECK_EQ(box.min.x + box.max.x, 3'000'000);
    }
  }
  CHECK(refusal(path, cut_at("0.9 lower")).find("one side") != std::string::npos);
  CHECK(refusal(path, cut_at("0.4")).find("--cut '0.4 lower'") != std::string::npos);
}

// A block, less what stands askew in it.
TEST_CASE("booleans are cut") {
  const PartFolder folder;
  const parts::Part block = parts::box({0, 0, 0}, 30, 30, 10);
  const parts::Part hollow = parts::edited(turned(parts::box({0, 0, 0}, 8, 8, 30), 0.4, 0.3),
                                           [](const Facet& facet, std::int64_t) {
                                             Facet moved = facet;
                                             for (Corner& c : moved)
                                               c = {c.x + 3, c.y + 18, c.z - 9};
                                             return std::vector<Facet>{moved};
                                           });
  const auto file = [&](const char* name, const parts::Part& plastic, const parts::Part& negative) {
    return folder.add_text(
        name, test::prusa_threemf({{plastic, "ModelPart"}, {negative, "NegativeVolume"}}));
  };
  const std::string whole = file("whole.3mf", block, hollow);
  for (const bool upper : {false, true}) {
    CAPTURE(upper);
    const std::string outside =
        file("piece.3mf", parts::box({0, 0, upper ? 4.0 : 0.0}, 30, 30, upper ? 6 : 4),
             piece_of(hollow, 4, upper));
    for (const bool adaptive : {false, true}) {
      Settings settings = exact();
      settings.adaptive_layer_height = adaptive;
      host::OpenedPart should = opened(outside, settings);
      settings.cut = upper ? "4 upper" : "4 lower";
      host::OpenedPart is = opened(whole, settings);
      CHECK_EQ(is.summary.height.mm(), doctest::Approx(upper ? 6 : 4));
      check_alike(is, should, 4);
    }
  }
  CHECK(refusal(whole, cut_at("10 lower")).find("10 mm high") != std::string::npos);
}
