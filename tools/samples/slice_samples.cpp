#include "tools/samples/slice_samples.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <utility>

#include "core/booleans/boolean.h"
#include "core/settings.h"
#include "core/units.h"
#include "host/part/part_file.h"

namespace samples {
namespace {

using core::Region;
using core::Ring;

constexpr double kTurn = 2 * std::numbers::pi;
// No bed limits the parts here.
constexpr double kBedMm = 10'000;

core::Point point_mm(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x * core::kUnitsPerMm)),
          static_cast<std::int32_t>(std::lround(y * core::kUnitsPerMm))};
}

// A circle with waves, and ripples on them.
struct Wavy {
  int edges;
  double radius_mm;
  double wave_mm = 0;
  int waves = 1;
  double phase = 0;
  double ripple = 0;  // share of the waves' height
  double x_mm = 0, y_mm = 0;
};

Ring wavy(const Wavy& shape, bool hole = false) {
  Ring ring;
  for (int i = 0; i < shape.edges; ++i) {
    const double angle = kTurn * i / shape.edges;
    const double wave = std::sin(shape.waves * angle + shape.phase) +
                        shape.ripple * std::sin(7 * shape.waves * angle);
    const double radius = shape.radius_mm + shape.wave_mm * wave;
    ring.push_back(
        point_mm(shape.x_mm + radius * std::cos(angle), shape.y_mm + radius * std::sin(angle)));
  }
  if (hole) std::reverse(ring.begin(), ring.end());
  return ring;
}

Region clean(const std::vector<Ring>& rings) {
  return core::clean(rings, core::FillRule::kPositive);
}

Region annulus(int edges, double inset_mm, double phase) {
  return clean({wavy({edges / 2, 20 - inset_mm, 1, 12, phase, 0.3}),
                wavy({edges / 2, 14 + inset_mm, 1, 9, 1 + phase, 0.3}, true)});
}

Region tube(double phase) {
  return clean({wavy({64, 10, 2, 5, phase}), wavy({64, 8.4, 2, 5, phase}, true)});
}

Region squares(double shift_mm) {
  std::vector<Ring> rings;
  for (int i = 0; i < 441; ++i) {
    const double x = i % 21 * 5 + shift_mm, y = i / 21 * 5.0;
    rings.push_back(
        {point_mm(x, y), point_mm(x + 4, y), point_mm(x + 4, y + 4), point_mm(x, y + 4)});
  }
  return clean(rings);
}

Region columns(double radius_mm) {
  std::vector<Ring> rings;
  for (int i = 0; i < 441; ++i) {
    rings.push_back(wavy({32, radius_mm, 0, 1, 0, 0, i % 21 * 5.0, i / 21 * 5.0}));
  }
  return clean(rings);
}

Region star(double turn) {
  std::mt19937_64 random(1);
  Ring ring;
  for (int i = 0; i < 1000; ++i) {
    const double radius = 10 + 1e-4 * static_cast<double>(random() % 100'000);
    const double angle = kTurn * i / 1000 + turn;
    ring.push_back(point_mm(radius * std::cos(angle), radius * std::sin(angle)));
  }
  return clean({ring});
}

Region dented(const Region& region) {
  std::vector<Ring> rings = region.rings();
  for (std::size_t i = 0; i < rings[0].size() / 10; ++i) rings[0][i].x += 20'000;
  return clean(rings);
}

core::Settings settings_of(double layer_height_mm) {
  core::Settings settings;
  settings.layer_height = core::Length::from_mm(layer_height_mm);
  settings.bed_x = settings.bed_y = core::Length::from_mm(kBedMm);
  return settings;
}

}  // namespace

std::size_t Sample::edge_count() const {
  std::size_t count = 0;
  for (const SlicePair& pair : pairs) count += pair.lower.point_count();
  return count;
}

std::vector<Sample> made_up() {
  std::vector<Sample> all;
  const auto add = [&](std::string name, Region lower, Region upper) {
    all.push_back({std::move(name), {{std::move(lower), std::move(upper)}}});
  };
  for (const int edges : {200, 2000, 20'000}) {
    add(fmt::format("annulus {}, sloping", edges), annulus(edges, 0, 0), annulus(edges, 0.05, 0));
  }
  for (const int edges : {200, 2000, 20'000}) {
    add(fmt::format("annulus {}, turning", edges), annulus(edges, 0, 0), annulus(edges, 0.05, 0.3));
  }
  add("blob 20000, sloping", clean({wavy({20'000, 20, 2, 15, 0, 0.3})}),
      clean({wavy({20'000, 19.95, 2, 15, 0, 0.3})}));
  add("lobed tube 128, turning", tube(0.3), tube(0.3 + 5 * kTurn / 360));
  add("circle 96, sloping", clean({wavy({96, 10})}), clean({wavy({96, 9.95})}));
  add("441 squares, leaning", squares(0), squares(0.05));
  add("441 columns, sloping", columns(2), columns(1.99));
  add("random star 1000, turning", star(0), star(0.002));
  add("annulus 2000, one dent", annulus(2000, 0, 0), dented(annulus(2000, 0, 0)));
  return all;
}

core::Status for_slices(const std::string& path, double layer_height_mm,
                        const std::function<void(const core::Region&)>& visit) {
  core::Result<host::OpenedPart> part = host::open_whole_part(path, settings_of(layer_height_mm));
  if (!part.ok()) return part.error();
  for (;;) {
    const auto slice = part.value().layers->next();
    if (!slice.ok()) return slice.error();
    if (!slice.value().has_value()) return {};
    visit(slice.value()->region);
  }
}

core::Result<Sample> of_file(const std::string& path, double layer_height_mm, int count) {
  std::int64_t layers = 0;
  core::Status read = for_slices(path, layer_height_mm, [&](const Region&) { ++layers; });
  if (!read.ok()) return read.error();
  Sample sample{std::filesystem::path(path).stem().string(), {}};
  std::int64_t layer = 0, taken = 0;
  bool wanted = false;  // the last slice is the first of a pair
  Region last;
  read = for_slices(path, layer_height_mm, [&](const Region& slice) {
    if (wanted && !last.empty() && !slice.empty()) sample.pairs.push_back({last, slice});
    wanted = layer * count >= taken * layers;
    if (wanted) {
      ++taken;
      last = slice;
    }
    ++layer;
  });
  if (!read.ok()) return read.error();
  return sample;
}

core::Result<Sample> of_part(const parts::NamedPart& part, double layer_height_mm, int count) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("{}_{}.stl", part.name, getpid());
  {
    std::ofstream file(path, std::ios::binary);
    parts::write_binary_stl(part.part, file);
  }
  core::Result<Sample> sample = of_file(path.string(), layer_height_mm, count);
  std::filesystem::remove(path);
  if (sample.ok()) sample.value().name = part.name;
  return sample;
}

}  // namespace samples
