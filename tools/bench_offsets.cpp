// Measures offsets: the foot of the mountain beside Clipper 6.4.2 and the whole Voronoi diagram, on
// shapes like slices. CPU time of this thread, medians; ratios say how many times faster ours is.
//
//     bench_offsets [--whole] [--runs N]
#include <fmt/core.h>
#include <time.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <polyclipping/clipper.hpp>
#include <random>
#include <string>
#include <vector>

#include "core/mountain_foot.h"
#include "core/offset_contours.h"
#include "core/voronoi_mountain.h"

namespace {

using core::Length;
using core::OffsetContours;
using core::Region;
using core::Ring;

constexpr double kArcToleranceUnits = 25;
constexpr double kTurn = 6.283185307179586;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Median of the CPU time of a call, and at least `runs` of them.
double median_seconds(int runs, const std::function<void()>& call) {
  std::vector<double> times;
  const double begin = cpu_seconds();
  while (static_cast<int>(times.size()) < runs ||
         (cpu_seconds() - begin < 0.05 && times.size() < 1000)) {
    const double start = cpu_seconds();
    call();
    times.push_back(cpu_seconds() - start);
  }
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2),
                   times.end());
  return times[times.size() / 2];
}

core::Point point_mm(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x * core::kUnitsPerMm)),
          static_cast<std::int32_t>(std::lround(y * core::kUnitsPerMm))};
}

// A wavy circle; a hole when `hole`.
Ring wavy(int edges, double radius_mm, double wave_mm, int waves, double phase, bool hole) {
  Ring ring;
  for (int i = 0; i < edges; ++i) {
    const double angle = kTurn * i / edges;
    const double radius = radius_mm + wave_mm * std::sin(waves * angle + phase) +
                          0.3 * wave_mm * std::sin(7 * waves * angle);
    ring.push_back(point_mm(radius * std::cos(angle), radius * std::sin(angle)));
  }
  if (hole) std::reverse(ring.begin(), ring.end());
  return ring;
}

struct Shape {
  std::string name;
  Region region;
};

std::vector<Shape> shapes() {
  std::vector<Shape> all;
  const auto add = [&](std::string name, std::vector<Ring> rings) {
    all.push_back({std::move(name), Region::from_clean_rings(std::move(rings))});
  };
  for (const int edges : {200, 2400, 20'000}) {
    add(fmt::format("bumpy annulus {}", edges),
        {wavy(edges / 2, 20, 1, 12, 0, false), wavy(edges / 2, 14, 1, 9, 1, true)});
  }
  add("bumpy blob 20000", {wavy(20'000, 20, 2, 15, 0, false)});
  add("lobed tube 128", {wavy(64, 10, 2, 5, 0.3, false), wavy(64, 8.4, 2, 5, 0.3, true)});
  add("circle 96", {wavy(96, 10, 0, 1, 0, false)});
  std::vector<Ring> squares;
  for (int i = 0; i < 441; ++i) {
    const double x = i % 21 * 5, y = i / 21 * 5;
    squares.push_back(
        {point_mm(x, y), point_mm(x + 4, y), point_mm(x + 4, y + 4), point_mm(x, y + 4)});
  }
  add("441 squares", std::move(squares));
  std::mt19937_64 random(1);
  Ring star;
  for (int i = 0; i < 1000; ++i) {
    const double radius = 10 + 1e-4 * static_cast<double>(random() % 100'000);
    star.push_back(
        point_mm(radius * std::cos(kTurn * i / 1000), radius * std::sin(kTurn * i / 1000)));
  }
  add("random star 1000", {star});
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

void measure(const Shape& shape, int runs, bool whole) {
  const double edges = static_cast<double>(shape.region.point_count());
  const ClipperLib::Paths paths = paths_of(shape.region);
  core::MountainFoot foot;
  for (const double depth_mm : {0.2, 0.45, 1.35, -0.45}) {
    const double clipper = median_seconds(runs, [&] {
      ClipperLib::ClipperOffset offset(2, kArcToleranceUnits);
      offset.AddPaths(paths, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
      ClipperLib::Paths out;
      offset.Execute(out, -depth_mm * core::kUnitsPerMm);
    });
    const Length depth = Length::from_mm(depth_mm);
    OffsetContours out[1];
    const double ours =
        median_seconds(runs, [&] { foot.offset(shape.region, std::span(&depth, 1), out); });
    const double flattened = median_seconds(runs, [&] {
      foot.offset(shape.region, std::span(&depth, 1), out);
      static_cast<void>(core::flatten(out[0], Length::from_units(25)));
    });
    const Length three[] = {depth, Length::from_mm(depth_mm * 2 / 3),
                            Length::from_mm(depth_mm / 3)};
    OffsetContours three_out[3];
    const double thrice =
        median_seconds(runs, [&] { foot.offset(shape.region, three, three_out); });
    fmt::print(
        "{:<20} {:5.2f} mm  Clipper {:8.3f} ms  ours {:7.4f} ms {:5.0f} ns/edge  x{:6.1f}  with "
        "flatten x{:5.1f}  3 depths/1 {:4.2f}",
        shape.name, depth_mm, clipper * 1e3, ours * 1e3, ours * 1e9 / edges, clipper / ours,
        clipper / flattened, thrice / ours);
    if (whole) {
      const double diagram =
          median_seconds(1, [&] {
        static_cast<void>(core::VoronoiMountain(shape.region).offset(depth));
      });
      fmt::print("  whole diagram x{:.0f}", diagram / ours);
    }
    fmt::print("\n");
  }
  if (foot.retries() + foot.fallbacks() > 0) {
    fmt::print("{}: {} retries, {} fallbacks\n", shape.name, foot.retries(), foot.fallbacks());
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Offsets: ours beside Clipper 6.4.2");
  bool whole = false;
  int runs = 9;
  app.add_flag("--whole", whole, "Also the whole Voronoi diagram");
  app.add_option("--runs", runs, "Calls a median is taken of, at least");
  CLI11_PARSE(app, argc, argv);
  for (const Shape& shape : shapes()) measure(shape, runs, whole);
  return 0;
}
