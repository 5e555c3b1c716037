// Tells of layers that take long to compute while they are still being computed, so that nobody has
// to guess why nothing moves: a thread of its own looks at what the stages are at.
//
//     stage ── look(layer) ───── computes ───── gone         a Look lives as long as a stage works
//                     └── the watch looks every kWatchPeriod_s; over the limit: tell
//
// It needs some memory (kWatchStackBytes); where there is none, layers are not watched.
//
// Time counts while the program runs; when it was stopped (SIGSTOP) nothing was computed.
#pragma once

#include <pthread.h>

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
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
  LayerSize size;              // 0: not known yet
  double seconds = 0;          // so far
};

// "layer 12 at 2.4 mm (48000 edges, 1200 islands): has been computed for 2.1 s, and still is"
[[nodiscard]] std::string slow_layer_text(const SlowLayer& layer);

// What a run met.
struct SlowLayers {
  std::int64_t count = 0;
  std::vector<SlowLayer> first;  // kSlowLayersTold of them, with all their seconds
  SlowLayer slowest;
};

class LayerWatch {
 public:
  using Tell = std::function<void(const SlowLayer&)>;

  // `tell`: called by the watch's thread, for the first kSlowLayersTold layers, once each; may be
  // empty.
  explicit LayerWatch(Tell tell, double limit_s = kSlowLayer_s);
  ~LayerWatch();
  LayerWatch(const LayerWatch&) = delete;
  LayerWatch& operator=(const LayerWatch&) = delete;

  // While it lives, its thread computes that layer. `spent_s` is what earlier stages took of the
  // same work, and is added to.
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
    const core::Region* region_;  // null: its size is known
    double& spent_s_;
    double begin_s_;
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
  double stopped_s_ = 0;  // the program did not run so long
  std::vector<Look*> looks_;
  SlowLayers slow_;
  std::deque<core::LayerIndex> known_;  // slow ones, the latest kSlowLayersKnown
  pthread_t thread_{};
  bool watches_ = false;  // without memory for the thread nobody is told
};

}  // namespace host
