// Measures booleans: ours beside Clipper 6.4.2 and Boost.Polygon on pairs of regions like those of
// consecutive layers. CPU time of this thread; calls alternate, so that all see the same machine.
// Medians; ratios say how many times faster ours is (more than 3 is asked of it).
//
//     bench_booleans [--runs N]
#include <fmt/core.h>
#include <time.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>
#include <string>
#include <vector>

#include "core/boolean.h"
#include "core/reference_boolean.h"
#include "core/units.h"

namespace {

using core::Region;
using core::Ring;

constexpr double kTurn = 6.283185307179586;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Mean CPU time of one of `count` calls.
template <typename Call>
double seconds(int count, Call call) {
  const double start = cpu_seconds();
  for (int i = 0; i < count; ++i) call();
  return (cpu_seconds() - start) / count;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

// A wavy circle about (x, y); a hole when `hole`.
Ring wavy(int edges, double radius_mm, double wave_mm, int waves, double phase, bool hole = false,
          double x_mm = 0, double y_mm = 0) {
  Ring ring;
  for (int i = 0; i < edges; ++i) {
    const double angle = kTurn * i / edges;
    const double radius = radius_mm + wave_mm * std::sin(waves * angle + phase);
    const auto units = [](double mm) {
      return static_cast<std::int32_t>(std::lround(mm * core::kUnitsPerMm));
    };
    ring.push_back(
        {units(x_mm + radius * std::cos(angle)), units(y_mm + radius * std::sin(angle))});
  }
  if (hole) std::reverse(ring.begin(), ring.end());
  return ring;
}

Region clean(const std::vector<Ring>& rings) {
  return core::clean(rings, core::FillRule::kPositive);
}

Region annulus(int edges, double inset_mm, double phase) {
  return clean({wavy(edges / 2, 20 - inset_mm, 1, 12, phase),
                wavy(edges / 2, 14 + inset_mm, 1, 9, 1 + phase, true)});
}

// A five-lobed section of a screw, turned.
Region twisted(double angle) { return clean({wavy(128, 10, 2, 5, 5 * angle)}); }

Region lattice(double radius_mm, double shift_mm) {
  std::vector<Ring> rings;
  for (int i = 0; i < 441; ++i) {
    rings.push_back(wavy(32, radius_mm, 0, 1, 0, false, i % 21 * 5 + shift_mm, i / 21 * 5));
  }
  return clean(rings);
}

// The same region, but for one dent.
Region dented(const Region& region) {
  std::vector<Ring> rings = region.rings();
  for (std::size_t i = 0; i < rings[0].size() / 10; ++i) rings[0][i].x += 20'000;
  return clean(rings);
}

struct Pair {
  std::string name;
  Region a, b;
};

std::vector<Pair> pairs() {
  std::vector<Pair> all;
  for (const int edges : {200, 2400, 20'000}) {
    all.push_back(
        {fmt::format("annulus {}, inset", edges), annulus(edges, 0, 0), annulus(edges, 0.05, 0)});
    all.push_back({fmt::format("annulus {}, waves go round", edges), annulus(edges, 0, 0),
                   annulus(edges, 0.05, 0.3)});
  }
  all.push_back({"screw 128, turned 1 degree", twisted(0), twisted(kTurn / 360)});
  all.push_back({"441 columns, inset", lattice(2, 0), lattice(1.99, 0)});
  all.push_back({"441 columns, leaning", lattice(2, 0), lattice(2, 0.05)});
  all.push_back({"annulus 2400, one dent", annulus(2400, 0, 0), dented(annulus(2400, 0, 0))});
  return all;
}

ClipperLib::Paths paths_of(const Region& region) {
  ClipperLib::Paths paths;
  for (const Ring& ring : region.rings()) {
    paths.emplace_back();
    for (const core::Point p : ring) paths.back().push_back({p.x, p.y});
  }
  return paths;
}

enum class Operation { kIntersect, kSubtract };

void measure(const Pair& pair, Operation operation, int runs) {
  const ClipperLib::Paths a = paths_of(pair.a), b = paths_of(pair.b);
  const bool intersects = operation == Operation::kIntersect;
  const auto clipper = [&] {
    ClipperLib::Clipper sheet;
    sheet.AddPaths(a, ClipperLib::ptSubject, true);
    sheet.AddPaths(b, ClipperLib::ptClip, true);
    ClipperLib::Paths out;
    sheet.Execute(intersects ? ClipperLib::ctIntersection : ClipperLib::ctDifference, out,
                  ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  };
  const auto ours = [&] {
    static_cast<void>(intersects ? core::intersect(pair.a, pair.b)
                                 : core::subtract(pair.a, pair.b));
  };
  const auto boost = [&] {
    static_cast<void>(intersects ? core::reference::intersect(pair.a, pair.b)
                                 : core::reference::subtract(pair.a, pair.b));
  };
  const double edges = static_cast<double>(pair.a.point_count() + pair.b.point_count());
  const int calls = std::max(1, static_cast<int>(5e3 / edges));
  std::vector<double> clipper_s, ours_s, ratios;
  for (int i = 0; i < runs; ++i) {
    clipper_s.push_back(seconds(calls, clipper));
    ours_s.push_back(seconds(calls, ours));
    ratios.push_back(clipper_s.back() / ours_s.back());
  }
  const double boost_s = seconds(1, boost);
  fmt::print(
      "{:<28} {:<9} {:6.0f} edges  Clipper {:8.3f} ms  ours {:7.4f} ms {:4.0f} ns/edge  x{:5.1f}  "
      "Boost x{:5.0f}\n",
      pair.name, intersects ? "intersect" : "subtract", edges, median(clipper_s) * 1e3,
      median(ours_s) * 1e3, median(ours_s) * 1e9 / edges, median(ratios), boost_s / median(ours_s));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Booleans: ours beside Clipper 6.4.2 and Boost.Polygon");
  int runs = 21;
  app.add_option("--runs", runs, "Calls that a median is taken of");
  CLI11_PARSE(app, argc, argv);
  for (const Pair& pair : pairs()) {
    measure(pair, Operation::kIntersect, runs);
    measure(pair, Operation::kSubtract, runs);
  }
  return 0;
}
