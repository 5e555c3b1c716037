// Runs the layers' work through seven stages, on one processor or more.
//
//     take ──> cut ══> split ──> plan ══> seams ──> order ══> give
//
//     ──> in order, one at a time       ══> any number at once
//
// `order` also prepares how the roads are laid (laid_roads.h), `give` makes motions and commands.
//
// The results and their order are the same for any number of threads. A thread that has nothing to
// do sleeps. With one thread, a plain loop.
#pragma once

#include <functional>
#include <memory>

#include "host/pipeline/layer_batch.h"  // LayerBatch
#include "host/system/limits.h"         // kBatchesAhead

namespace host {

struct OrderedStages {
  std::function<std::unique_ptr<LayerBatch>()> take;  // returns null at the end
  std::function<void(LayerBatch&)> cut;
  std::function<void(LayerBatch&)> split;
  std::function<void(LayerBatch&)> plan;
  std::function<void(LayerBatch&)> seams;
  std::function<void(LayerBatch&)> order;
  std::function<void(LayerBatch&)> give;
};

// Largest number of batches between take and give.
[[nodiscard]] constexpr int batches_max(int threads) {
  return threads == 1 ? 1 : threads + kBatchesAhead;
}

// Returns when the last batch has been given. Rethrows an exception of any stage after all stages
// have stopped. REQUIRES: threads >= 1.
void run_stages(const OrderedStages& stages, int threads);

}  // namespace host
