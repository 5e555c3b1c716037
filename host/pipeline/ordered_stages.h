// Sends one layer's work after another through five stages, on one processor or more.
//
//     take ──> cut ══> split ──> plan ══> give       ──> in order, one at a time
//                                                    ══> any number at once
//
// What comes out, and in which order, is the same for any number of jobs. (oneTBB's
// parallel_pipeline; with one job a plain loop.)
#pragma once

#include <functional>
#include <memory>

#include "host/pipeline/layer_batch.h"  // LayerBatch
#include "host/system/limits.h"         // kBatchesAhead

namespace host {

struct OrderedStages {
  std::function<std::unique_ptr<LayerBatch>()> take;  // null: there is nothing more
  std::function<void(LayerBatch&)> cut;
  std::function<void(LayerBatch&)> split;
  std::function<void(LayerBatch&)> plan;
  std::function<void(LayerBatch&)> give;
};

// Batches between take and give, at most.
[[nodiscard]] constexpr int batches_max(int jobs) { return jobs == 1 ? 1 : jobs + kBatchesAhead; }

// Returns when the last batch was given. An exception of any stage comes out here, when no stage
// runs any more. REQUIRES: jobs >= 1.
void run_stages(const OrderedStages& stages, int jobs);

}  // namespace host
