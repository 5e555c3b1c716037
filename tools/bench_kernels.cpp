// Measures rind's kernels, Clipper 6.4.2, Clipper2 and Boost.Polygon on the same slices: offsets at
// one depth and at three, intersection and difference of the inner offsets of neighbouring slices.
//
//     bench_kernels                        synthetic contours; slices of vase, lattice and screw
//     bench_kernels benchy.3mf other.stl   slices of files, too; --only-files: only these
//     bench_kernels --only lattice         only samples with this in their names
//     bench_kernels --depths 0.2,-0.45     mm; negative depths are outwards, without booleans
//     bench_kernels --boost                Boost.Polygon, too, which is slow
//
// Times are processor times of this thread, medians of --benchmark_repetitions (9). The repetitions
// of all libraries alternate, so that all run under the same conditions. Ratios say how many times
// faster rind is. `arcs` keeps arcs, as the program's perimeters do; `chords` makes polygons of
// them with Clipper's tolerance, as Clipper does. Clipper2 is measured where CMake has found it
// (tools/CMakeLists.txt says how). Other options of Google Benchmark work, too.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <polyclipping/clipper.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/offset_contours.h"
#include "core/offsets/polygon_offset.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/units.h"
#include "tools/oracles/clipper2_calls.h"
#include "tools/oracles/reference_boolean.h"
#include "tools/samples/slice_samples.h"

namespace {

using ClipperLib::Paths;
using core::Length;
using core::OffsetContours;
using core::Region;
using samples::Sample;
using samples::SlicePair;

const Length kTolerance = Length::from_units(25);

// The offsets of rind that are measured.
constexpr double kOffsetRatioMin = 5;
constexpr double kBooleanRatioMin = 3;
constexpr double kThreeDepthsMax = 2;

struct Choices {
  std::vector<std::string> files;
  std::vector<double> depths_mm = {0.45, 1.35};
  double layer_height_mm = 0.2;
  int pairs = 12;
  bool only_files = false;
  std::string only;
  bool boost = false;
};

// Median seconds of processor time of one call, by its name.
class Medians : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Aggregate || run.aggregate_name != "median") continue;
      seconds_[run.run_name.function_name] =
          run.GetAdjustedCPUTime() / benchmark::GetTimeUnitMultiplier(run.time_unit);
    }
  }
  // NaN if a filter excluded it.
  [[nodiscard]] double operator[](const std::string& name) const {
    const auto found = seconds_.find(name);
    return found != seconds_.end() ? found->second : std::nan("");
  }

 private:
  std::map<std::string, double> seconds_;
};

void add(const std::string& name, std::function<void()> call) {
  benchmark::RegisterBenchmark(name.c_str(), [call = std::move(call)](benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) call();
  });
}

void add_clipper2(const std::string& name, clipper2::Call call) {
  add(name + "Clipper2", [call = std::move(call)] { benchmark::DoNotOptimize(call()); });
}

Paths paths_of(const Region& region) {
  Paths paths;
  for (const core::Ring& ring : region.rings()) {
    paths.emplace_back();
    for (const core::Point p : ring) paths.back().push_back({p.x, p.y});
  }
  return paths;
}

std::vector<Paths> paths_of(const Sample& sample) {
  std::vector<Paths> all;
  for (const SlicePair& pair : sample.pairs) all.push_back(paths_of(pair.lower));
  return all;
}

void add_offsets(const std::string& name, const Sample& sample, double depth_mm, bool boost) {
  const Length depth = Length::from_mm(depth_mm);
  add(name + "Clipper", [paths = paths_of(sample), depth] {
    for (const Paths& slice : paths) {
      ClipperLib::ClipperOffset offset(2, static_cast<double>(kTolerance.units()));
      offset.AddPaths(slice, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
      Paths out;
      offset.Execute(out, -static_cast<double>(depth.units()));
      benchmark::DoNotOptimize(out.data());
    }
  });
  if (clipper2::found()) {
    std::vector<Region> slices;
    for (const SlicePair& pair : sample.pairs) slices.push_back(pair.lower);
    add_clipper2(name, clipper2::offsets(slices, depth, kTolerance));
  }
  // One for all calls, as in a thread of the program.
  static core::PolygonOffsetter offsetter;
  const auto ours = [&sample](const std::vector<Length>& depths, bool chords) {
    static std::vector<OffsetContours> out;
    if (out.size() < depths.size()) out.resize(depths.size());
    for (const SlicePair& pair : sample.pairs) {
      offsetter.offset(pair.lower, depths, std::span(out).first(depths.size()));
      if (chords) benchmark::DoNotOptimize(core::flatten(out[0], kTolerance).rings().data());
    }
  };
  const std::vector<Length> one = {depth};
  const std::vector<Length> three = {depth, Length::from_mm(depth_mm * 2 / 3),
                                     Length::from_mm(depth_mm / 3)};
  add(name + "arcs", [=] { ours(one, false); });
  add(name + "chords", [=] { ours(one, true); });
  add(name + "three", [=] { ours(three, false); });
  if (!boost) return;
  add(name + "diagram", [&sample, depth] {
    for (const SlicePair& pair : sample.pairs) {
      benchmark::DoNotOptimize(core::VoronoiMountain(pair.lower).offset(depth).data());
    }
  });
}

using Operation = Region (*)(const Region&, const Region&);

void add_boolean(const std::string& name, const Sample& inner, ClipperLib::ClipType type,
                 Operation ours, Operation reference) {
  std::vector<std::pair<Paths, Paths>> paths;
  for (const SlicePair& pair : inner.pairs) {
    paths.emplace_back(paths_of(pair.lower), paths_of(pair.upper));
  }
  add(name + "Clipper", [paths = std::move(paths), type] {
    for (const auto& [lower, upper] : paths) {
      ClipperLib::Clipper sheet;
      sheet.AddPaths(lower, ClipperLib::ptSubject, true);
      sheet.AddPaths(upper, ClipperLib::ptClip, true);
      Paths out;
      sheet.Execute(type, out, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
      benchmark::DoNotOptimize(out.data());
    }
  });
  if (clipper2::found()) {
    std::vector<std::pair<Region, Region>> pairs;
    for (const SlicePair& pair : inner.pairs) pairs.emplace_back(pair.lower, pair.upper);
    const bool both = type == ClipperLib::ctIntersection;
    add_clipper2(name, both ? clipper2::intersections(pairs) : clipper2::differences(pairs));
  }
  const auto each = [&inner](Operation operation) {
    for (const SlicePair& pair : inner.pairs) {
      benchmark::DoNotOptimize(operation(pair.lower, pair.upper).rings().data());
    }
  };
  add(name + "ours", [=] { each(ours); });
  if (reference != nullptr) add(name + "Boost", [=] { each(reference); });
}

// The sample's inner offsets, without pairs of which one is empty.
Sample inner_offsets(const Sample& sample, double depth_mm) {
  core::PolygonOffsetter offsetter;
  const auto inner = [&](const Region& region) {
    return core::flatten(offsetter.offset(region, Length::from_mm(depth_mm)), kTolerance);
  };
  Sample result{sample.name, {}};
  for (const SlicePair& pair : sample.pairs) {
    SlicePair offsets{inner(pair.lower), inner(pair.upper)};
    if (!offsets.lower.empty() && !offsets.upper.empty()) {
      result.pairs.push_back(std::move(offsets));
    }
  }
  return result;
}

// A line of the tables, with its measurements.
struct Row {
  const Sample* sample;
  double depth_mm;
  Sample inner;  // offsets of the sample at this depth

  [[nodiscard]] std::string key(const std::string& kernel) const {
    return fmt::format("{} {} {} ", sample->name, depth_mm, kernel);
  }
};

void register_row(const Row& row, bool boost) {
  namespace reference = core::reference;
  add_offsets(row.key("offset"), *row.sample, row.depth_mm, boost);
  if (row.inner.pairs.empty()) return;
  add_boolean(row.key("intersect"), row.inner, ClipperLib::ctIntersection, core::intersect,
              boost ? reference::intersect : nullptr);
  add_boolean(row.key("subtract"), row.inner, ClipperLib::ctDifference, core::subtract,
              boost ? reference::subtract : nullptr);
}

// The worst ratio and its sample.
struct Bound {
  std::string what;
  double limit;
  bool at_most = false;
  double worst = 0;
  std::string where{};

  void see(double value, const Row& row) {
    if (std::isnan(value)) return;
    if (!where.empty() && (at_most ? value <= worst : value >= worst)) return;
    worst = value;
    where = fmt::format("{} at {} mm", row.sample->name, row.depth_mm);
  }
  void print() const {
    if (where.empty()) return;
    const bool kept = at_most ? worst <= limit : worst >= limit;
    fmt::print("{:<34} {} {:g}: {}, worst {:.2f}, {}\n", what, at_most ? "at most" : "at least",
               limit, kept ? "kept" : "MISSED", worst, where);
  }
};

void print_offsets(const std::vector<Row>& rows, const Medians& medians, bool boost) {
  Bound arcs{"offset, arcs, Clipper / ours", kOffsetRatioMin};
  Bound chords{"offset, chords, Clipper / ours", kOffsetRatioMin};
  Bound depths{"offset, three depths / one", kThreeDepthsMax, true};
  fmt::print("{:<28}{:>8}{:>7}{:>12}{:>10}{:>8}{:>8}{:>8}{}{}\n", "offset", "edges", "mm",
             "Clipper ms", "ours ms", "arcs x", "chords x", "3 / 1", boost ? "  diagram x" : "",
             clipper2::found() ? "  Clipper2: arcs x  chords x" : "");
  for (const Row& row : rows) {
    const std::string key = row.key("offset");
    const double clipper = medians[key + "Clipper"], ours = medians[key + "arcs"];
    if (std::isnan(ours)) continue;
    const double three = medians[key + "three"] / ours;
    arcs.see(clipper / ours, row);
    chords.see(clipper / medians[key + "chords"], row);
    depths.see(three, row);
    fmt::print("{:<28}{:>8}{:>7.2f}{:>12.3f}{:>10.4f}{:>8.1f}{:>8.1f}{:>8.2f}", row.sample->name,
               row.sample->edge_count(), row.depth_mm, clipper * 1e3, ours * 1e3, clipper / ours,
               clipper / medians[key + "chords"], three);
    if (boost) fmt::print("{:>11.0f}", medians[key + "diagram"] / ours);
    if (clipper2::found()) {
      const double clipper2 = medians[key + "Clipper2"];
      fmt::print("{:>18.1f}{:>10.1f}", clipper2 / ours, clipper2 / medians[key + "chords"]);
    }
    fmt::print("\n");
  }
  for (const Bound& bound : {arcs, chords, depths}) bound.print();
}

void print_booleans(const std::vector<Row>& rows, const Medians& medians, bool boost,
                    const std::string& kernel) {
  Bound bound{kernel + ", Clipper / ours", kBooleanRatioMin};
  Bound bound2{kernel + ", Clipper2 / ours", kBooleanRatioMin};
  fmt::print("\n{:<28}{:>8}{:>7}{:>12}{:>10}{:>8}{}{}\n", kernel, "edges", "mm", "Clipper ms",
             "ours ms", "x", boost ? "  Boost x" : "", clipper2::found() ? "  Clipper2 x" : "");
  for (const Row& row : rows) {
    if (row.inner.pairs.empty()) continue;
    const std::string key = row.key(kernel);
    const double clipper = medians[key + "Clipper"], ours = medians[key + "ours"];
    if (std::isnan(ours)) continue;
    bound.see(clipper / ours, row);
    fmt::print("{:<28}{:>8}{:>7.2f}{:>12.3f}{:>10.4f}{:>8.1f}", row.sample->name,
               row.inner.edge_count(), row.depth_mm, clipper * 1e3, ours * 1e3, clipper / ours);
    if (boost) fmt::print("{:>9.0f}", medians[key + "Boost"] / ours);
    if (clipper2::found()) {
      const double clipper2 = medians[key + "Clipper2"];
      bound2.see(clipper2 / ours, row);
      fmt::print("{:>12.1f}", clipper2 / ours);
    }
    fmt::print("\n");
  }
  bound.print();
  bound2.print();
}

std::vector<Sample> chosen_samples(const Choices& choices) {
  std::vector<Sample> all;
  const auto take = [&](core::Result<Sample> sample, const std::string& name) {
    if (!sample.ok()) {
      fmt::print(stderr, "bench_kernels: {}: {}\n", name, sample.error().message);
    } else if (!sample.value().pairs.empty()) {
      all.push_back(std::move(sample).value());
    }
  };
  const auto wanted = [&](const std::string& name) {
    return name.find(choices.only) != std::string::npos;
  };
  if (!choices.only_files) {
    all = samples::made_up();
    std::erase_if(all, [&](const Sample& sample) { return !wanted(sample.name); });
    for (const parts::NamedPart& part : parts::all_parts()) {
      if (part.name != "vase" && part.name != "lattice" && part.name != "screw") continue;
      if (!wanted(part.name)) continue;
      take(samples::of_part(part, choices.layer_height_mm, choices.pairs), part.name);
    }
  }
  for (const std::string& file : choices.files) {
    take(samples::of_file(file, choices.layer_height_mm, choices.pairs), file);
  }
  return all;
}

// Google Benchmark removes its own options from these.
void start_benchmark(int& argc, char** argv) {
  static std::vector<std::string> defaults = {
      "--benchmark_repetitions=9", "--benchmark_min_time=0.02",
      "--benchmark_enable_random_interleaving=true", "--benchmark_report_aggregates_only=true"};
  std::vector<char*> all = {argv[0]};
  for (std::string& option : defaults) all.push_back(option.data());
  all.insert(all.end(), argv + 1, argv + argc);
  int count = static_cast<int>(all.size());
  benchmark::Initialize(&count, all.data());
  argc = count;
  std::copy(all.begin(), all.begin() + count, argv);
}

}  // namespace

int main(int argc, char** argv) {
  start_benchmark(argc, argv);
  CLI::App app("The kernels beside Clipper 6.4.2, Clipper2 and Boost.Polygon");
  Choices choices;
  app.add_option("files", choices.files, "parts to take slices of");
  app.add_flag("--only-files", choices.only_files, "nothing but the parts in these files");
  app.add_option("--only", choices.only, "the samples of this name, or a part of it");
  app.add_option("--depths", choices.depths_mm, "of the offsets, mm")->delimiter(',');
  app.add_option("--layer-height", choices.layer_height_mm, "mm")->check(CLI::Range(0.01, 10.0));
  app.add_option("--pairs", choices.pairs, "of slices, from each part")->check(CLI::Range(1, 1000));
  app.add_flag("--boost", choices.boost, "Boost.Polygon, too");
  CLI11_PARSE(app, argc, argv);

  const std::vector<Sample> all = chosen_samples(choices);
  std::vector<Row> rows;
  for (const Sample& sample : all) {
    for (const double depth_mm : choices.depths_mm) {
      rows.push_back(
          {&sample, depth_mm, depth_mm > 0 ? inner_offsets(sample, depth_mm) : Sample()});
    }
  }
  for (const Row& row : rows) register_row(row, choices.boost);
  Medians medians;
  benchmark::RunSpecifiedBenchmarks(&medians);
  print_offsets(rows, medians, choices.boost);
  print_booleans(rows, medians, choices.boost, "intersect");
  print_booleans(rows, medians, choices.boost, "subtract");
  return 0;
}
