// Marks for supports, from files of PrusaSlicer and OrcaSlicer to slices.
#include "host/part/marked_layers.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/voronoi_mountain.h"
#include "host/formats/facet_paint.h"
#include "host/part/part_file.h"
#include "tests/support/marked_files.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"
#include "tests/support/temporary_folder.h"

using core::Length;
using core::Region;
using test::MarkedBody;

namespace {

constexpr double kSide_mm = 30, kTall_mm = 6;

core::Settings supported() {
  core::Settings settings;
  settings.supports = core::SupportPlace::kEverywhere;
  settings.bed_x = settings.bed_y = Length::from_mm(80);
  settings.centre = false;
  return settings;
}

host::OpenedPart opened(const std::string& bytes, const core::Settings& settings,
                        const host::OpenOptions& options = {}) {
  const test::TemporaryFolder folder;
  auto part = host::open_whole_part(folder.write("part.3mf", bytes), settings, options);
  if (!part.ok()) FAIL(part.error().message);
  return std::move(part).value();
}

std::vector<core::SupportMarks> marks_of(host::OpenedPart part) {
  std::vector<core::SupportMarks> all;
  while (true) {
    auto slice = part.layers->next();
    REQUIRE(slice.ok());
    if (!slice.value()) return all;
    all.push_back(slice.value()->marks ? *slice.value()->marks : core::SupportMarks());
  }
}

std::string said_of(const std::string& bytes, const core::Settings& settings) {
  std::string text;
  for (const std::string& warning : opened(bytes, settings).summary.warnings) {
    text += warning + "\n";
  }
  return text;
}

bool says(const std::string& text, const std::string& words) {
  CAPTURE(text);
  return text.find(words) != std::string::npos;
}

struct Block {
  double x = 0, y = 0, z = 0, width = 0, depth = 0, height = 0;

  [[nodiscard]] parts::Part part() const { return parts::box({x, y, z}, width, depth, height); }
  [[nodiscard]] bool has(double px, double py, double pz) const {
    return px > x && px < x + width && py > y && py < y + depth && pz > z && pz < z + height;
  }
  [[nodiscard]] bool has_edge_near(double px, double py) const {
    const auto near = [](double a, double b) { return std::abs(a - b) < 0.01; };
    return near(px, x) || near(px, x + width) || near(py, y) || near(py, y + depth);
  }
};

// Some begin below the bed, some end above the part, some are beside it.
std::vector<Block> random_blocks(test::Random& random, int count) {
  std::vector<Block> blocks;
  for (int i = 0; i < count; ++i) {
    blocks.push_back({random.between(-5, 25), random.between(-5, 25), random.between(-2, 5),
                      random.between(1, 12), random.between(1, 12), random.between(0.3, 5)});
  }
  return blocks;
}

std::vector<MarkedBody> bodies_of(const std::vector<Block>& enforcers,
                                  const std::vector<Block>& blockers, bool orca) {
  std::vector<MarkedBody> bodies = {
      {parts::box({0, 0, 0}, kSide_mm, kSide_mm, kTall_mm), orca ? "normal_part" : "ModelPart"}};
  for (const Block& block : enforcers) {
    bodies.push_back({block.part(), orca ? "support_enforcer" : "SupportEnforcer"});
  }
  for (const Block& block : blockers) {
    bodies.push_back({block.part(), orca ? "support_blocker" : "SupportBlocker"});
  }
  return bodies;
}

void check_points(const std::vector<core::SupportMarks>& marks, const std::vector<Block>& blocks,
                  Region core::SupportMarks::*which, test::Random& random) {
  for (std::size_t n = 0; n < marks.size(); ++n) {
    const double z = 0.2 * static_cast<double>(n) + 0.1;
    for (int i = 0; i < 80; ++i) {
      const double x = random.between(-5, 38), y = random.between(-5, 38);
      if (std::any_of(blocks.begin(), blocks.end(),
                      [&](const Block& block) { return block.has_edge_near(x, y); })) {
        continue;
      }
      const bool expected = std::any_of(blocks.begin(), blocks.end(),
                                        [&](const Block& block) { return block.has(x, y, z); });
      const core::Point at{static_cast<std::int32_t>(x * 1e4), static_cast<std::int32_t>(y * 1e4)};
      CHECK_EQ((marks[n].*which).contains(at), expected);
    }
  }
}

// A ramp whose side leans outwards by 45°, from x = 10 at z = 2 on, where it is put.
parts::Part leaning_ramp() { return parts::ramp(45, 10); }

struct Leaning {
  std::int64_t number = 0;
  core::Triangle triangle;  // where it is put: from x = 1, y = 1 to 0, 0
};

std::vector<Leaning> leaning_facets() {
  std::vector<Leaning> found;
  std::int64_t number = 0;
  leaning_ramp()([&](const parts::Facet& facet) {
    Leaning one{number++, {}};
    bool leans = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const parts::Corner& at = facet[i];
      one.triangle.corners[i] = {static_cast<std::int32_t>(std::lround((at.x - 1) * 1e4)),
                                 static_cast<std::int32_t>(std::lround((at.y - 1) * 1e4)),
                                 std::llround(at.z * 1e4)};
      leans = leans && std::abs(at.x - 11 - (at.z - 2)) < 1e-9;
    }
    if (leans) found.push_back(one);
  });
  return found;
}

// Enforced and blocked pieces of a facet, seen from above.
void add_pieces(const std::string& text, const core::Triangle& triangle,
                std::array<Region, 2>& pieces) {
  const core::Status done = host::each_painted_piece(
      text, triangle, [&](const core::Triangle& piece, host::FacetPaint kind) -> core::Status {
        core::Ring ring;
        for (const core::Vertex& corner : piece.corners) ring.push_back({corner.x, corner.y});
        if (core::doubled_area_units(ring) < 0) std::reverse(ring.begin(), ring.end());
        Region& into = pieces[kind == host::FacetPaint::kEnforcer ? 0 : 1];
        into = core::unite(into, core::clean({ring}, core::FillRule::kPositive));
        return {};
      });
  REQUIRE(done.ok());
}

// With gaps up to `gap` closed.
Region widened(const Region& pieces, const Region& strip, Length gap = {}) {
  const Region within = core::intersect(pieces, strip);
  if (within.empty()) return within;
  const Length half = Length::from_units(gap.units() / 2), exact = Length::from_units(100);
  return core::offset(core::offset(within, -(host::kPaintReach + half), exact), half, exact);
}

}  // namespace

TEST_CASE("bodies that enforce and block are in the slices where they are") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const std::vector<Block> enforcers = random_blocks(random, 5);
    const std::vector<Block> blockers = random_blocks(random, 4);
    const auto marks =
        marks_of(opened(test::prusa_threemf(bodies_of(enforcers, blockers, false)), supported()));
    REQUIRE_EQ(marks.size(), 30);
    check_points(marks, enforcers, &core::SupportMarks::enforced, random);
    check_points(marks, blockers, &core::SupportMarks::blocked, random);
    // In OrcaSlicer's words, and with hardly any memory to sort in.
    host::OpenOptions options;
    options.sort_bytes = host::kSortBytesMin;
    const auto same = marks_of(
        opened(test::orca_threemf(bodies_of(enforcers, blockers, true)), supported(), options));
    for (std::size_t n = 0; n < marks.size(); ++n) {
      CHECK(marks[n].enforced == same[n].enforced);
      CHECK(marks[n].blocked == same[n].blocked);
    }
  }
}

TEST_CASE("painted pieces of a ramp are strips of its layers, a little wider") {
  const std::vector<Leaning> leaning = leaning_facets();
  const Length gap = supported().road_width * 2;  // closed where it is enforced
  REQUIRE_EQ(leaning.size(), 2);
  for (const std::string one : {"4", "8", "041", "8002", "80043", "04403", "84043"}) {
    for (const std::string other : {"", "08043"}) {
      CAPTURE(one);
      CAPTURE(other);
      const auto paint = [&](std::int64_t facet) {
        if (facet == leaning[0].number) return one;
        return facet == leaning[1].number ? other : std::string();
      };
      REQUIRE(host::is_paint(one));
      std::array<Region, 2> pieces;
      for (const Leaning& facet : leaning) {
        if (!paint(facet.number).empty()) add_pieces(paint(facet.number), facet.triangle, pieces);
      }
      const auto marks = marks_of(
          opened(test::prusa_threemf({{leaning_ramp(), "ModelPart", paint}}), supported()));
      REQUIRE_EQ(marks.size(), 60);
      for (std::size_t n = 1; n < marks.size(); ++n) {
        CAPTURE(n);
        // Between the planes of the layer and the one below; not where it begins.
        const double low = 0.2 * static_cast<double>(n) - 0.1;
        if (std::abs(low - 2) < 0.2) continue;
        const Region strip = low > 2 ? test::rectangle_region(10 + low - 2, -1, 0.2, 30) : Region();
        CHECK_LT(test::widest_difference(marks[n].enforced, widened(pieces[0], strip, gap)), 300);
        CHECK_LT(test::widest_difference(marks[n].blocked, widened(pieces[1], strip)), 300);
      }
    }
  }
}

TEST_CASE("marks are placed, turned and enlarged with their part; copies have copies") {
  const Block block{2, 3, 1, 5, 6, 2};
  const std::vector<MarkedBody> bodies = bodies_of({block}, {}, false);
  core::Settings settings = supported();
  settings.part_x = Length::from_mm(10);
  settings.part_y = Length::from_mm(20);
  auto marks = marks_of(opened(test::prusa_threemf(bodies), settings));
  CHECK_EQ(marks[8].enforced.box(), core::Box{{120'000, 230'000}, {170'000, 290'000}});
  CHECK(marks[4].enforced.empty());
  CHECK(marks[15].enforced.empty());
  // Mirrored, and beside it as it is.
  marks =
      marks_of(opened(test::prusa_threemf(bodies, {"", "-1 0 0 0 1 0 0 0 1 62 0 0"}), supported()));
  CHECK_EQ(marks[8].enforced.area_mm2(), doctest::Approx(60));
  CHECK_EQ(marks[8].enforced.box(), core::Box{{20'000, 30'000}, {600'000, 90'000}});
  settings = supported();
  settings.shrinkage_xy = 0.2;
  marks = marks_of(opened(test::prusa_threemf(bodies), settings));
  CHECK_EQ(marks[8].enforced.box(), core::Box{{25'000, 37'500}, {87'500, 112'500}});
}

TEST_CASE("marks beside negative parts count, too") {
  std::vector<MarkedBody> bodies = bodies_of({{2, 3, 1, 5, 6, 2}}, {{20, 20, 0, 5, 5, 9}}, false);
  bodies.push_back({parts::box({10, 10, -1}, 4, 4, 20), "NegativeVolume"});
  bodies.front().paint = [](std::int64_t facet) { return facet == 0 ? "4" : ""; };
  const auto marks = marks_of(opened(test::prusa_threemf(bodies), supported()));
  REQUIRE_EQ(marks.size(), 30);
  CHECK_EQ(marks[8].enforced.area_mm2(), doctest::Approx(30));
  CHECK_EQ(marks[8].blocked.area_mm2(), doctest::Approx(25));
}

TEST_CASE("without supports marks are counted and named, and cost nothing") {
  std::vector<MarkedBody> bodies =
      bodies_of({{2, 3, 1, 5, 6, 2}, {9, 9, 1, 5, 6, 2}}, {{20, 20, 0, 5, 5, 9}}, false);
  bodies.front().paint = [](std::int64_t facet) { return facet < 7 ? "4" : ""; };
  const std::string bytes = test::prusa_threemf(bodies);
  core::Settings settings = supported();
  settings.supports = core::SupportPlace::kOff;
  CHECK(says(said_of(bytes, settings),
             "2 support enforcers, 1 support blocker, 7 facets painted for supports: not used, "
             "since supports = off"));
  for (const core::SupportMarks& marks : marks_of(opened(bytes, settings))) {
    CHECK(marks.enforced.empty());
  }
  CHECK_EQ(said_of(bytes, supported()), "");
}

TEST_CASE("painting that is damaged, or of no known kind, is told with its text") {
  const auto painted = [](const std::string& first, const std::string& second) {
    return test::prusa_threemf({{parts::ramp(45, 4), "ModelPart", [=](std::int64_t facet) {
                                   return facet % 2 == 0 ? first : second;
                                 }}});
  };
  const std::string damaged = said_of(painted("40G3", "4"), supported());
  CHECK(says(damaged, "part.3mf: "));
  CHECK(
      says(damaged,
           "painted for supports in a way that is damaged, the first is triangle 1 of object '1', "
           "'40G3'; taken as not painted"));
  CHECK(says(said_of(painted("4", "3"), supported()), "the first is triangle 2 of object '1'"));
  CHECK_FALSE(says(damaged, "neither"));
  const std::string unknown = said_of(painted("4", "1C"), supported());
  CHECK(says(unknown, "painted for supports as neither enforced nor blocked"));
  CHECK_FALSE(says(unknown, "damaged"));
  // What is sound beside it counts.
  bool any = false;
  for (const core::SupportMarks& marks : marks_of(opened(painted("40G3", "4"), supported()))) {
    any = any || !marks.enforced.empty();
  }
  CHECK(any);
}

TEST_CASE("gaps narrower than two roads are closed in enforcing paint, and in no other") {
  for (const std::string paint : {"4", "8"}) {
    for (const double gap_mm : {0.7, 1.0}) {
      CAPTURE(paint);
      CAPTURE(gap_mm);
      // Two ledges side by side, painted all over. Paint reaches 0.1 mm to both sides.
      const auto ledge = [&](double x) {
        return MarkedBody{parts::box({x, 0, 2}, 5, 10, 2), "ModelPart",
                          [=](std::int64_t) { return paint; }};
      };
      const auto marks = marks_of(opened(
          test::prusa_threemf(
              {{parts::box({0, 0, 0}, 1, 10, 2), "ModelPart"}, ledge(0), ledge(5 + 0.2 + gap_mm)}),
          supported()));
      REQUIRE_EQ(marks.size(), 20);
      const Region& found = paint == "4" ? marks[10].enforced : marks[10].blocked;
      const bool closed = paint == "4" && gap_mm < 0.9;
      CHECK_EQ(core::islands(found).size(), closed ? 1 : 2);
      const std::int32_t end = 103'000 + static_cast<std::int32_t>(std::lround(gap_mm * 1e4));
      CHECK_EQ(found.box(), core::Box{{-1'000, -1'000}, {end, 101'000}});
    }
  }
}

TEST_CASE("a mark that reaches too far is refused with the file's name, before the part is read") {
  core::Settings settings = supported();
  settings.part_x = Length::from_mm(30);
  const test::TemporaryFolder folder;
  std::vector<MarkedBody> bodies = bodies_of({{0, 0, 0, 53'680, 5, 5}}, {}, false);
  auto part = host::open_part(folder.write("part.3mf", test::prusa_threemf(bodies)), settings, {});
  REQUIRE_FALSE(part.ok());
  CHECK(says(part.error().message, "part.3mf: what marks where supports are to be reaches"));
  CHECK(says(part.error().message, "make it smaller"));
  // Where it is nearer, the part may be anywhere: what counts is where both will be.
  settings.part_x = Length();
  CHECK(host::open_whole_part(folder.write("near.3mf", test::prusa_threemf(bodies)), settings, {})
            .ok());
  // Beside a negative part, before the first slice.
  settings.part_x = Length::from_mm(30);
  bodies.push_back({parts::box({10, 10, -1}, 4, 4, 20), "NegativeVolume"});
  part = host::open_part(folder.write("cut.3mf", test::prusa_threemf(bodies)), settings, {});
  REQUIRE(part.ok());
  REQUIRE(part.value().read_rest);
  const auto summary = part.value().read_rest();
  REQUIRE_FALSE(summary.ok());
  CHECK(says(summary.error().message, "cut.3mf: what marks where supports are to be reaches"));
}

TEST_CASE("a part says whether its file enforces supports") {
  const auto enforced = [](const std::vector<MarkedBody>& bodies) {
    return opened(test::prusa_threemf(bodies), supported()).enforced;
  };
  const Block block{2, 3, 1, 5, 6, 2};
  CHECK(enforced(bodies_of({block}, {}, false)));
  CHECK_FALSE(enforced(bodies_of({}, {block}, false)));
  CHECK_FALSE(enforced(bodies_of({}, {}, false)));
  const auto painted = [](const std::string& text) {
    return std::vector<MarkedBody>{
        {parts::ramp(45, 4), "ModelPart", [=](std::int64_t) { return text; }}};
  };
  CHECK(enforced(painted("4")));
  CHECK_FALSE(enforced(painted("8")));
}
