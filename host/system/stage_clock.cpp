#include "host/system/stage_clock.h"

#include <time.h>

#include <algorithm>

namespace host {
namespace {

double read_clock(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

}  // namespace

double thread_cpu_seconds() { return read_clock(CLOCK_THREAD_CPUTIME_ID); }
double process_cpu_seconds() { return read_clock(CLOCK_PROCESS_CPUTIME_ID); }
double steady_seconds() { return read_clock(CLOCK_MONOTONIC); }

std::string_view stage_name(Stage stage) {
  switch (stage) {
    case Stage::kNone:
      return "other";
    case Stage::kRead:
      return "read";
    case Stage::kSort:
      return "sort";
    case Stage::kSlice:
      return "slice";
    case Stage::kSupport:
      return "support";
    case Stage::kOffset:
      return "offset";
    case Stage::kWindow:
      return "window";
    case Stage::kRoads:
      return "roads";
    case Stage::kSeams:
      return "seams";
    case Stage::kLay:
      return "lay";
    case Stage::kEncode:
      return "encode";
    case Stage::kSend:
      return "send";
    case Stage::kOpen:
      return "open";
    case Stage::kFinish:
      return "finish";
  }
  return "other";
}

StageClock::StageClock() : since_(thread_cpu_seconds()) {}

void StageClock::enter(Stage stage) {
  const double now = thread_cpu_seconds();
  layer_[index(stage_)] += now - since_;
  total_[index(stage_)] += now - since_;
  since_ = now;
  stage_ = stage;
}

void StageClock::end_layer() {
  enter(stage_);
  for (std::size_t i = 0; i < kStageCount; ++i) worst_[i] = std::max(worst_[i], layer_[i]);
  layer_.fill(0);
}

double StageClock::add_layer(const StageSeconds& seconds) {
  double sum_s = 0;
  for (std::size_t i = 0; i < kStageCount; ++i) {
    total_[i] += seconds[i];
    worst_[i] = std::max(worst_[i], seconds[i]);
    sum_s += seconds[i];
  }
  return sum_s;
}

void StageClock::merge(const StageClock& other) {
  for (std::size_t i = 0; i < kStageCount; ++i) {
    total_[i] += other.total_[i];
    worst_[i] = std::max(worst_[i], other.worst_[i]);
  }
}

}  // namespace host
