#include "host/pipeline/ordered_stages.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/units.h"

using host::LayerBatch;
using host::OrderedStages;

namespace {

// So that stages that may overtake one another do.
void linger(unsigned seed) {
  std::mt19937 random(seed);
  std::this_thread::sleep_for(std::chrono::microseconds(random() % 300));
}

core::LayerIndex number_of(const LayerBatch& batch) { return batch.slice->index; }

std::unique_ptr<LayerBatch> batch_of(core::LayerIndex number) {
  auto batch = std::make_unique<LayerBatch>();
  batch->slice.emplace();
  batch->slice->index = number;
  return batch;
}

}  // namespace

TEST_CASE("every batch passes all stages, in order where it matters, for any number of threads") {
  constexpr core::LayerIndex kBatches = 200;
  for (const int threads : {1, 2, 3, 8, 16}) {
    CAPTURE(threads);
    core::LayerIndex taken = 0;
    std::atomic<int> under_way = 0, most_under_way = 0;
    std::atomic<int> cuts = 0, plans = 0, orders = 0;
    std::vector<core::LayerIndex> split, seams, given;
    OrderedStages stages;
    stages.take = [&]() -> std::unique_ptr<LayerBatch> {
      if (taken == kBatches) return nullptr;
      most_under_way = std::max<int>(most_under_way, ++under_way);
      return batch_of(taken++);
    };
    stages.cut = [&](LayerBatch& batch) {
      linger(static_cast<unsigned>(number_of(batch))), ++cuts;
    };
    stages.split = [&](LayerBatch& batch) { split.push_back(number_of(batch)); };
    stages.plan = [&](LayerBatch& batch) {
      linger(static_cast<unsigned>(number_of(batch)) + 1'000), ++plans;
    };
    stages.seams = [&](LayerBatch& batch) { seams.push_back(number_of(batch)); };
    stages.order = [&](LayerBatch& batch) {
      linger(static_cast<unsigned>(number_of(batch)) + 2'000), ++orders;
    };
    stages.give = [&](LayerBatch& batch) { given.push_back(number_of(batch)), --under_way; };
    host::run_stages(stages, threads);
    CHECK_EQ(cuts, kBatches);
    CHECK_EQ(plans, kBatches);
    CHECK_EQ(orders, kBatches);
    REQUIRE_EQ(split.size(), kBatches);
    REQUIRE_EQ(seams.size(), kBatches);
    REQUIRE_EQ(given.size(), kBatches);
    for (core::LayerIndex i = 0; i < kBatches; ++i) {
      CHECK_EQ(split[static_cast<std::size_t>(i)], i);
      CHECK_EQ(seams[static_cast<std::size_t>(i)], i);
      CHECK_EQ(given[static_cast<std::size_t>(i)], i);
    }
    CHECK_LE(most_under_way, host::batches_max(threads));
  }
}

TEST_CASE("an exception of any stage comes out, when all have stopped") {
  for (const int threads : {1, 3}) {
    for (int stage = 0; stage < 7; ++stage) {
      CAPTURE(threads);
      CAPTURE(stage);
      core::LayerIndex taken = 0;
      const auto work = [&](int at) {
        return [=](LayerBatch& batch) {
          if (at == stage && number_of(batch) == 20) throw std::runtime_error("no");
        };
      };
      OrderedStages stages;
      stages.take = [&]() -> std::unique_ptr<LayerBatch> {
        if (stage == 0 && taken == 20) throw std::runtime_error("no");
        return taken == 1'000 ? nullptr : batch_of(taken++);
      };
      stages.cut = work(1), stages.split = work(2), stages.plan = work(3);
      stages.seams = work(4), stages.order = work(5), stages.give = work(6);
      CHECK_THROWS_AS(host::run_stages(stages, threads), std::runtime_error);
      CHECK_LE(taken, 21 + host::batches_max(threads));
    }
  }
}
