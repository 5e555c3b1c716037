// How long a minimal loop takes for what each stage of `rind slice` must do at the very least, on
// the same part: what no better program could go below by much. `tools/bench_stages` prints it
// beside the stages themselves.
//
//     stage_bounds part.stl part.gcode [--layer-height 0.2] [--depths 9] [--neighbours 4]
//
//     read     take every byte; of an STL each facet's lowest and highest z
//     slice    cut every facet at every layer's height, chain the segments by a hash of their ends
//     offset   move every edge inwards, meet its neighbours, at each depth; nothing is trimmed
//     window   sort a slice's edges, one pass over them and those of each neighbour
//     roads    offset every edge for each perimeter, cut rows 0.45 mm apart through all edges and
//              sort their ends
//     lay      the length and the filament of every move in the G-code
//     encode   write its numbers as text; a trapezoid of speed for each
//
// Prints one stage a line: its name and milliseconds of the processor, the least of three runs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/regions/region.h"
#include "tools/samples/slice_samples.h"

namespace {

// Stops the compiler from leaving a loop out.
volatile double kept;

double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

void measure(const char* stage, const std::function<double()>& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double begin = cpu_ms();
    kept = work();
    least = std::min(least, cpu_ms() - begin);
  }
  fmt::print("{} {:.2f}\n", stage, least);
}

struct Facet {
  std::array<float, 9> at;
};

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  std::string bytes(static_cast<std::size_t>(std::max<std::streamoff>(0, file.tellg())), '\0');
  file.seekg(0).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

// Of a binary STL; none of anything else.
std::size_t facet_count(const std::string& bytes) {
  if (bytes.size() < 84) return 0;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  return bytes.size() == 84 + std::size_t{count} * 50 ? count : 0;
}

Facet facet_at(const std::string& bytes, std::size_t i) {
  Facet facet{};
  std::memcpy(facet.at.data(), bytes.data() + 84 + i * 50 + 12, 36);
  return facet;
}

std::vector<Facet> facets_of(const std::string& bytes) {
  std::vector<Facet> facets(facet_count(bytes));
  for (std::size_t i = 0; i < facets.size(); ++i) facets[i] = facet_at(bytes, i);
  return facets;
}

double read(const std::string& path) {
  const std::string bytes = bytes_of(path);
  const std::size_t count = facet_count(bytes);
  if (count == 0) return static_cast<double>(std::count(bytes.begin(), bytes.end(), '<'));
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Facet facet = facet_at(bytes, i);
    sum += std::max({facet.at[2], facet.at[5], facet.at[8]}) -
           std::min({facet.at[2], facet.at[5], facet.at[8]});
  }
  return sum;
}

struct Cut {
  std::int64_t from;
  std::int64_t to;
};

std::int64_t point_key(const float* a, const float* b, float z) {
  const float share = (z - a[2]) / (b[2] - a[2]);
  const auto x = static_cast<std::int32_t>(std::lround((a[0] + share * (b[0] - a[0])) * 1e4F));
  const auto y = static_cast<std::int32_t>(std::lround((a[1] + share * (b[1] - a[1])) * 1e4F));
  return (std::int64_t{x} << 32) | static_cast<std::uint32_t>(y);
}

// The facet's edges that pass z, from the one that goes up to the one that goes down.
bool cut(const Facet& facet, float z, Cut& made) {
  int found = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const float* a = &facet.at[i * 3];
    const float* b = &facet.at[(i + 1) % 3 * 3];
    if ((a[2] < z) == (b[2] < z)) continue;
    ++found;
    (a[2] < z ? made.from : made.to) = a[2] < z ? point_key(a, b, z) : point_key(b, a, z);
  }
  return found == 2;
}

// Which segment starts where each one ends: a table at most half full, without lists.
double chained(const std::vector<Cut>& cuts, std::vector<std::uint32_t>& table) {
  const std::size_t size = std::bit_ceil(cuts.size() * 2 + 1);
  table.assign(size, 0);
  const auto place = [&](std::int64_t key) {
    return static_cast<std::size_t>((static_cast<std::uint64_t>(key) * 0x9E3779B97F4A7C15U) >> 32) &
           (size - 1);
  };
  for (std::uint32_t i = 0; i < cuts.size(); ++i) {
    std::size_t at = place(cuts[i].from);
    while (table[at] != 0) at = (at + 1) & (size - 1);
    table[at] = i + 1;
  }
  double met = 0;
  for (const Cut& one : cuts) {
    std::size_t at = place(one.to);
    while (table[at] != 0 && cuts[table[at] - 1].from != one.to) at = (at + 1) & (size - 1);
    met += table[at];
  }
  return met;
}

double slice(const std::vector<Facet>& facets, double height_mm) {
  float low = std::numeric_limits<float>::max(), high = -low;
  for (const Facet& facet : facets) {
    for (const std::size_t i : {2U, 5U, 8U}) {
      low = std::min(low, facet.at[i]);
      high = std::max(high, facet.at[i]);
    }
  }
  const auto layers = static_cast<std::size_t>(std::max(0.0, (high - low) / height_mm)) + 1;
  std::vector<std::vector<Cut>> by_layer(layers);
  for (const Facet& facet : facets) {
    const float bottom = std::min({facet.at[2], facet.at[5], facet.at[8]});
    const float top = std::max({facet.at[2], facet.at[5], facet.at[8]});
    auto layer = static_cast<std::size_t>(std::lround((bottom - low) / height_mm));
    for (; layer < layers; ++layer) {
      const auto z = static_cast<float>(low + (static_cast<double>(layer) + 0.5) * height_mm);
      if (z >= top) break;
      Cut made{};
      if (cut(facet, z, made)) by_layer[layer].push_back(made);
    }
  }
  std::vector<std::uint32_t> table;
  double sum = 0;
  for (const std::vector<Cut>& cuts : by_layer) sum += chained(cuts, table);
  return sum;
}

struct Corner {
  double x, y;
};

// One ring's parallel at a depth.
void add_moved(const core::Ring& ring, double depth, std::vector<Corner>& moved) {
  const std::size_t count = ring.size();
  for (std::size_t i = 0; i < count; ++i) {
    const core::Point a = ring[i > 0 ? i - 1 : count - 1], b = ring[i];
    const core::Point c = ring[i + 1 < count ? i + 1 : 0];
    const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - b.x, vy = c.y - b.y;
    const double u = std::sqrt(ux * ux + uy * uy), v = std::sqrt(vx * vx + vy * vy);
    const double turn = 1 + (ux * vx + uy * vy) / (u * v);
    const double share = depth / std::max(turn, 0.1);
    moved.push_back({b.x - (uy / u + vy / v) * share, b.y + (ux / u + vx / v) * share});
  }
}

double offset(const std::vector<core::Region>& slices, int depths) {
  std::vector<Corner> moved;
  double sum = 0;
  for (const core::Region& region : slices) {
    for (int i = 1; i <= depths; ++i) {
      moved.clear();
      for (const core::Ring& ring : region.rings()) add_moved(ring, i * 2'000.0, moved);
      for (const Corner& corner : moved) sum += corner.x;
    }
  }
  return sum;
}

struct Edge {
  core::Point low, high;
};

std::vector<Edge> sorted_edges(const core::Region& region) {
  std::vector<Edge> edges;
  for (const core::Ring& ring : region.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const core::Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
      edges.push_back(a.y < b.y ? Edge{a, b} : Edge{b, a});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.low.y < b.low.y; });
  return edges;
}

// One pass upwards over the edges of both.
double merged(const std::vector<Edge>& a, const std::vector<Edge>& b) {
  double sum = 0;
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    const bool from_a = j == b.size() || (i < a.size() && a[i].low.y < b[j].low.y);
    const Edge& edge = from_a ? a[i++] : b[j++];
    sum += edge.high.x - edge.low.x;
  }
  return sum;
}

double window(const std::vector<core::Region>& slices, int neighbours) {
  double sum = 0;
  std::vector<std::vector<Edge>> edges;
  for (const core::Region& region : slices) edges.push_back(sorted_edges(region));
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (int k = 1; k <= neighbours && i >= static_cast<std::size_t>(k); ++k) {
      sum += merged(edges[i], edges[i - static_cast<std::size_t>(k)]);
    }
  }
  return sum;
}

double roads(const std::vector<core::Region>& slices, int perimeters) {
  double sum = offset(slices, perimeters);
  constexpr double kRow = 4'500;
  std::vector<std::vector<double>> rows;
  for (const core::Region& region : slices) {
    if (region.empty()) continue;
    const core::Box box = region.box();
    rows.assign(static_cast<std::size_t>((box.max.y - box.min.y) / kRow) + 1, {});
    for (const Edge& edge : sorted_edges(region)) {
      const double x = edge.low.x, y = edge.low.y;
      const double slope = (edge.high.x - x) / std::max(1.0, edge.high.y - y);
      auto row = static_cast<std::size_t>(std::ceil((y - box.min.y) / kRow));
      for (; row < rows.size(); ++row) {
        const double at = box.min.y + static_cast<double>(row) * kRow;
        if (at > edge.high.y) break;
        rows[row].push_back(x + slope * (at - y));
      }
    }
    for (std::vector<double>& row : rows) {
      std::sort(row.begin(), row.end());
      for (const double at : row) sum += at;
    }
  }
  return sum;
}

struct Move {
  double x, y, filament;
};

std::vector<Move> moves_of(const std::string& path) {
  std::vector<Move> moves;
  std::ifstream file(path);
  Move at{};
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("G1 ") && !line.starts_with("G0 ")) continue;
    const auto value = [&](char letter, double otherwise) {
      const std::size_t place = line.find(std::string(" ") + letter);
      return place == std::string::npos ? otherwise : std::stod(line.substr(place + 2));
    };
    at = {value('X', at.x), value('Y', at.y), value('E', at.filament)};
    moves.push_back(at);
  }
  return moves;
}

double lay(const std::vector<Move>& moves) {
  double filament = 0;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    const double x = moves[i].x - moves[i - 1].x, y = moves[i].y - moves[i - 1].y;
    filament += std::sqrt(x * x + y * y) * 0.0374;
  }
  return filament;
}

char* put(char letter, double value, int decimals, char* end, char* limit) {
  *end++ = ' ';
  *end++ = letter;
  return std::to_chars(end, limit, value, std::chars_format::fixed, decimals).ptr;
}

double encode(const std::vector<Move>& moves) {
  std::array<char, 96> line{};
  double seconds = 0, bytes = 0, speed = 0;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    char* end = line.data();
    char* const limit = line.data() + line.size();
    *end++ = 'G';
    *end++ = '1';
    end = put('X', moves[i].x, 3, end, limit);
    end = put('Y', moves[i].y, 3, end, limit);
    end = put('E', moves[i].filament, 5, end, limit);
    *end++ = '\n';
    bytes += static_cast<double>(end - line.data());
    const double x = moves[i].x - moves[i - 1].x, y = moves[i].y - moves[i - 1].y;
    const double length = std::sqrt(x * x + y * y);
    const double reached = std::min(60.0, std::sqrt(speed * speed + 2 * 1'000 * length));
    seconds += length / std::max(1.0, (speed + reached) / 2);
    speed = reached;
  }
  return bytes + seconds;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Minimal loops for the stages of `rind slice`.");
  std::string part, gcode;
  double height_mm = 0.2;
  int depths = 9, neighbours = 4;
  app.add_option("part", part, "the part's file")->required();
  app.add_option("gcode", gcode, "what rind made of it")->required();
  app.add_option("--layer-height", height_mm, "millimetres")->check(CLI::PositiveNumber);
  app.add_option("--depths", depths, "insets of a slice")->check(CLI::PositiveNumber);
  app.add_option("--neighbours", neighbours, "slices that a layer's wall depends on")
      ->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);

  std::vector<core::Region> slices;
  const core::Status sliced = samples::for_slices(
      part, height_mm, [&](const core::Region& region) { slices.push_back(region); });
  if (!sliced.ok()) {
    fmt::print(stderr, "{}\n", sliced.error().message);
    return 3;
  }
  const std::vector<Facet> facets = facets_of(bytes_of(part));
  const std::vector<Move> moves = moves_of(gcode);
  measure("read", [&] { return read(part); });
  if (!facets.empty()) measure("slice", [&] { return slice(facets, height_mm); });
  measure("offset", [&] { return offset(slices, depths); });
  measure("window", [&] { return window(slices, neighbours); });
  measure("roads", [&] { return roads(slices, 3); });
  measure("lay", [&] { return lay(moves); });
  measure("encode", [&] { return encode(moves); });
}
