// Where the processor's time goes: seconds by stage, and each stage's worst layer.
//
// A thread is in one stage at a time; enter() gives the time since the last switch to the stage
// that is left. Only the calling thread's own processor time counts, so that waiting for the
// printer or for another program doesn't look like work.
//
// COSTS: enter() and end_layer() one system call each; nothing grows with the number of layers.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace host {

enum class Stage { kNone, kRead, kSort, kSlice, kOffset, kWindow, kRoads, kEncode, kSend };
inline constexpr std::size_t kStageCount = 9;

// As in the statistics file.
[[nodiscard]] std::string_view stage_name(Stage stage);

// Processor time by Stage.
using StageSeconds = std::array<double, kStageCount>;

[[nodiscard]] inline double& seconds_of(Stage stage, StageSeconds& seconds) {
  return seconds[static_cast<std::size_t>(stage)];
}

class StageClock {
 public:
  // REQUIRES: all calls come from one thread, the one that made the clock.
  StageClock();

  void enter(Stage stage);

  // What was spent since the last call counts as one layer's.
  void end_layer();

  // One layer's, measured elsewhere. Returns the sum, in seconds.
  double add_layer(const StageSeconds& seconds);

  // The stage's total as it is known from elsewhere, more finely than by enter().
  void set_seconds(Stage stage, double seconds) { total_[index(stage)] = seconds; }

  [[nodiscard]] double seconds(Stage stage) const { return total_[index(stage)]; }
  [[nodiscard]] double worst_layer_ms(Stage stage) const { return worst_[index(stage)] * 1e3; }

  // Sums and worst cases of both, for two threads that have ended.
  void merge(const StageClock& other);

 private:
  static std::size_t index(Stage stage) { return static_cast<std::size_t>(stage); }

  Stage stage_ = Stage::kNone;
  double since_;
  StageSeconds total_{};
  StageSeconds layer_{};
  StageSeconds worst_{};
};

// Processor time of the calling thread, of the whole program; time that never goes back.
[[nodiscard]] double thread_cpu_seconds();
[[nodiscard]] double process_cpu_seconds();
[[nodiscard]] double steady_seconds();

// Adds the calling thread's processor time during its own life.
class CpuTimer {
 public:
  explicit CpuTimer(double& seconds) : seconds_(seconds), begin_s_(thread_cpu_seconds()) {}
  ~CpuTimer() { seconds_ += thread_cpu_seconds() - begin_s_; }
  CpuTimer(const CpuTimer&) = delete;
  CpuTimer& operator=(const CpuTimer&) = delete;

 private:
  double& seconds_;
  double begin_s_;
};

}  // namespace host
