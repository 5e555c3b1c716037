#include "host/pipeline/layer_watch.h"

#include <doctest/doctest.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

using core::Length;
using host::LayerWatch;
using host::SlowLayer;

namespace {

// What was told, to be waited for.
class Told {
 public:
  LayerWatch::Tell teller() {
    return [this](const SlowLayer& layer) {
      const std::lock_guard lock(mutex_);
      layers_.push_back(layer);
      changed_.notify_all();
    };
  }
  // False: it did not come to so many within half a minute.
  bool wait_for(std::size_t count) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(30),
                             [&] { return layers_.size() >= count; });
  }
  std::vector<SlowLayer> layers() {
    const std::lock_guard lock(mutex_);
    return layers_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<SlowLayer> layers_;
};

core::Ring square(std::int32_t at, std::int32_t side, bool hole) {
  const core::Ring ring{{at, at}, {at + side, at}, {at + side, at + side}, {at, at + side}};
  return hole ? core::Ring(ring.rbegin(), ring.rend()) : ring;
}

core::Region region_of_two() {
  return core::Region::from_clean_rings(
      {square(0, 900, false), square(100, 300, true), square(1'000, 50, false)});
}

}  // namespace

TEST_CASE("a region's size: its edges, and its islands without its holes") {
  const host::LayerSize size = host::size_of(region_of_two());
  CHECK_EQ(size.edges, 12);
  CHECK_EQ(size.islands, 2);
}

TEST_CASE("a layer that takes long is told with place and size while it is computed, and once") {
  Told told;
  const core::Region region = region_of_two();
  double spent_s = 0;
  LayerWatch watch(told.teller(), 0.01);
  {
    const LayerWatch::Look look(watch, 6, Length::from_mm(1.4), &region, spent_s);
    REQUIRE(told.wait_for(1));  // and the layer is not done
  }
  CHECK_GT(spent_s, 0.01);
  double again_s = 0;
  {
    // Another stage of the same layer.
    const LayerWatch::Look look(watch, 6, Length::from_mm(1.4), {}, again_s);
    const LayerWatch::Look other(watch, 7, Length::from_mm(1.6), {}, spent_s);
    REQUIRE(told.wait_for(2));
  }
  const std::vector<SlowLayer> layers = told.layers();
  REQUIRE_EQ(layers.size(), 2);
  CHECK_EQ(layers[0].layer, 6);
  CHECK_EQ(layers[0].height, Length::from_mm(1.4));
  CHECK_EQ(layers[0].size.edges, 12);
  CHECK_EQ(layers[0].size.islands, 2);
  CHECK_GT(layers[0].seconds, 0.01);
  CHECK_EQ(layers[1].layer, 7);
  CHECK_EQ(watch.slow_layers().count, 2);
  const std::string text = host::slow_layer_text(layers[0]);
  CAPTURE(text);
  CHECK_EQ(text.rfind("layer 7, at 1.4 mm (12 edges, 2 islands): ", 0), 0);
}

TEST_CASE("many slow layers: the first ones are told, all are counted") {
  Told told;
  LayerWatch watch(told.teller(), 0);
  constexpr std::size_t kLayers = host::kSlowLayersTold + 4;
  std::vector<double> spent_s(kLayers, 1);
  {
    std::vector<std::unique_ptr<LayerWatch::Look>> looks;
    for (std::size_t i = 0; i < kLayers; ++i) {
      looks.push_back(std::make_unique<LayerWatch::Look>(
          watch, static_cast<core::LayerIndex>(i), Length(), host::LayerSize{1, 1}, spent_s[i]));
    }
    REQUIRE(told.wait_for(host::kSlowLayersTold));
    while (watch.slow_layers().count < static_cast<std::int64_t>(kLayers)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  CHECK_EQ(told.layers().size(), host::kSlowLayersTold);
  CHECK_EQ(watch.slow_layers().first.size(), host::kSlowLayersTold);
  CHECK_GT(watch.slow_layers().slowest.seconds, 1);
}

TEST_CASE("quick layers are not told") {
  Told told;
  double spent_s = 0;
  {
    LayerWatch watch(told.teller());
    for (int i = 0; i < 1'000; ++i) {
      const LayerWatch::Look look(watch, i, Length(), host::LayerSize{}, spent_s);
      spent_s = 0;
    }
    CHECK_EQ(watch.slow_layers().count, 0);
  }
  CHECK(told.layers().empty());
}
