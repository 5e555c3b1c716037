#include "host/pipeline/ordered_stages.h"

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <mutex>
#include <utility>
#include <vector>

#include "core/check.h"  // RIND_CHECK

namespace host {
namespace {

void run_in_turn(const OrderedStages& stages) {
  while (const std::unique_ptr<LayerBatch> batch = stages.take()) {
    stages.cut(*batch);
    stages.split(*batch);
    stages.plan(*batch);
    stages.seams(*batch);
    stages.order(*batch);
    stages.give(*batch);
  }
}

// TBB hands batches from thread to thread. The thread sanitizer does not see into TBB: there, it
// is shown each hand-over by a lock, before and after the work, also when that throws.
class HandOver {
 public:
  HandOver() { show(); }
  ~HandOver() { show(); }
  HandOver(const HandOver&) = delete;
  HandOver& operator=(const HandOver&) = delete;

 private:
  static void show() {
#ifdef RIND_THREAD_SANITIZER
    static std::mutex shown;
    const std::lock_guard lock(shown);
#endif
  }
};

using Work = std::function<void(LayerBatch&)>;

void work_on(LayerBatch& batch, const Work& work) {
  const HandOver hand_over;
  work(batch);
}

// The batches under way. TBB carries plain pointers to them: what it holds between two stages when
// one throws, it forgets. A place is free again when its batch has been given, which goes in order.
class BatchPlaces {
 public:
  explicit BatchPlaces(int places) : places_(static_cast<std::size_t>(places)) {}

  // Null at the end.
  LayerBatch* put(std::unique_ptr<LayerBatch> batch) {
    std::unique_ptr<LayerBatch>& place = places_[next_++ % places_.size()];
    place = std::move(batch);
    return place.get();
  }

 private:
  std::vector<std::unique_ptr<LayerBatch>> places_;
  std::size_t next_ = 0;
};

auto stage(tbb::filter_mode mode, const Work& work) {
  return tbb::make_filter<LayerBatch*, LayerBatch*>(mode, [&work](LayerBatch* batch) {
    work_on(*batch, work);
    return batch;
  });
}

void run_at_once(const OrderedStages& stages, int threads) {
  BatchPlaces places(batches_max(threads));
  const auto take = [&](tbb::flow_control& control) {
    const HandOver hand_over;
    LayerBatch* batch = places.put(stages.take());
    if (batch == nullptr) control.stop();
    return batch;
  };
  const auto give = [&stages](LayerBatch* batch) { work_on(*batch, stages.give); };
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  const HandOver hand_over;
  arena.execute([&] {
    tbb::parallel_pipeline(
        static_cast<std::size_t>(batches_max(threads)),
        tbb::make_filter<void, LayerBatch*>(tbb::filter_mode::serial_in_order, take) &
            stage(tbb::filter_mode::parallel, stages.cut) &
            stage(tbb::filter_mode::serial_in_order, stages.split) &
            stage(tbb::filter_mode::parallel, stages.plan) &
            stage(tbb::filter_mode::serial_in_order, stages.seams) &
            stage(tbb::filter_mode::parallel, stages.order) &
            tbb::make_filter<LayerBatch*, void>(tbb::filter_mode::serial_in_order, give));
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
