#include "core/sections/section.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/trigonometry.h"  // hypotenuse

namespace core {
namespace {

// A point as the line sees it.
struct Seen {
  std::int64_t along = 0;
  std::int64_t across = 0;
};

Seen seen(Point point, const SectionLine& line) {
  return line.across == SectionLine::Across::kY ? Seen{point.x, point.y} : Seen{point.y, point.x};
}

// Where a disc is met, or a capsule with it: [from, to], nothing when missed.
using Chord = std::optional<std::pair<double, double>>;

void widen(Chord& chord, double from, double to) {
  if (from > to) return;
  if (!chord) {
    chord = {from, to};
  } else {
    chord = {std::min(chord->first, from), std::max(chord->second, to)};
  }
}

// Narrows [low, high] to the u with  bottom <= slope · u + start <= top.
void clip(double slope, double start, double bottom, double top, double& low, double& high) {
  if (slope == 0) {
    if (start < bottom || start > top) high = low - 1;
    return;
  }
  const double a = (bottom - start) / slope, b = (top - start) / slope;
  low = std::max(low, std::min(a, b));
  high = std::min(high, std::max(a, b));
}

// All points no farther than `radius` from the segment; `level` is the line's.
Chord capsule_chord(Seen a, Seen b, double level, double radius) {
  Chord chord;
  for (const Seen& end : {a, b}) {
    const double off = static_cast<double>(end.across) - level;
    if (std::abs(off) > radius) continue;
    const double half = std::sqrt((radius - off) * (radius + off));
    const auto along = static_cast<double>(end.along);
    widen(chord, along - half, along + half);
  }
  const auto run = static_cast<double>(b.along - a.along);
  const auto rise = static_cast<double>(b.across - a.across);
  const double length = hypotenuse(run, rise);
  if (length == 0) return chord;
  // u counts from a; (u, off) is the line's point there.
  const double off = level - static_cast<double>(a.across);
  double low = -radius - length, high = radius + length;
  clip(run / length, off * rise / length, 0, length, low, high);
  clip(-rise / length, off * run / length, -radius, radius, low, high);
  widen(chord, static_cast<double>(a.along) + low, static_cast<double>(a.along) + high);
  return chord;
}

}  // namespace

Intervals joined(Intervals intervals) {
  std::sort(intervals.begin(), intervals.end());
  Intervals result;
  for (const Interval& next : intervals) {
    if (next.from >= next.to) continue;
    if (!result.empty() && next.from <= result.back().to) {
      result.back().to = std::max(result.back().to, next.to);
    } else {
      result.push_back(next);
    }
  }
  return result;
}

Intervals section_of(const Region& region, const SectionLine& line) {
  const std::int64_t at = line.at.units();
  std::vector<double> met;
  for (const Ring& ring : region.rings()) {
    Seen from = seen(ring.back(), line);
    for (const Point point : ring) {
      const Seen to = seen(point, line);
      if ((from.across > at) != (to.across > at)) {
        const double share = (static_cast<double>(at) + 0.5 - static_cast<double>(from.across)) /
                             static_cast<double>(to.across - from.across);
        met.push_back(static_cast<double>(from.along) +
                      share * static_cast<double>(to.along - from.along));
      }
      from = to;
    }
  }
  std::sort(met.begin(), met.end());
  Intervals result;
  for (std::size_t i = 0; i + 1 < met.size(); i += 2) {
    result.push_back({std::llround(met[i]), std::llround(met[i + 1])});
  }
  return joined(std::move(result));
}

Intervals section_of(const Road& road, const SectionLine& line) {
  const double level = static_cast<double>(line.at.units()) + 0.5;
  const std::size_t count = road.points.size();
  Intervals result;
  for (std::size_t i = 0; i + (road.closed ? 0 : 1) < count; ++i) {
    const std::size_t j = (i + 1) % count;
    const Seen a = seen(road.points[i], line), b = seen(road.points[j], line);
    const double radius = static_cast<double>((width_at(road, i) + width_at(road, j)).units()) / 4;
    const auto nearest = static_cast<double>(std::min(a.across, b.across)) - level;
    const auto farthest = static_cast<double>(std::max(a.across, b.across)) - level;
    if (nearest > radius || farthest < -radius) continue;
    if (const Chord chord = capsule_chord(a, b, level, radius)) {
      result.push_back({std::llround(chord->first), std::llround(chord->second)});
    }
  }
  return joined(std::move(result));
}

Intervals intersect(const Intervals& a, const Intervals& b) {
  Intervals result;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const Interval both{std::max(a[i].from, b[j].from), std::min(a[i].to, b[j].to)};
    if (both.from < both.to) result.push_back(both);
    a[i].to < b[j].to ? ++i : ++j;
  }
  return result;
}

Intervals subtract(const Intervals& a, const Intervals& b) {
  Intervals result;
  std::size_t j = 0;
  for (Interval left : a) {
    while (j < b.size() && b[j].to <= left.from) ++j;
    for (std::size_t k = j; k < b.size() && b[k].from < left.to; ++k) {
      if (b[k].from > left.from) result.push_back({left.from, b[k].from});
      left.from = std::max(left.from, b[k].to);
    }
    if (left.from < left.to) result.push_back(left);
  }
  return result;
}

Length total_length(const Intervals& intervals) {
  Length sum;
  for (const Interval& interval : intervals) {
    sum += Length::from_units(interval.to - interval.from);
  }
  return sum;
}

}  // namespace core
