#include "host/pipeline/layer_times.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

TEST_CASE("no layer, no time") {
  const host::LayerTimes times;
  CHECK_EQ(times.median_ms(), 0);
  CHECK_EQ(times.worst_ms(), 0);
}

TEST_CASE("the median is right to 5 %, the worst exactly and with its layer") {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::lognormal_distribution<double> draw(std::log(3e-3), 1.5);
    host::LayerTimes times;
    std::vector<double> all;
    const std::size_t count = 1 + random() % 500;
    for (std::size_t i = 0; i < count; ++i) {
      all.push_back(std::max(draw(random), 1e-6));
      times.add(static_cast<core::LayerIndex>(i), all.back());
    }
    const auto worst = std::max_element(all.begin(), all.end());
    CHECK_EQ(times.worst_layer(), worst - all.begin());
    CHECK_EQ(times.worst_ms(), *worst * 1e3);
    std::sort(all.begin(), all.end());
    const double median_ms = all[(count - 1) / 2] * 1e3;
    CHECK(times.median_ms() == doctest::Approx(median_ms).epsilon(0.05));
  }
}

TEST_CASE("times out of all bounds are counted all the same") {
  host::LayerTimes times;
  times.add(0, 0);
  times.add(1, 1e-9);
  CHECK_LT(times.median_ms(), 2e-3);
  times.add(2, 1e9);
  times.add(3, 1e9);
  times.add(4, 1e9);
  CHECK_GT(times.median_ms(), 3.6e6);
  CHECK_EQ(times.worst_layer(), 2);
}
