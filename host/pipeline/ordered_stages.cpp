#include "host/pipeline/ordered_stages.h"

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <utility>

#include "core/check.h"  // RIND_CHECK

namespace host {
namespace {

void run_in_turn(const OrderedStages& stages) {
  while (const std::unique_ptr<LayerBatch> batch = stages.take()) {
    stages.cut(*batch);
    stages.split(*batch);
    stages.plan(*batch);
    stages.give(*batch);
  }
}

// TBB copies values between stages: a shared pointer, so that nothing leaks on an exception.
using Shared = std::shared_ptr<LayerBatch>;

auto stage(tbb::filter_mode mode, const std::function<void(LayerBatch&)>& work) {
  return tbb::make_filter<Shared, Shared>(mode, [&work](Shared batch) {
    work(*batch);
    return batch;
  });
}

void run_at_once(const OrderedStages& stages, int threads) {
  const auto take = [&stages](tbb::flow_control& control) -> Shared {
    Shared batch = stages.take();
    if (!batch) control.stop();
    return batch;
  };
  const auto give = [&stages](const Shared& batch) { stages.give(*batch); };
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_pipeline(
        static_cast<std::size_t>(batches_max(threads)),
        tbb::make_filter<void, Shared>(tbb::filter_mode::serial_in_order, take) &
            stage(tbb::filter_mode::parallel, stages.cut) &
            stage(tbb::filter_mode::serial_in_order, stages.split) &
            stage(tbb::filter_mode::parallel, stages.plan) &
            tbb::make_filter<Shared, void>(tbb::filter_mode::serial_in_order, give));
  });
}

}  // namespace

void run_stages(const OrderedStages& stages, int threads) {
  RIND_CHECK(threads >= 1);
  if (threads == 1) {
    run_in_turn(stages);
  } else {
    run_at_once(stages, threads);
  }
}

}  // namespace host
