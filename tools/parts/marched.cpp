#include "tools/parts/marched.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace parts {
namespace {

struct Sample {
  Corner at;
  double value = 0;
  int number = 0;  // within the cell: bits for x, y, z
};

// Where the field is 0 between two samples; the same from both sides, and in all cells.
Corner between(const Sample& a, const Sample& b) {
  const Sample &low = a.number < b.number ? a : b, &high = a.number < b.number ? b : a;
  const double share = low.value / (low.value - high.value);
  return {low.at.x + share * (high.at.x - low.at.x), low.at.y + share * (high.at.y - low.at.y),
          low.at.z + share * (high.at.z - low.at.z)};
}

// Turned so that `within` lies behind it.
void facet(const FacetSink& sink, const Corner& a, Corner b, Corner c, const Corner& within) {
  const Corner u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Corner w{within.x - a.x, within.y - a.y, within.z - a.z};
  const double side =
      (u.y * v.z - u.z * v.y) * w.x + (u.z * v.x - u.x * v.z) * w.y + (u.x * v.y - u.y * v.x) * w.z;
  if (side > 0) std::swap(b, c);
  sink({a, b, c});
}

void tetrahedron(const FacetSink& sink, const std::array<const Sample*, 4>& corners) {
  std::vector<const Sample*> in, out;
  for (const Sample* corner : corners) (corner->value > 0 ? in : out).push_back(corner);
  if (in.size() == 1) {
    facet(sink, between(*in[0], *out[0]), between(*in[0], *out[1]), between(*in[0], *out[2]),
          in[0]->at);
  } else if (in.size() == 3) {
    facet(sink, between(*in[0], *out[0]), between(*in[1], *out[0]), between(*in[2], *out[0]),
          in[0]->at);
  } else if (in.size() == 2) {
    const Corner a = between(*in[0], *out[0]), b = between(*in[0], *out[1]);
    const Corner c = between(*in[1], *out[1]), d = between(*in[1], *out[0]);
    facet(sink, a, b, c, in[0]->at);
    facet(sink, a, c, d, in[0]->at);
  }
}

}  // namespace

void march(const FacetSink& sink, const Field& field, const FieldGrid& grid) {
  constexpr int kTetrahedra[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                     {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
  const auto place = [&](int i, int j, int k) {
    return Corner{i * grid.cell, j * grid.cell, k * grid.cell};
  };
  const auto index = [&](int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.columns + 1) +
           static_cast<std::size_t>(i);
  };
  const auto level = [&](int k) {
    std::vector<double> values(index(0, grid.rows + 1));
    for (int j = 0; j <= grid.rows; ++j) {
      for (int i = 0; i <= grid.columns; ++i) values[index(i, j)] = field(place(i, j, k));
    }
    return values;
  };
  std::vector<double> below = level(0);
  for (int k = 0; k < grid.levels; ++k) {
    std::vector<double> above = level(k + 1);
    for (int j = 0; j < grid.rows; ++j) {
      for (int i = 0; i < grid.columns; ++i) {
        std::array<Sample, 8> cell;
        int inside = 0;
        for (int m = 0; m < 8; ++m) {
          const int x = i + (m & 1), y = j + (m >> 1 & 1);
          const double value = (m < 4 ? below : above)[index(x, y)];
          cell[static_cast<std::size_t>(m)] = {place(x, y, k + (m >> 2)), value, m};
          inside += value > 0 ? 1 : 0;
        }
        if (inside == 0 || inside == 8) continue;
        for (const auto& t : kTetrahedra) {
          const auto at = [&](int n) { return &cell[static_cast<std::size_t>(t[n])]; };
          tetrahedron(sink, {at(0), at(1), at(2), at(3)});
        }
      }
    }
    below = std::move(above);
  }
}

}  // namespace parts
