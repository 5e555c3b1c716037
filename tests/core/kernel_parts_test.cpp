// The kernels on slices of parts as they are, mirrored, turned and shifted far off: offsets beside
// the whole diagram, booleans of neighbouring inner offsets beside Boost.Polygon and by winding
// numbers. Some slices of own parts; RIND_KERNEL_PARTS=part.stl:other.3mf RIND_KERNEL_LAYER=0.2
// takes every slice of these files.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/offset_contours.h"
#include "core/offsets/polygon_offset.h"
#include "core/regions/contact_check.h"
#include "core/units.h"
#include "tests/support/offset_checks.h"
#include "tests/support/part_folder.h"
#include "tests/support/region_checks.h"
#include "tools/oracles/reference_boolean.h"
#include "tools/parts/part_maker.h"
#include "tools/samples/slice_samples.h"

using core::Length;
using core::Point;
using core::Region;
using core::Ring;
using test::Random;

namespace {

const Length kDepths[] = {Length::from_mm(0.45), Length::from_mm(1.35), Length::from_mm(-0.4)};
constexpr Point kFar{123'456'789, -400'000'000};

Region moved(const Region& region, Point by) {
  std::vector<Ring> rings = region.rings();
  for (Ring& ring : rings) {
    for (Point& p : ring) p = {p.x + by.x, p.y + by.y};
  }
  return Region::from_clean_rings(std::move(rings));
}

// Multiplied by (x, y) as complex numbers are, mirrored before if asked.
Region turned(const Region& region, double x, double y, bool mirrored) {
  std::vector<Ring> rings = region.rings();
  for (Ring& ring : rings) {
    for (Point& p : ring) {
      const double px = mirrored ? -p.x : p.x, py = p.y;
      p = {static_cast<std::int32_t>(std::lround(px * x - py * y)),
           static_cast<std::int32_t>(std::lround(px * y + py * x))};
    }
    if (mirrored) std::reverse(ring.begin(), ring.end());
  }
  // Rounding may have made edges cross.
  return core::clean(rings, core::FillRule::kPositive);
}

struct Totals {
  test::OffsetComparison offsets;
  std::int64_t slices = 0;
  std::int64_t booleans = 0;
  double widest = 0;  // difference to Boost.Polygon, units
};

class PartCheck {
 public:
  explicit PartCheck(Totals& totals) : totals_(totals) {}

  void add(const Region& slice) {
    if (slice.empty()) return;
    ++totals_.slices;
    CAPTURE(totals_.slices);
    CHECK_EQ(test::check_against_diagram(offsetter_, slice, kDepths, totals_.offsets), "");
    const Region inner = inner_of(slice);
    check_shifted(slice, inner);
    if (!inner.empty() && !last_inner_.empty() && !(inner == last_inner_)) {
      check_booleans(last_inner_, inner);
    }
    last_inner_ = inner;
  }

  [[nodiscard]] std::int64_t fallbacks() const { return offsetter_.fallbacks(); }

 private:
  Region inner_of(const Region& slice) {
    return core::flatten(offsetter_.offset(slice, kDepths[0]), test::kArcTolerance);
  }

  // Nothing depends on where things are, to the last unit.
  void check_shifted(const Region& slice, const Region& inner) {
    CHECK((inner_of(moved(slice, kFar)) == moved(inner, kFar)));
    if (last_inner_.empty() || inner.empty()) return;
    const Region common = core::intersect(last_inner_, inner);
    CHECK((core::intersect(moved(last_inner_, kFar), moved(inner, kFar)) == moved(common, kFar)));
  }

  void check_booleans(const Region& a, const Region& b) {
    const Region common = core::intersect(a, b), rest = core::subtract(a, b);
    const Region united = core::unite(a, b);
    namespace reference = core::reference;
    for (const auto& [ours, theirs] :
         {std::pair(common, reference::intersect(a, b)), std::pair(rest, reference::subtract(a, b)),
          std::pair(united, reference::unite(a, b))}) {
      ++totals_.booleans;
      CHECK((core::surely_clean(ours.rings()) || test::is_clean(ours)));
      totals_.widest = std::max(totals_.widest, test::widest_difference(ours, theirs));
    }
    const core::Box box = united.box();
    for (int i = 0; i < 20; ++i) {
      const double x = random_.between(box.min.x, box.max.x);
      const double y = random_.between(box.min.y, box.max.y);
      if (test::distance_to_boundary(a.rings(), x, y) < 1) continue;
      if (test::distance_to_boundary(b.rings(), x, y) < 1) continue;
      const bool in_a = test::winding_number(a.rings(), x, y) == 1;
      const bool in_b = test::winding_number(b.rings(), x, y) == 1;
      CHECK_EQ(test::winding_number(common.rings(), x, y), in_a && in_b ? 1 : 0);
      CHECK_EQ(test::winding_number(rest.rings(), x, y), in_a && !in_b ? 1 : 0);
      CHECK_EQ(test::winding_number(united.rings(), x, y), in_a || in_b ? 1 : 0);
    }
  }

  Totals& totals_;
  core::PolygonOffsetter offsetter_;
  Region last_inner_;
  Random random_{1};
};

void check_part(const std::string& path, double layer_height_mm) {
  CAPTURE(path);
  Totals totals;
  PartCheck as_it_is(totals), mirrored(totals), quarter(totals), askew(totals);
  const core::Status read = samples::for_slices(path, layer_height_mm, [&](const Region& slice) {
    as_it_is.add(slice);
    mirrored.add(turned(slice, 1, 0, true));
    quarter.add(turned(slice, 0, 1, false));
    askew.add(turned(slice, 0.8, 0.6, false));
  });
  if (!read.ok()) MESSAGE(path << ": " << read.error().message);
  CHECK_LE(totals.widest, 2);
  CHECK_EQ(as_it_is.fallbacks() + mirrored.fallbacks() + quarter.fallbacks() + askew.fallbacks(),
           0);
  MESSAGE(path << ": " << totals.slices << " slices and copies, " << totals.offsets.compared
               << " offsets, " << totals.offsets.critical << " at critical depths, "
               << totals.booleans << " booleans, widest difference " << totals.widest << " units");
}

}  // namespace

TEST_CASE("slices of parts, as they are, mirrored, turned and shifted") {
  const char* files = std::getenv("RIND_KERNEL_PARTS");
  const char* layer = std::getenv("RIND_KERNEL_LAYER");
  if (files != nullptr) {
    std::stringstream list{std::string(files)};
    for (std::string path; std::getline(list, path, ':');) {
      check_part(path, layer != nullptr ? std::strtod(layer, nullptr) : 0.2);
    }
    return;
  }
  const test::PartFolder folder;
  check_part(folder.add("demo.stl", parts::demo()), 2.3);
  check_part(folder.add("screw.stl", parts::screw()), 4.1);
  check_part(folder.add("vase.stl", parts::vase(0.1)), 17);
}
