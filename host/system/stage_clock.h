// Processor time by stage, in total and for each stage's worst layer.
//
// A thread is in one stage at a time. enter() adds the time since the last call to the stage that
// ends. Only the calling thread's processor time counts: waiting for the printer or for another
// program is not counted as work.
//
// COSTS: enter() and end_layer() one system call each; nothing grows with the number of layers.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace host {

enum class Stage {
  kNone,
  kRead,
  kSort,
  kSlice,
  kSupport,
  kOffset,
  kWindow,
  kRoads,
  kSeams,
  kLay,
  kEncode,
  kSend,
  kOpen,   // the program's start, and the file up to the first triangle that is asked for
  kFinish  // after the last layer
};
inline constexpr std::size_t kStageCount = 14;

// As in the statistics file (--stats).
[[nodiscard]] std::string_view stage_name(Stage stage);

// Processor time by Stage.
using StageSeconds = std::array<double, kStageCount>;

[[nodiscard]] inline double& seconds_of(Stage stage, StageSeconds& seconds) {
  return seconds[static_cast<std::size_t>(stage)];
}

class StageClock {
 public:
  // REQUIRES: all calls come from the thread that made the clock.
  StageClock();

  void enter(Stage stage);

  // Ends a layer: the time since the last call is that layer's.
  void end_layer();

  // Adds a layer's times that were measured elsewhere. Returns their sum, in seconds.
  double add_layer(const StageSeconds& seconds);

  // Replaces the stage's total by one that was measured elsewhere, more finely than by enter().
  void set_seconds(Stage stage, double seconds) { total_[index(stage)] = seconds; }

  void set_worst_layer(Stage stage, double seconds) { worst_[index(stage)] = seconds; }

  [[nodiscard]] double seconds(Stage stage) const { return total_[index(stage)]; }
  [[nodiscard]] double worst_layer_ms(Stage stage) const { return worst_[index(stage)] * 1e3; }

  // Adds another thread's totals and takes the worse layer of both. For threads that have ended.
  void merge(const StageClock& other);

 private:
  static std::size_t index(Stage stage) { return static_cast<std::size_t>(stage); }

  Stage stage_ = Stage::kNone;
  double since_;
  StageSeconds total_{};
  StageSeconds layer_{};
  StageSeconds worst_{};
};

// Processor time of the calling thread and of the whole program; monotonic time.
[[nodiscard]] double thread_cpu_seconds();
[[nodiscard]] double process_cpu_seconds();
[[nodiscard]] double steady_seconds();

// Adds the calling thread's processor time over the timer's lifetime to `seconds`.
class CpuTimer {
 public:
  explicit CpuTimer(double& seconds) : seconds_(seconds), start_s_(thread_cpu_seconds()) {}
  ~CpuTimer() { seconds_ += thread_cpu_seconds() - start_s_; }
  CpuTimer(const CpuTimer&) = delete;
  CpuTimer& operator=(const CpuTimer&) = delete;

 private:
  double& seconds_;
  double start_s_;
};

}  // namespace host
