// Reports layers that take long to compute, while they are being computed, so that users see why
// nothing moves. A thread of its own checks what the stages are working on.
//
//     stage ── Look(layer) ───── computes ───── gone      a Look exists while a stage works
//                     └── the thread checks every kWatchPeriod_s; over the limit: report
//
// The thread needs kWatchStackBytes; without that memory, layers are not watched.
//
// Time in which the program was stopped (SIGSTOP) does not count.
#pragma once

#include <pthread.h>

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/regions/region.h"  // Region
#include "core/units.h"           // LayerIndex, Length
#include "host/system/limits.h"   // kSlowLayersTold, kSlowLayersKnown

namespace host {

inline constexpr double kSlowLayer_s = 2;
inline constexpr double kWatchPeriod_s = 0.2;
inline constexpr std::size_t kWatchStackBytes = std::size_t{256} * 1'024;

struct LayerSize {
  std::int64_t edges = 0;
  std::int64_t islands = 0;
};
// COSTS: O(points).
[[nodiscard]] LayerSize size_of(const core::Region& region);

struct SlowLayer {
  core::LayerIndex layer = 0;  // counted from 0
  core::Length height;         // of its top
  LayerSize size;              // 0 if not known yet
  double seconds = 0;          // so far
};

// "layer 12, at 2.4 mm (48000 edges, 1200 islands): computing it takes long, 2.1 s so far"
[[nodiscard]] std::string slow_layer_text(const SlowLayer& layer);

// The slow layers of a run.
struct SlowLayers {
  std::int64_t count = 0;
  std::vector<SlowLayer> first;  // the first kSlowLayersTold, with their whole time
  SlowLayer slowest;

  // Those of a later part.
  void add(const SlowLayers& more);
};

// "20 layers took more than 60 s each …"; nothing where each was told.
[[nodiscard]] std::optional<std::string> slow_layers_text(const SlowLayers& slow, double limit_s);

class LayerWatch {
 public:
  using Tell = std::function<void(const SlowLayer&)>;

  // `tell`: called by the thread, once for each of the first kSlowLayersTold layers; may be empty.
  explicit LayerWatch(Tell tell, double limit_s = kSlowLayer_s);
  ~LayerWatch();
  LayerWatch(const LayerWatch&) = delete;
  LayerWatch& operator=(const LayerWatch&) = delete;

  // While it exists, the calling thread computes that layer. `spent_s`: time that earlier stages
  // took for the layer; this stage's time is added.
  class Look {
   public:
    Look(LayerWatch& watch, core::LayerIndex layer, core::Length height, const core::Region* region,
         double& spent_s);
    Look(LayerWatch& watch, core::LayerIndex layer, core::Length height, LayerSize size,
         double& spent_s);
    ~Look();
    Look(const Look&) = delete;
    Look& operator=(const Look&) = delete;

   private:
    friend class LayerWatch;
    LayerWatch& watch_;
    SlowLayer layer_;
    const core::Region* region_;  // null if its size is known
    double& spent_s_;
    double start_s_;
    bool over_ = false;  // the limit
  };

  // So far.
  [[nodiscard]] SlowLayers slow_layers() const;

 private:
  void enter(Look& look);
  void leave(Look& look);
  void run();
  [[nodiscard]] double running_s() const;
  [[nodiscard]] bool note(Look& look);
  void tell(const SlowLayer& layer) const;

  const Tell tell_;
  const double limit_s_;
  mutable std::mutex mutex_;  // for all below
  std::condition_variable ended_changed_;
  bool ended_ = false;
  double stopped_s_ = 0;  // time in which the program did not run
  std::vector<Look*> looks_;
  SlowLayers slow_;
  std::deque<core::LayerIndex> known_;  // the latest kSlowLayersKnown slow layers
  pthread_t thread_{};
  bool watches_ = false;  // false: there was no memory for the thread
};

}  // namespace host
