// Parts that are hard to slice: very many corners, islands, holes or narrow places in a plane.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "tools/parts/marched.h"
#include "tools/parts/outlines.h"
#include "tools/parts/part_maker.h"
#include "tools/parts/shapes.h"

namespace parts {
namespace {

constexpr int kPerSide = 10;  // corners on a side of a cell

// Numbers that are the same with every standard library.
class Noise {
 public:
  explicit Noise(std::uint32_t seed) : numbers_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(numbers_()) / 4294967296.0;
  }

 private:
  std::mt19937 numbers_;
};

// A square cell's contour from its corner at (0, 0), with corners on its sides where neighbours
// have them.
CornerRing cell_ring(int i, int j, double pitch, double z) {
  CornerRing ring;
  const auto at = [&](int x, int y) {
    ring.push_back({(i + static_cast<double>(x) / kPerSide) * pitch,
                    (j + static_cast<double>(y) / kPerSide) * pitch, z});
  };
  // Begins in the middle of the right side, where a circle's first corner is.
  constexpr int kHalf = kPerSide / 2;
  for (int n = kHalf; n < kPerSide; ++n) at(kPerSide, n);
  for (int n = kPerSide; n > 0; --n) at(n, kPerSide);
  for (int n = kPerSide; n > 0; --n) at(0, n);
  for (int n = 0; n < kPerSide; ++n) at(n, 0);
  for (int n = 0; n < kHalf; ++n) at(kPerSide, n);
  return ring;
}

// The wall of a plate of cells from z = 0 up.
void cells_rim(const FacetSink& sink, int columns, double pitch, double height) {
  CornerRing rim;
  const auto at = [&](int x, int y) {
    rim.push_back(
        {static_cast<double>(x / kPerSide + static_cast<double>(x % kPerSide) / kPerSide) * pitch,
         (y / kPerSide + static_cast<double>(y % kPerSide) / kPerSide) * pitch, 0});
  };
  const int end = columns * kPerSide;
  for (int n = 0; n < end; ++n) at(n, 0);
  for (int n = 0; n < end; ++n) at(end, n);
  for (int n = end; n > 0; --n) at(n, end);
  for (int n = end; n > 0; --n) at(0, n);
  plate_sides(sink, {rim}, height);
}

void koch_side(CornerRing& ring, const Corner& a, const Corner& b, int level) {
  if (level == 0) {
    ring.push_back(a);
    return;
  }
  const double dx = (b.x - a.x) / 3, dy = (b.y - a.y) / 3, tall = std::sqrt(3.0) / 2;
  const Corner first{a.x + dx, a.y + dy, 0}, last{a.x + 2 * dx, a.y + 2 * dy, 0};
  const Corner tip{first.x + dx / 2 + dy * tall, first.y + dy / 2 - dx * tall, 0};
  koch_side(ring, a, first, level - 1);
  koch_side(ring, first, tip, level - 1);
  koch_side(ring, tip, last, level - 1);
  koch_side(ring, last, b, level - 1);
}

}  // namespace

Part pins(int columns) {
  return [columns](const FacetSink& sink) {
    constexpr double kPitch = 2.5, kRadius = 0.9;
    for (int i = 0; i < columns * columns; ++i) {
      const Corner centre{2 + kPitch * (i % columns), 2 + kPitch * (i / columns), 0};
      plate(sink, {circle(24, kRadius, centre)}, 1);
    }
  };
}

Part perforated(int columns) {
  return [columns](const FacetSink& sink) {
    constexpr double kPitch = 3, kHeight = 4;
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < columns; ++j) {
        const Corner centre{(i + 0.5) * kPitch, (j + 0.5) * kPitch, 0};
        const CornerRing low = cell_ring(i, j, kPitch, 0), high = cell_ring(i, j, kPitch, kHeight);
        const CornerRing hole = circle(4 * kPerSide, 1, centre);
        const CornerRing top = circle(4 * kPerSide, 1, {centre.x, centre.y, kHeight});
        flat_ring(sink, low, hole, Looking::kDown);
        band(sink, hole, top, Facing::kInward);
        flat_ring(sink, high, top, Looking::kUp);
      }
    }
    cells_rim(sink, columns, kPitch, kHeight);
  };
}

Part engraved(int columns) {
  return [columns](const FacetSink& sink) {
    constexpr double kPitch = 3.6, kFloor = 2, kHeight = 3;
    Noise noise(1);
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < columns; ++j) {
        const Corner centre{(i + 0.5) * kPitch, (j + 0.5) * kPitch, kFloor};
        const CornerRing pocket = wall_ring([&](double, double) { return noise.between(0.5, 1.4); },
                                            4 * kPerSide, centre);
        CornerRing top = pocket;
        for (Corner& corner : top) corner.z = kHeight;
        cap(sink, cell_ring(i, j, kPitch, 0), {centre.x, centre.y, 0}, Looking::kDown);
        cap(sink, pocket, centre, Looking::kUp);
        band(sink, pocket, top, Facing::kInward);
        flat_ring(sink, cell_ring(i, j, kPitch, kHeight), top, Looking::kUp);
      }
    }
    cells_rim(sink, columns, kPitch, kHeight);
  };
}

Part noisy_ring(int corners) {
  return [corners](const FacetSink& sink) {
    constexpr double kOuter = 40, kInner = 38.7, kNoise = 0.01;
    Noise noise(1);
    const auto ring = [&](double radius) {
      CornerRing all = circle(corners, radius, {kOuter + 1, kOuter + 1, 0});
      for (Corner& corner : all) {
        corner.x += noise.between(-kNoise, kNoise);
        corner.y += noise.between(-kNoise, kNoise);
      }
      return all;
    };
    const CornerRing outer = ring(kOuter), inner = ring(kInner);
    const auto raised = [](CornerRing all) {
      for (Corner& corner : all) corner.z = 1;
      return all;
    };
    flat_ring(sink, outer, inner, Looking::kDown);
    band(sink, outer, raised(outer), Facing::kOutward);
    band(sink, inner, raised(inner), Facing::kInward);
    flat_ring(sink, raised(outer), raised(inner), Looking::kUp);
  };
}

Part koch(int level) {
  return [level](const FacetSink& sink) {
    CornerRing ring, triangle = circle(3, 50, {51, 51, 0});
    for (std::size_t i = 0; i < 3; ++i) koch_side(ring, triangle[i], triangle[(i + 1) % 3], level);
    // Every corner sees the centre's side of it, or lies on it: the face is a fan of slivers that
    // turn both ways, and flat.
    CornerRing top = ring;
    for (Corner& corner : top) corner.z = 2;
    cap(sink, ring, {51, 51, 0}, Looking::kDown);
    band(sink, ring, top, Facing::kOutward);
    cap(sink, top, {51, 51, 2}, Looking::kUp);
  };
}

Part spiral(int turns) {
  return [turns](const FacetSink& sink) {
    constexpr double kPitch = 1.2, kHalfWall = 0.3, kHeight = 2;
    constexpr int kPerTurn = 200;
    const double centre = turns * kPitch + 5;
    const auto at = [&](int k, double off, double z) {
      const double angle = 2 * kPi * k / kPerTurn, radius = 2 + kPitch * k / kPerTurn + off;
      return Corner{centre + radius * std::cos(angle), centre + radius * std::sin(angle), z};
    };
    const auto wall = [&](int k, double off, int next, double next_off) {
      quad(sink, at(k, off, 0), at(next, next_off, 0), at(next, next_off, kHeight),
           at(k, off, kHeight));
    };
    const int last = turns * kPerTurn;
    for (int k = 0; k < last; ++k) {
      wall(k, kHalfWall, k + 1, kHalfWall);
      wall(k + 1, -kHalfWall, k, -kHalfWall);
      quad(sink, at(k, -kHalfWall, kHeight), at(k, kHalfWall, kHeight),
           at(k + 1, kHalfWall, kHeight), at(k + 1, -kHalfWall, kHeight));
      quad(sink, at(k, kHalfWall, 0), at(k, -kHalfWall, 0), at(k + 1, -kHalfWall, 0),
           at(k + 1, kHalfWall, 0));
    }
    wall(0, -kHalfWall, 0, kHalfWall);
    wall(last, kHalfWall, last, -kHalfWall);
  };
}

Part tubes(int count) {
  return [count](const FacetSink& sink) {
    constexpr double kPitch = 1.2, kHalfWall = 0.4;
    const double centre = 4 + kPitch * count + 2;
    for (int i = 0; i < count; ++i) {
      const double radius = 4 + kPitch * i;
      const auto wall = [](double r) { return [r](double, double) { return r; }; };
      tube_between(sink, {720, 1, 2, wall(radius + kHalfWall), wall(radius - kHalfWall)},
                   {centre, centre, 0});
    }
  };
}

Part spikes(int columns) {
  return [columns](const FacetSink& sink) {
    constexpr double kPitch = 2, kWidth = 1.8, kHeight = 3;
    for (int i = 0; i < columns * columns; ++i) {
      const Corner at{1 + kPitch * (i % columns), 1 + kPitch * (i / columns), 0};
      const CornerRing foot = rectangle(at, kWidth, kWidth);
      cap(sink, foot, {at.x + kWidth / 2, at.y + kWidth / 2, 0}, Looking::kDown);
      cap(sink, foot, {at.x + kWidth / 2, at.y + kWidth / 2, kHeight}, Looking::kUp);
    }
  };
}

Part gyroid(double detail) {
  return [detail](const FacetSink& sink) {
    constexpr double kSize = 40, kPeriod = 12, kThickness = 0.4;
    const int cells = std::max(8, static_cast<int>(std::lround(40 * detail)));
    const double cell = kSize / cells, margin = 0.501 * cell, k = 2 * kPi / kPeriod;
    const Field field = [&](const Corner& p) {
      const double x = k * p.x, y = k * p.y, z = k * p.z;
      const double sheet =
          kThickness - std::abs(std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) +
                                std::sin(z) * std::cos(x));
      double rim = kSize;
      for (const double place : {p.x, p.y, p.z}) {
        rim = std::min({rim, place - margin, kSize - margin - place});
      }
      return std::min(sheet, 2 * rim);
    };
    const auto lowered = [&](const Facet& facet) {
      Facet low = facet;
      for (Corner& corner : low) corner.z -= margin;
      sink(low);
    };
    march(lowered, field, {cells, cells, cells, cell});
  };
}

Part soup(int facets) {
  return [facets](const FacetSink& sink) {
    Noise noise(2);
    for (int i = 0; i < facets; ++i) {
      const double x = noise.between(10, 60), y = noise.between(10, 60), z = noise.between(0, 10);
      Facet facet;
      for (Corner& corner : facet) {
        corner.x = x + noise.between(-8, 8);
        corner.y = y + noise.between(-8, 8);
        corner.z = std::max(0.0, z + noise.between(-3, 3));
      }
      sink(facet);
    }
  };
}

}  // namespace parts
