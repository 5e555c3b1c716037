#include "host/part/layer_spool.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/random_regions.h"

using core::Length;
using core::Region;

namespace {

constexpr host::SpillUse kUse{"a test", "do nothing"};

// Runs of equal layers, empty ones, some with defects and notes.
std::vector<host::SpooledLayer> random_layers(std::uint64_t seed, int count) {
  test::Random random(seed);
  std::vector<host::SpooledLayer> layers;
  for (int i = 0; i < count; ++i) {
    host::SpooledLayer layer;
    layer.index = i;
    layer.bottom = Length::from_units(2'000LL * i);
    layer.height = Length::from_units(random.integer(500, 3'000));
    for (std::size_t k = 0; k < layer.regions.size(); ++k) {
      const double draw = random.unit();
      if (draw < 0.5 && i > 0) {
        layer.regions[k] = layers.back().regions[k];
      } else if (draw < 0.6) {
        layer.regions[k] = nullptr;
      } else {
        layer.regions[k] = std::make_shared<const Region>(
            test::random_region(random, random.integer(6, 80), random.between(2, 400)));
      }
    }
    if (random.unit() < 0.3) {
      core::ChangedAreas areas(static_cast<std::size_t>(random.integer(1, 3)));
      for (core::ChangedArea& area : areas) {
        if (random.unit() < 0.7) area.change.density = random.unit();
        if (random.unit() < 0.5) area.change.pattern = core::LoosePattern::kGyroid;
        if (random.unit() < 0.5) area.change.perimeters = random.integer(1, 50);
        for (auto& value : area.change.laid) {
          if (random.unit() < 0.1) value = random.between(0, 300);
        }
        area.region = test::random_region(random, random.integer(6, 40), random.between(2, 400));
      }
      layer.areas = std::make_shared<const core::ChangedAreas>(std::move(areas));
    }
    if (random.unit() < 0.2) layer.note = random.unit() < 0.3 ? "" : "open at 3.2 mm; äöü";
    if (random.unit() < 0.2) {
      layer.defects.dropped_chains = random.integer(0, 9);
      layer.defects.widest_gap = Length::from_units(random.integer(1, 90));
      if (random.unit() < 0.5) layer.defects.turned_at = core::Point{-5, 1 << 28};
      layer.defects.turned_contours = layer.defects.turned_at ? 1 : 0;
    }
    layers.push_back(std::move(layer));
  }
  return layers;
}

bool same(const host::SpooledLayer& a, const host::SpooledLayer& b) {
  const auto alike = [](const auto& p, const auto& q) {
    return (p ? *p : Region()) == (q ? *q : Region());
  };
  const core::SliceDefects &x = a.defects, &y = b.defects;
  const bool any = x.any() || y.any();
  if ((a.areas != nullptr) != (b.areas != nullptr)) return false;
  if (a.areas && *a.areas != *b.areas) return false;
  return a.index == b.index && a.bottom == b.bottom && a.height == b.height && a.note == b.note &&
         alike(a.regions[0], b.regions[0]) && alike(a.regions[1], b.regions[1]) &&
         (!any || (x.dropped_chains == y.dropped_chains && x.widest_gap == y.widest_gap &&
                   x.turned_contours == y.turned_contours && x.turned_at == y.turned_at));
}

}  // namespace

TEST_CASE("layers come back as they were, upwards and downwards") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CAPTURE(seed);
    const auto layers = random_layers(seed, 200);
    auto made = host::LayerSpool::create("", kUse);
    REQUIRE(made.ok());
    host::LayerSpool spool = std::move(made).value();
    for (const host::SpooledLayer& layer : layers) REQUIRE(spool.append(layer).ok());
    spool.read_backwards();
    for (std::size_t i = layers.size(); i-- > 0;) {
      CAPTURE(i);
      const auto read = spool.previous();
      REQUIRE(read.ok());
      CHECK(same(*read.value(), layers[i]));
    }
    CHECK_FALSE(spool.previous().value().has_value());
    spool.read_forwards();
    for (const host::SpooledLayer& layer : layers) CHECK(same(*spool.next().value(), layer));
    CHECK_FALSE(spool.next().value().has_value());
  }
}

TEST_CASE("equal layers take a few bytes each, and are read as one object") {
  test::Random random(3);
  const auto region = std::make_shared<const Region>(test::random_region(random, 500, 50));
  auto made = host::LayerSpool::create("", kUse);
  REQUIRE(made.ok());
  host::LayerSpool spool = std::move(made).value();
  std::int64_t first_bytes = 0;
  constexpr int kLayers = 5'000;
  for (int i = 0; i < kLayers; ++i) {
    host::SpooledLayer layer;
    layer.index = i;
    layer.bottom = Length::from_units(2'000LL * i);
    layer.height = Length::from_units(2'000);
    // Equal, but not the same.
    layer.regions[0] = std::make_shared<const Region>(*region);
    REQUIRE(spool.append(layer).ok());
    if (i == 0) first_bytes = spool.bytes();
  }
  CHECK_LT(spool.bytes() - first_bytes, 32 * kLayers);
  spool.read_backwards();
  const auto last = spool.previous().value()->regions[0];
  for (int i = 1; i < kLayers; ++i) CHECK(spool.previous().value()->regions[0] == last);
  CHECK(*last == *region);
}
