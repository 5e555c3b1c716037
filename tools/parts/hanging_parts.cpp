// Sound parts that hang: spheres, ramps, arches, tees.
#include <cmath>
#include <utility>
#include <vector>

#include "tools/parts/part_maker.h"
#include "tools/parts/shapes.h"

namespace parts {
namespace {

// A profile's edge, with y = 0.
using Edge = std::vector<Corner>;

// The strip between two edges of a profile, from y = `front` on, `depth` deep. Both have as many
// corners; the profile is on the right of one who follows `left`.
void extrude(const FacetSink& sink, const Edge& left, const Edge& right, double front,
             double depth) {
  const auto at = [](const Corner& corner, double y) { return Corner{corner.x, y, corner.z}; };
  const double back = front + depth;
  const auto face = [&](const Corner& a, const Corner& b) {
    quad(sink, at(a, front), at(a, back), at(b, back), at(b, front));
  };
  for (std::size_t i = 0; i + 1 < left.size(); ++i) {
    const Corner &a = left[i], &b = right[i], &c = right[i + 1], &d = left[i + 1];
    quad(sink, at(a, front), at(b, front), at(c, front), at(d, front));
    quad(sink, at(b, back), at(a, back), at(d, back), at(c, back));
    face(d, a);
    face(b, c);
  }
  face(left.front(), right.front());
  face(right.back(), left.back());
}

}  // namespace

Part sphere(double radius) {
  return [radius](const FacetSink& sink) {
    constexpr int kCorners = 96, kRings = 64;
    // Flat where it stands, 15° around the pole.
    constexpr double kLowest = -75.0 / 180 * kPi;
    const double centre = radius + 1, lift = -radius * std::sin(kLowest);
    const auto ring_at = [&](int i) {
      const double angle = kLowest + (kPi / 2 - kLowest) * i / kRings;
      const double z = lift + radius * std::sin(angle);
      return circle(kCorners, radius * std::cos(angle), {centre, centre, i == 0 ? 0 : z});
    };
    CornerRing low = ring_at(0);
    cap(sink, low, {centre, centre, 0}, Looking::kDown);
    for (int i = 1; i < kRings; ++i) {
      CornerRing high = ring_at(i);
      band(sink, low, high, Facing::kOutward);
      low = std::move(high);
    }
    cap(sink, low, {centre, centre, lift + radius}, Looking::kUp);
  };
}

Part ramp(double angle_degrees, double height) {
  return [=](const FacetSink& sink) {
    constexpr double kFoot = 10, kDepth = 20, kStart = 2;
    const double reach = height * std::tan(angle_degrees / 180 * kPi);
    extrude(sink, {{1, 0, 0}, {1, 0, kStart}, {1, 0, kStart + height}},
            {{1 + kFoot, 0, 0}, {1 + kFoot, 0, kStart}, {1 + kFoot + reach, 0, kStart + height}}, 1,
            kDepth);
  };
}

Part arch(double span) {
  return [span](const FacetSink& sink) {
    constexpr double kWall = 4, kLeg = 5, kDepth = 10;
    constexpr int kPieces = 48;
    const double inner = span / 2, outer = inner + kWall, x = 1 + outer;
    Edge above{{x - outer, 0, 0}}, below{{x - inner, 0, 0}};
    for (int i = 0; i <= kPieces; ++i) {
      const double angle = kPi - kPi * i / kPieces;
      above.push_back({x + outer * std::cos(angle), 0, kLeg + outer * std::sin(angle)});
      below.push_back({x + inner * std::cos(angle), 0, kLeg + inner * std::sin(angle)});
    }
    above.back() = {x + outer, 0, kLeg};
    below.back() = {x + inner, 0, kLeg};
    above.push_back({x + outer, 0, 0});
    below.push_back({x + inner, 0, 0});
    extrude(sink, above, below, 1, kDepth);
  };
}

Part tee() { return together({box({9, 1, 0}, 6, 10, 12), box({1, 1, 12}, 22, 10, 3)}); }

}  // namespace parts
