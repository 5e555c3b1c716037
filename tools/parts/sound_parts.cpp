// The sound parts: closed, every facet counter-clockwise seen from outside.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "tools/parts/part_maker.h"
#include "tools/parts/shapes.h"

namespace parts {
namespace {

constexpr double kLayerHeight = 0.2;

// Hexagon with `corners` corners (a multiple of 6), the same number on each side.
CornerRing hexagon(int corners, double across_flats, Corner centre) {
  const double radius = across_flats / std::sqrt(3.0);
  const int per_flat = corners / 6;
  CornerRing ring;
  for (int i = 0; i < corners; ++i) {
    const double a = kPi / 3 * (i / per_flat), b = kPi / 3 * (i / per_flat + 1);
    const double share = static_cast<double>(i % per_flat) / per_flat;
    ring.push_back({centre.x + radius * (std::cos(a) + (std::cos(b) - std::cos(a)) * share),
                    centre.y + radius * (std::sin(a) + (std::sin(b) - std::sin(a)) * share),
                    centre.z});
  }
  return ring;
}

struct Thread {
  double major = 14, minor = 9, pitch = 6;
  int turns = 13, segments = 96;
  double crest = 0.1, root = 0.1;

  [[nodiscard]] int rings() const { return turns * segments; }

  // Radius of ring `k`, which is k pitch/segments above the head, at corner `i`: the thread's edges
  // follow the mesh's.
  [[nodiscard]] double radius(int i, int k) const {
    const double flank = (1 - crest - root) / 2;
    const double place = static_cast<double>(((k - i) % segments + segments) % segments) / segments;
    double depth = (1 - place) / flank;
    if (place < root) {
      depth = 0;
    } else if (place < root + flank) {
      depth = (place - root) / flank;
    } else if (place < root + flank + crest) {
      depth = 1;
    }
    const double from_head = static_cast<double>(k) / segments;
    const double from_tip = static_cast<double>(rings() - k) / segments;
    const double run_out = std::clamp(std::min(from_head, from_tip), 0.0, 1.0);
    return minor + (major - minor) * depth * run_out;
  }
};

// One turn of the tower's section, which repeats every 180 rings.
struct TowerSection {
  static constexpr int kRingsPerTurn = 180, kLayersPerRing = 10;
  static constexpr double kRadius = 12, kLobe = 0.15, kBore = 5;
  std::vector<CornerRing> outer;
  CornerRing inner;

  explicit TowerSection(const TowerSize& size) {
    const double c = kRadius * size.scale * (1 + kLobe) + 1;
    for (int turn = 0; turn < kRingsPerTurn; ++turn) {
      CornerRing ring;
      for (int i = 0; i < size.corners; ++i) {
        const double angle = 2 * kPi * i / size.corners;
        const double turned = angle + kPi / 180 * 2 * turn;
        const double radius = kRadius * size.scale * (1 + kLobe * std::cos(5 * angle));
        ring.push_back({c + radius * std::cos(turned), c + radius * std::sin(turned), 0});
      }
      outer.push_back(std::move(ring));
    }
    inner = circle(size.corners, kBore * size.scale, {c, c, 0});
  }
};

CornerRing raised(CornerRing ring, double z) {
  for (Corner& corner : ring) corner.z = z;
  return ring;
}

Wall bumpy(double base, double swell, double bump, double lobes, double turn, double ripple) {
  return [=](double angle, double z) {
    return base + swell * std::sin(kPi * z / 60) +
           bump * std::sin(lobes * angle + turn * z) * std::cos(ripple * z);
  };
}

// Walls of one cell of the lattice towards its lower neighbours, cut where the plate passes.
struct LatticeCells {
  int columns;
  double size = 4, gap = 2, plate = 1, height = 20;

  [[nodiscard]] int cells() const { return 2 * columns + 1; }
  [[nodiscard]] double line(int i) const { return i / 2 * (size + gap) + (i % 2) * gap; }
  [[nodiscard]] double top(int i, int j) const {
    if (i < 0 || j < 0 || i >= cells() || j >= cells()) return 0;
    return i % 2 == 1 && j % 2 == 1 ? height : plate;
  }
  void wall(const FacetSink& sink, Corner from, Corner to, double low, double high) const {
    const auto piece = [&](double z0, double z1) {
      if (low <= z0 && z1 <= high) {
        quad(sink, {from.x, from.y, z0}, {to.x, to.y, z0}, {to.x, to.y, z1}, {from.x, from.y, z1});
      }
    };
    piece(0, plate);
    piece(plate, height);
  }
  void cell(const FacetSink& sink, int i, int j) const {
    const double x0 = line(i), x1 = line(i + 1), y0 = line(j), y1 = line(j + 1), z = top(i, j);
    quad(sink, {x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z});
    quad(sink, {x0, y0, 0}, {x0, y1, 0}, {x1, y1, 0}, {x1, y0, 0});
    const auto side = [&](double other, Corner from, Corner to) {
      if (other < z) wall(sink, from, to, other, z);
    };
    side(top(i + 1, j), {x1, y0, 0}, {x1, y1, 0});
    side(top(i - 1, j), {x0, y1, 0}, {x0, y0, 0});
    side(top(i, j + 1), {x1, y1, 0}, {x0, y1, 0});
    side(top(i, j - 1), {x0, y0, 0}, {x1, y0, 0});
  }
};

}  // namespace

Part box(Corner at, double width, double depth, double height) {
  return [=](const FacetSink& sink) {
    const auto corner = [&](int i) {
      return Corner{at.x + (i & 1) * width, at.y + (i >> 1 & 1) * depth, at.z + (i >> 2) * height};
    };
    constexpr int kQuads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
    for (const auto& q : kQuads) {
      quad(sink, corner(q[0]), corner(q[1]), corner(q[2]), corner(q[3]));
    }
  };
}

Part pyramid(double height) {
  return [height](const FacetSink& sink) {
    const CornerRing base = {{0, 0, 0}, {100, 0, 0}, {100, 60, 0}, {0, 60, 0}};
    quad(sink, base[0], base[3], base[2], base[1]);
    cap(sink, base, {12, 30, height}, Looking::kUp);
  };
}

Part dome(double radius, int segments, int rings) {
  return [=](const FacetSink& sink) {
    const double c = radius + 1;
    CornerRing low = circle(segments, radius, {c, c, 0});
    cap(sink, low, {c, c, 0}, Looking::kDown);
    for (int k = 1; k < rings; ++k) {
      const double a = kPi / 2 * k / rings;
      CornerRing high = circle(segments, radius * std::cos(a), {c, c, radius * std::sin(a)});
      band(sink, low, high, Facing::kOutward);
      low = std::move(high);
    }
    cap(sink, low, {c, c, radius}, Looking::kUp);
  };
}

Part tube(double outer_radius, double inner_radius, double height, int segments) {
  return [=](const FacetSink& sink) {
    TubeShape shape{segments, 1, height, {}, {}};
    shape.outer = [=](double, double) { return outer_radius; };
    shape.inner = [=](double, double) { return inner_radius; };
    tube_between(sink, shape, {outer_radius + 1, outer_radius + 1, 0});
  };
}

// Ring `k` of a thread whose ring 0 is round `foot`.
CornerRing thread_ring(const Thread& thread, Corner foot, int k) {
  CornerRing all;
  const double z = foot.z + k * thread.pitch / thread.segments;
  for (int i = 0; i < thread.segments; ++i) {
    const double angle = 2 * kPi * i / thread.segments, radius = thread.radius(i, k);
    all.push_back({foot.x + radius * std::cos(angle), foot.y + radius * std::sin(angle), z});
  }
  return all;
}

// From ring 1 up, with the tip's cap.
void add_thread(const FacetSink& sink, const Thread& thread, Corner foot) {
  CornerRing low = thread_ring(thread, foot, 0);
  for (int k = 1; k <= thread.rings(); ++k) {
    CornerRing high = thread_ring(thread, foot, k);
    band(sink, low, high, Facing::kOutward);
    low = std::move(high);
  }
  cap(sink, low, {foot.x, foot.y, low.front().z}, Looking::kUp);
}

Part screw() {
  return [](const FacetSink& sink) {
    constexpr double kFlats = 34, kHead = 10;
    const Thread thread;
    const double c = kFlats / std::sqrt(3.0) + 1;
    const CornerRing foot = hexagon(thread.segments, kFlats, {c, c, 0});
    const CornerRing head = raised(foot, kHead);
    cap(sink, foot, {c, c, 0}, Looking::kDown);
    band(sink, foot, head, Facing::kOutward);
    flat_ring(sink, head, thread_ring(thread, {c, c, kHead}, 0), Looking::kUp);
    add_thread(sink, thread, {c, c, kHead});
  };
}

Part set_screw(double diameter, int turns) {
  return [=](const FacetSink& sink) {
    Thread thread;
    thread.major = diameter / 2;
    thread.minor = thread.major - 5;
    thread.turns = turns;
    const Corner foot{thread.major + 1, thread.major + 1, 0};
    cap(sink, thread_ring(thread, foot, 0), foot, Looking::kDown);
    add_thread(sink, thread, foot);
  };
}

Part tower(std::int64_t layers) {
  TowerSize size;
  size.layers = layers;
  return tower(size);
}

Part tower(const TowerSize& size) {
  return [size](const FacetSink& sink) {
    const TowerSection section(size);
    const auto height = [](std::int64_t done) { return static_cast<double>(done) * kLayerHeight; };
    const auto outer_at = [&](std::int64_t ring, double z) {
      const std::int64_t place = ring % TowerSection::kRingsPerTurn;
      return raised(section.outer[static_cast<std::size_t>(place)], z);
    };
    CornerRing low = outer_at(0, 0), low_inner = section.inner;
    flat_ring(sink, low, low_inner, Looking::kDown);
    std::int64_t done = 0;
    for (std::int64_t ring = 1; done < size.layers; ++ring) {
      done = std::min(size.layers, done + TowerSection::kLayersPerRing);
      CornerRing high = outer_at(ring, height(done));
      CornerRing high_inner = raised(section.inner, height(done));
      band(sink, low, high, Facing::kOutward);
      band(sink, low_inner, high_inner, Facing::kInward);
      low = std::move(high);
      low_inner = std::move(high_inner);
    }
    flat_ring(sink, low, low_inner, Looking::kUp);
  };
}

// A body of revolution about (c, c), from the profile's radii and heights.
static void turned(const FacetSink& sink, double c,
                   const std::vector<std::array<double, 2>>& profile, const CornerRing& start,
                   CornerRing& last) {
  constexpr int kCorners = 48;
  CornerRing low = start;
  for (const auto& [radius, z] : profile) {
    CornerRing high = circle(kCorners, radius, {c, c, z});
    const bool flat = low.front().z == z;
    const bool wider = radius > low.front().x - c;
    if (flat && wider) {
      flat_ring(sink, high, low, Looking::kDown);
    } else if (flat) {
      flat_ring(sink, low, high, Looking::kUp);
    } else {
      band(sink, low, high, Facing::kOutward);
    }
    low = std::move(high);
  }
  last = std::move(low);
}

Part shelves(std::int64_t layers) {
  return [layers](const FacetSink& sink) {
    constexpr double kCentre = 9, kShaft = 5, kShelf = 8;
    constexpr int kPerShelf = 10;
    const std::int64_t count = std::max<std::int64_t>(1, layers / kPerShelf);
    CornerRing ring = circle(48, kShaft, {kCentre, kCentre, 0});
    cap(sink, ring, {kCentre, kCentre, 0}, Looking::kDown);
    double top = 0;
    for (std::int64_t i = 0; i < count; ++i) {
      const double z = static_cast<double>(i) * kPerShelf * kLayerHeight;
      top = static_cast<double>(i + 1) * kPerShelf * kLayerHeight;
      turned(sink, kCentre,
             {{kShaft, z + 1.2},
              {kShelf, z + 1.2},
              {kShelf, z + 1.8},
              {kShaft, z + 1.8},
              {kShaft, top}},
             CornerRing(ring), ring);
    }
    cap(sink, ring, {kCentre, kCentre, top}, Looking::kUp);
  };
}

Part mushroom() {
  return [](const FacetSink& sink) {
    constexpr double kCentre = 13, kStem = 4, kCap = 12, kFoot = 10, kSpan = 90;
    CornerRing ring = circle(48, kStem, {kCentre, kCentre, 0});
    cap(sink, ring, {kCentre, kCentre, 0}, Looking::kDown);
    std::vector<std::array<double, 2>> profile = {{kStem, kFoot}};
    // The cap: flat under its rim, then a hemisphere.
    for (int degrees = 0; degrees < kSpan; degrees += 3) {
      const double angle = kPi * degrees / 180;
      profile.push_back({kCap * std::cos(angle), kFoot + kCap * std::sin(angle)});
    }
    turned(sink, kCentre, profile, CornerRing(ring), ring);
    cap(sink, ring, {kCentre, kCentre, kFoot + kCap}, Looking::kUp);
  };
}

Part comb(int teeth) {
  return [teeth](const FacetSink& sink) {
    constexpr double kWidth = 1.6, kPitch = 3.2, kHeight = 1;
    const int per_row = static_cast<int>(std::ceil(std::sqrt(teeth)));
    for (int i = 0; i < teeth; ++i) {
      box({kPitch * (i % per_row), kPitch * (i / per_row), 0}, kWidth, kWidth, kHeight)(sink);
    }
  };
}

Part vase(double detail) {
  return [detail](const FacetSink& sink) {
    const auto scaled = [detail](int count) {
      return std::max(3, static_cast<int>(count * detail));
    };
    constexpr double kCentre = 68, kHeight = 60;
    const int steps = scaled(150);
    tube_between(sink,
                 {scaled(400), steps, kHeight, bumpy(32, 6, 0.8, 40, 0.05, 0.9),
                  bumpy(22, 4, 0.5, 24, -0.1, 0.5)},
                 {kCentre, kCentre, 0});
    tube_between(sink,
                 {scaled(200), steps, kHeight, bumpy(13, 2, 0.5, 18, 0.2, 1.1),
                  bumpy(6, -1, 0.3, 9, -0.2, 0.7)},
                 {kCentre, kCentre, 0});
    for (int i = 0; i < 6; ++i) {
      const double angle = 2 * kPi * i / 6;
      tube_between(sink,
                   {scaled(100), steps, kHeight, bumpy(9, -1, 0.4, 12, 0.3, 1.3),
                    bumpy(4.5, 0.5, 0.3, 7, 0.1, 0.8)},
                   {kCentre + 54 * std::cos(angle), kCentre + 54 * std::sin(angle), 0});
    }
  };
}

Part lattice(int columns) {
  return [columns](const FacetSink& sink) {
    const LatticeCells lattice{columns};
    for (int i = 0; i < lattice.cells(); ++i) {
      for (int j = 0; j < lattice.cells(); ++j) lattice.cell(sink, i, j);
    }
  };
}

Part demo() {
  return [](const FacetSink& sink) {
    constexpr int kCorners = 96;
    constexpr double kFlats = 16, kFlange = 4, kBore = 3.2, kTop = 25;
    const double c = kFlats / std::sqrt(3.0) + 1;
    CornerRing low = hexagon(kCorners, kFlats, {c, c, 0});
    CornerRing bore = circle(kCorners, kBore, {c, c, 0});
    flat_ring(sink, low, bore, Looking::kDown);
    band(sink, bore, raised(bore, kTop), Facing::kInward);
    CornerRing flange = raised(low, kFlange);
    band(sink, low, flange, Facing::kOutward);
    low = circle(kCorners, 7.5, {c, c, kFlange});
    flat_ring(sink, flange, low, Looking::kUp);
    // radius, height: a slope, the neck, and two barbs that overhang it at 45° and taper off.
    constexpr double kProfile[][2] = {{5, 7},    {5, 9},    {6.5, 10.5}, {5, 16},
                                      {5, 17.5}, {6.5, 19}, {4.5, kTop}};
    for (const auto& [radius, z] : kProfile) {
      CornerRing high = circle(kCorners, radius, {c, c, z});
      band(sink, low, high, Facing::kOutward);
      low = std::move(high);
    }
    flat_ring(sink, low, raised(bore, kTop), Looking::kUp);
  };
}

}  // namespace parts
