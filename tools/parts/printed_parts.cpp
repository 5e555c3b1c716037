// Parts such as people print: brackets, cases, signs, and bodies without a straight edge.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tools/parts/marched.h"
#include "tools/parts/outlines.h"
#include "tools/parts/part_maker.h"
#include "tools/parts/shapes.h"

namespace parts {
namespace {

constexpr int kRoundCorners = 32;

void arc(CornerRing& ring, Corner centre, double radius, double from, double to) {
  constexpr int kSteps = kRoundCorners / 4;
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = (from + (to - from) * i / kSteps) * kPi / 180;
    ring.push_back(
        {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle), centre.z});
  }
}

CornerRing rounded_rectangle(Corner at, double width, double depth, double radius) {
  CornerRing ring;
  const double right = at.x + width - radius, back = at.y + depth - radius;
  arc(ring, {right, at.y + radius, at.z}, radius, -90, 0);
  arc(ring, {right, back, at.z}, radius, 0, 90);
  arc(ring, {at.x + radius, back, at.z}, radius, 90, 180);
  arc(ring, {at.x + radius, at.y + radius, at.z}, radius, 180, 270);
  return ring;
}

CornerRing hole(Corner centre, double radius) {
  return reversed(circle(kRoundCorners, radius, centre));
}

CornerRing slot(Corner at, double width, double depth) {
  constexpr double kNearlyHalf = 0.499;  // no two corners in one place
  return reversed(rounded_rectangle(at, width, depth, kNearlyHalf * std::min(width, depth)));
}

Part plate_of(Outlines outlines, double height) {
  return [outlines = std::move(outlines), height](const FacetSink& sink) {
    plate(sink, outlines, height);
  };
}

template <typename Map>
Part mapped(Part part, const Map& map) {
  return [part = std::move(part), map](const FacetSink& sink) {
    part([&](const Facet& facet) { sink({map(facet[0]), map(facet[1]), map(facet[2])}); });
  };
}

// What lay on its back stands, its upper face at y, looking to the front.
Part upright(Part part, double y) {
  return mapped(std::move(part), [y](const Corner& c) { return Corner{c.x, y - c.z, c.y}; });
}

// A profile in y and z, from x on.
Part across(Part part, double x) {
  return mapped(std::move(part), [x](const Corner& c) { return Corner{x + c.z, c.x, c.y}; });
}

// A bar with round ends.
Part stroke(Corner from, Corner to, double width, double height) {
  const double angle = std::atan2(to.y - from.y, to.x - from.x) * 180 / kPi;
  CornerRing ring;
  arc(ring, to, width / 2, angle - 90, angle);
  ring.pop_back();
  arc(ring, to, width / 2, angle, angle + 90);
  arc(ring, from, width / 2, angle + 90, angle + 180);
  ring.pop_back();
  arc(ring, from, width / 2, angle + 180, angle + 270);
  return plate_of({ring}, height);
}

// Strokes along a line.
void strokes(std::vector<Part>& all, const CornerRing& line) {
  constexpr double kWidth = 2, kHeight = 2;
  for (std::size_t i = 1; i < line.size(); ++i) {
    all.push_back(stroke(line[i - 1], line[i], kWidth, kHeight));
  }
}

// The least of two distances, rounded where they are nearly the same.
double blended(double a, double b, double reach) {
  const double near = std::max(0.0, reach - std::abs(a - b)) / reach;
  return std::min(a, b) - near * near * reach / 4;
}

}  // namespace

Part bracket() {
  constexpr double kWidth = 60, kDepth = 40, kTall = 42, kThick = 5, kFillet = 4, kRib = 2.4;
  Outlines base = {rounded_rectangle({1, 1, 0}, kWidth, kDepth, 5)};
  for (const double x : {9.0, kWidth - 7}) {
    for (const double y : {9.0, 25.0}) base.push_back(hole({x, y, 0}, 2.25));
  }
  base.push_back(slot({23, 9, 0}, 16, 5));
  const Outlines back = {rounded_rectangle({1, 0.5, 0}, kWidth, kTall, 8),
                         hole({1 + kWidth / 2, 24, 0}, 10), hole({11, 34, 0}, 2.25),
                         hole({kWidth - 9, 34, 0}, 2.25)};
  // Sunk into base and back by half of their thickness.
  constexpr double kBack = 1 + kDepth, kFront = kBack - kThick, kSunk = kThick / 2;
  CornerRing fillet = {{kFront + kSunk, kThick - kSunk, 0}, {kFront + kSunk, kThick + kFillet, 0}};
  arc(fillet, {kFront - kFillet, kThick + kFillet, 0}, kFillet, 0, -90);
  fillet.push_back({kFront - kFillet, kThick - kSunk, 0});
  const CornerRing rib = {
      {14, kThick - kSunk, 0}, {kFront + kSunk, kThick - kSunk, 0}, {kFront + kSunk, 36, 0}};
  return together({plate_of(base, kThick), upright(plate_of(back, kThick), kBack),
                   across(plate_of({fillet}, kWidth - 16), 9), across(plate_of({rib}, kRib), 3.5),
                   across(plate_of({rib}, kRib), kWidth - 3.5 - kRib + 2)});
}

Part electronics_case() {
  constexpr double kWidth = 80, kDepth = 50, kTall = 24, kWall = 1.6, kRib = 0.8, kHigh = 12;
  const Corner at{1, 1, 0}, inner{1 + kWall, 1 + kWall, 0};
  const CornerRing outline = rounded_rectangle(at, kWidth, kDepth, 5);
  Outlines floor = {outline};
  for (int i = 0; i < 8; ++i) floor.push_back(slot({20 + 5.5 * i, 18, 0}, 2.5, 16));
  const Outlines wall = {outline, reversed(rounded_rectangle(inner, kWidth - 2 * kWall,
                                                             kDepth - 2 * kWall, 5 - kWall))};
  std::vector<Part> all = {plate_of(floor, kWall), plate_of(wall, kTall)};
  for (const double x : {17.0, 66.0}) {
    all.push_back(box({x, 1 + kWall / 2, kWall / 2}, kRib, kDepth - kWall, kHigh));
  }
  for (const double y : {14.0, 38.0}) {
    all.push_back(box({1 + kWall / 2, y, kWall / 2}, kWidth - kWall, kRib, kHigh));
  }
  for (const double x : {7.0, kWidth - 5}) {
    for (const double y : {7.0, kDepth - 5}) {
      all.push_back(plate_of(
          {circle(kRoundCorners, 3, {x, y, kWall / 2}), hole({x, y, kWall / 2}, 1.25)}, 18));
    }
  }
  return together(std::move(all));
}

Part sign() {
  constexpr double kWidth = 64, kDepth = 22, kThick = 2;
  std::vector<Part> all = {plate_of({rounded_rectangle({1, 1, 0}, kWidth, kDepth, 4),
                                     hole({5.5, 12, 0}, 1.6), hole({kWidth - 3.5, 12, 0}, 1.6)},
                                    kThick)};
  constexpr double kLow = 6, kHigh = 18, kMiddle = 12, kZ = kThick - 0.5;
  const auto at = [](double x, double y) { return Corner{x, y, kZ}; };
  const auto bow = [&](double x, double low, double high) {
    CornerRing line = {at(x, high)};
    const double radius = (high - low) / 2;
    arc(line, at(x + 3, low + radius), radius, 90, 0);
    arc(line, at(x + 3, low + radius), radius, 0, -90);
    line.push_back(at(x, low));
    line.erase(line.begin() + 2 + kRoundCorners / 4);  // the arcs' common corner
    return line;
  };
  strokes(all, {at(12, kLow), at(12, kHigh)});  // R
  strokes(all, bow(12, kMiddle, kHigh));
  strokes(all, {at(15, kMiddle), at(19, kLow)});
  strokes(all, {at(26, kLow), at(26, kHigh)});                               // I
  strokes(all, {at(33, kLow), at(33, kHigh), at(41, kLow), at(41, kHigh)});  // N
  strokes(all, {at(48, kLow), at(48, kHigh)});                               // D
  strokes(all, bow(48, kLow, kHigh));
  return together(std::move(all));
}

Part figure(double detail) {
  return [detail](const FacetSink& sink) {
    // Feet, body, arms, head, ears.
    struct Ball {
      Corner centre;
      double radius;
    };
    static constexpr Ball kBalls[] = {
        {{17, 18, 3}, 6},    {{31, 18, 3}, 6},    {{24, 18, 16}, 12},    {{11, 16, 21}, 4.5},
        {{37, 16, 21}, 4.5}, {{24, 17, 35}, 9.5}, {{16.5, 17, 44}, 3.5}, {{31.5, 17, 44}, 3.5}};
    constexpr double kReach = 5;
    const double cell = std::clamp(0.7 / detail, 0.2, 3.0), margin = cell / 2;
    const Field field = [&](const Corner& p) {
      double away = 1e3;
      for (const Ball& ball : kBalls) {
        const double x = p.x - ball.centre.x, y = p.y - ball.centre.y, z = p.z - ball.centre.z;
        away = blended(away, std::sqrt(x * x + y * y + z * z) - ball.radius, kReach);
      }
      return std::min(-away, p.z - margin);
    };
    const auto lowered = [&](const Facet& facet) {
      Facet low = facet;
      for (Corner& corner : low) corner.z -= margin;
      sink(low);
    };
    const auto cells = [cell](double size) { return static_cast<int>(std::ceil(size / cell)); };
    march(lowered, field, {cells(48), cells(38), cells(52), cell});
  };
}

}  // namespace parts
