// Measures what a layer costs in a stage: processor time, allocations and boolean retries of the
// thread that does the work.
#pragma once

#include <array>
#include <cstdint>

#include "core/booleans/boolean.h"      // boolean_retries
#include "host/system/memory_budget.h"  // thread_allocations
#include "host/system/stage_clock.h"    // Stage, StageSeconds, CpuTimer

namespace host {

// By Stage.
using StageCounts = std::array<std::int64_t, kStageCount>;

struct StageUse {
  StageSeconds seconds{};
  StageCounts allocations{};
  std::int64_t boolean_retries = 0;
};

// Adds what the calling thread uses during the meter's lifetime to `use`.
class StageMeter {
 public:
  StageMeter(Stage stage, StageUse& use)
      : timer_(seconds_of(stage, use.seconds)),
        use_(use),
        allocations_(use.allocations[static_cast<std::size_t>(stage)]) {
    allocations_ -= thread_allocations();
    use_.boolean_retries -= core::boolean_retries();
  }
  ~StageMeter() {
    allocations_ += thread_allocations();
    use_.boolean_retries += core::boolean_retries();
  }
  StageMeter(const StageMeter&) = delete;
  StageMeter& operator=(const StageMeter&) = delete;

 private:
  CpuTimer timer_;
  StageUse& use_;
  std::int64_t& allocations_;
};

}  // namespace host
