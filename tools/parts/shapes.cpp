#include "tools/parts/shapes.h"

#include <cmath>

namespace parts {

void quad(const FacetSink& sink, Corner a, Corner b, Corner c, Corner d) {
  sink({a, b, c});
  sink({a, c, d});
}

CornerRing circle(int corners, double radius, Corner centre) {
  return wall_ring([radius](double, double) { return radius; }, corners, centre);
}

CornerRing wall_ring(const Wall& wall, int corners, Corner centre) {
  CornerRing ring;
  ring.reserve(static_cast<std::size_t>(corners));
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * i / corners;
    const double radius = wall(angle, centre.z);
    ring.push_back(
        {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle), centre.z});
  }
  return ring;
}

void band(const FacetSink& sink, const CornerRing& low, const CornerRing& high, Facing facing) {
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t j = (i + 1) % low.size();
    if (facing == Facing::kOutward) {
      quad(sink, low[i], low[j], high[j], high[i]);
    } else {
      quad(sink, low[j], low[i], high[i], high[j]);
    }
  }
}

void flat_ring(const FacetSink& sink, const CornerRing& outer, const CornerRing& inner,
               Looking looking) {
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const std::size_t j = (i + 1) % outer.size();
    if (looking == Looking::kUp) {
      quad(sink, inner[i], outer[i], outer[j], inner[j]);
    } else {
      quad(sink, outer[i], inner[i], inner[j], outer[j]);
    }
  }
}

void cap(const FacetSink& sink, const CornerRing& ring, Corner centre, Looking looking) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t j = (i + 1) % ring.size();
    if (looking == Looking::kUp) {
      sink({centre, ring[i], ring[j]});
    } else {
      sink({centre, ring[j], ring[i]});
    }
  }
}

void tube_between(const FacetSink& sink, const TubeShape& shape, Corner centre) {
  const double bottom = centre.z;
  CornerRing low_outer = wall_ring(shape.outer, shape.corners, centre);
  CornerRing low_inner = wall_ring(shape.inner, shape.corners, centre);
  flat_ring(sink, low_outer, low_inner, Looking::kDown);
  for (int step = 1; step <= shape.steps; ++step) {
    centre.z = bottom + shape.height * step / shape.steps;
    CornerRing high_outer = wall_ring(shape.outer, shape.corners, centre);
    CornerRing high_inner = wall_ring(shape.inner, shape.corners, centre);
    band(sink, low_outer, high_outer, Facing::kOutward);
    band(sink, low_inner, high_inner, Facing::kInward);
    low_outer = std::move(high_outer);
    low_inner = std::move(high_inner);
  }
  flat_ring(sink, low_outer, low_inner, Looking::kUp);
}

}  // namespace parts
