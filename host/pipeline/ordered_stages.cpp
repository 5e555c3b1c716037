#include "host/pipeline/ordered_stages.h"

#include <array>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "core/check.h"  // RIND_CHECK

namespace host {
namespace {

struct Work {
  const std::function<void(LayerBatch&)>& work;
  bool in_order;
};

// Behind take().
constexpr std::size_t kStages = 6;

std::array<Work, kStages> stages_of(const OrderedStages& stages) {
  return {Work{stages.cut, false},  Work{stages.split, true},  Work{stages.plan, false},
          Work{stages.seams, true}, Work{stages.order, false}, Work{stages.give, true}};
}

void run_in_turn(const OrderedStages& stages) {
  while (const std::unique_ptr<LayerBatch> batch = stages.take()) {
    for (const Work& stage : stages_of(stages)) stage.work(*batch);
  }
}

// Each thread goes on with its batch as long as it can, otherwise with the oldest one that is
// ready. A thread that finds nothing sleeps: it never asks again and again.
class StageThreads {
 public:
  StageThreads(const OrderedStages& stages, int threads)
      : take_(stages.take),
        stages_(stages_of(stages)),
        places_(static_cast<std::size_t>(batches_max(threads))) {}

  // The calling thread is one of them. Where the system gives no more threads, fewer do the work.
  void run(int threads) {
    std::vector<std::thread> others;
    others.reserve(static_cast<std::size_t>(threads - 1));
    try {
      for (int i = 1; i < threads; ++i) others.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
    }
    work();
    for (std::thread& each : others) each.join();
    if (error_) std::rethrow_exception(error_);
  }

 private:
  // Where a batch is: before the stage, or in it.
  struct Place {
    std::unique_ptr<LayerBatch> batch;
    std::size_t stage = 0;
    bool in_work = false;
  };

  [[nodiscard]] Place& place_of(std::size_t number) { return places_[number % places_.size()]; }
  [[nodiscard]] bool ended() const { return error_ || (source_ended_ && given_ == taken_); }
  [[nodiscard]] bool takes() const {
    return !source_ended_ && !taking_ && taken_ - given_ < places_.size();
  }

  // Whether a thread may work on the batch of this number.
  [[nodiscard]] bool is_ready(std::size_t number) {
    const Place& place = place_of(number);
    if (number < given_ || number >= taken_ || place.in_work) return false;
    return !stages_[place.stage].in_order || turns_[place.stage] == number;
  }

  // The oldest one.
  [[nodiscard]] std::optional<std::size_t> ready() {
    for (std::size_t number = given_; number < taken_; ++number) {
      if (is_ready(number)) return number;
    }
    return std::nullopt;
  }

  void work() {
    std::unique_lock lock(mutex_);
    std::size_t last = 0;  // that this thread has worked on, and has in its cache
    while (!ended()) {
      const std::optional<std::size_t> next = is_ready(last) ? last : ready();
      if (next) {
        last = *next;
        work_on(last, lock);
      } else if (takes()) {
        take(lock);
      } else {
        ++asleep_;
        changed_.wait(lock);
        --asleep_;
      }
    }
    changed_.notify_all();
  }

  // One thread that sleeps looks for work, if there is some besides what the caller has begun.
  void wake_another() {
    if (asleep_ > 0 && (takes() || ready())) changed_.notify_one();
  }

  void take(std::unique_lock<std::mutex>& lock) {
    taking_ = true;
    wake_another();
    std::unique_ptr<LayerBatch> batch;
    unlocked(lock, [&] { batch = take_(); });
    taking_ = false;
    if (batch == nullptr) {
      source_ended_ = true;
      return;
    }
    place_of(taken_++) = {std::move(batch), 0, false};
  }

  void work_on(std::size_t number, std::unique_lock<std::mutex>& lock) {
    Place& place = place_of(number);
    place.in_work = true;
    wake_another();
    unlocked(lock, [&] { stages_[place.stage].work(*place.batch); });
    place.in_work = false;
    if (stages_[place.stage].in_order) ++turns_[place.stage];
    if (++place.stage < kStages) return;
    // What it holds is freed while the next one is given.
    std::unique_ptr<LayerBatch> given = std::move(place.batch);
    ++given_;
    wake_another();
    unlocked(lock, [&] { given.reset(); });
  }

  // Keeps the first exception.
  template <typename Task>
  void unlocked(std::unique_lock<std::mutex>& lock, const Task& task) {
    std::exception_ptr error;
    lock.unlock();
    try {
      task();
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    if (error && !error_) error_ = error;
  }

  const std::function<std::unique_ptr<LayerBatch>()>& take_;
  const std::array<Work, kStages> stages_;

  std::mutex mutex_;  // for all below, but for the batches that are in work
  std::condition_variable changed_;
  std::vector<Place> places_;
  std::array<std::size_t, kStages> turns_{};  // the number that a stage in order waits for
  std::size_t given_ = 0, taken_ = 0;
  int asleep_ = 0;
  bool taking_ = false, source_ended_ = false;
  std::exception_ptr error_;
};

}  // namespace

void run_stages(const OrderedStages& stages, int threads) {
  RIND_CHECK(threads >= 1);
  if (threads == 1) {
    run_in_turn(stages);
  } else {
    StageThreads(stages, threads).run(threads);
  }
}

}  // namespace host
