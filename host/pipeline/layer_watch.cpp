#include "host/pipeline/layer_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "host/system/stage_clock.h"  // steady_seconds

namespace host {
namespace {

// A check that is later than this: the program was stopped meanwhile.
constexpr double kStoppedAfter_s = 2;

}  // namespace

void SlowLayers::add(const SlowLayers& more) {
  count += more.count;
  if (more.slowest.seconds > slowest.seconds) slowest = more.slowest;
  const std::size_t room = kSlowLayersTold - std::min(first.size(), std::size_t{kSlowLayersTold});
  const auto taken = static_cast<std::ptrdiff_t>(std::min(room, more.first.size()));
  first.insert(first.end(), more.first.begin(), more.first.begin() + taken);
}

std::optional<std::string> slow_layers_text(const SlowLayers& slow, double limit_s) {
  if (slow.count <= static_cast<std::int64_t>(kSlowLayersTold)) return {};
  return fmt::format(
      "{} layers took more than {:g} s each to compute; the slowest, layer {}, took {:.1f} s",
      slow.count, limit_s, slow.slowest.layer + 1, slow.slowest.seconds);
}

LayerSize size_of(const core::Region& region) {
  LayerSize size;
  for (const core::Ring& ring : region.rings()) {
    size.edges += static_cast<std::int64_t>(ring.size());
    size.islands += core::doubled_area_units(ring) > 0 ? 1 : 0;
  }
  return size;
}

std::string slow_layer_text(const SlowLayer& layer) {
  const std::string size = layer.size.edges > 0 ? fmt::format(" ({} edges, {} islands)",
                                                              layer.size.edges, layer.size.islands)
                                                : "";
  return fmt::format("layer {}, at {:g} mm{}: computing it takes long, {:.1f} s so far",
                     layer.layer + 1, layer.height.mm(), size, layer.seconds);
}

// A pthread, because a std::thread has a stack of 8 MB, which counts against memory limits.
LayerWatch::LayerWatch(Tell tell, double limit_s) : tell_(std::move(tell)), limit_s_(limit_s) {
  pthread_attr_t attributes;
  if (::pthread_attr_init(&attributes) != 0) return;
  const auto watch = [](void* self) -> void* {
    static_cast<LayerWatch*>(self)->run();
    return nullptr;
  };
  watches_ = ::pthread_attr_setstacksize(&attributes, kWatchStackBytes) == 0 &&
             ::pthread_create(&thread_, &attributes, watch, this) == 0;
  ::pthread_attr_destroy(&attributes);
}

LayerWatch::~LayerWatch() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  ended_changed_.notify_all();
  if (watches_) ::pthread_join(thread_, nullptr);
}

LayerWatch::Look::Look(LayerWatch& watch, core::LayerIndex layer, core::Length height,
                       const core::Region* region, double& spent_s)
    : watch_(watch), layer_{layer, height, {}, 0}, region_(region), spent_s_(spent_s), start_s_(0) {
  watch_.enter(*this);
}

LayerWatch::Look::Look(LayerWatch& watch, core::LayerIndex layer, core::Length height,
                       LayerSize size, double& spent_s)
    : watch_(watch),
      layer_{layer, height, size, 0},
      region_(nullptr),
      spent_s_(spent_s),
      start_s_(0) {
  watch_.enter(*this);
}

LayerWatch::Look::~Look() { watch_.leave(*this); }

SlowLayers LayerWatch::slow_layers() const {
  const std::lock_guard lock(mutex_);
  return slow_;
}

double LayerWatch::running_s() const { return steady_seconds() - stopped_s_; }

void LayerWatch::enter(Look& look) {
  const std::lock_guard lock(mutex_);
  look.start_s_ = running_s();
  looks_.push_back(&look);
}

void LayerWatch::leave(Look& look) {
  const std::lock_guard lock(mutex_);
  looks_.erase(std::find(looks_.begin(), looks_.end(), &look));
  look.spent_s_ += running_s() - look.start_s_;
  if (!look.over_) return;
  const core::LayerIndex layer = look.layer_.layer;
  const auto same = [layer](const SlowLayer& each) { return each.layer == layer; };
  const auto told = std::find_if(slow_.first.begin(), slow_.first.end(), same);
  if (told != slow_.first.end()) told->seconds = std::max(told->seconds, look.spent_s_);
  if (look.spent_s_ <= slow_.slowest.seconds) return;
  slow_.slowest = look.layer_;
  slow_.slowest.seconds = look.spent_s_;
}

// Returns whether to report the layer. REQUIRES: the lock is held.
bool LayerWatch::note(Look& look) {
  const double seconds = look.spent_s_ + running_s() - look.start_s_;
  if (look.over_ || seconds <= limit_s_) return false;
  look.over_ = true;
  look.layer_.seconds = seconds;
  if (look.region_ != nullptr) look.layer_.size = size_of(*look.region_);
  if (std::find(known_.begin(), known_.end(), look.layer_.layer) != known_.end()) return false;
  known_.push_back(look.layer_.layer);
  if (known_.size() > kSlowLayersKnown) known_.pop_front();
  if (++slow_.count > static_cast<std::int64_t>(kSlowLayersTold)) return false;
  slow_.first.push_back(look.layer_);
  return true;
}

void LayerWatch::run() {
  std::unique_lock lock(mutex_);
  double looked_s = steady_seconds();
  while (!ended_) {
    ended_changed_.wait_for(lock, std::chrono::duration<double>(kWatchPeriod_s));
    const double now_s = steady_seconds();
    if (now_s - looked_s > kStoppedAfter_s) stopped_s_ += now_s - looked_s - kWatchPeriod_s;
    looked_s = now_s;
    std::vector<SlowLayer> to_tell;
    try {
      for (Look* look : looks_) {
        if (note(*look)) to_tell.push_back(look->layer_);
      }
    } catch (const std::exception&) {
      // No memory to note it.
    }
    if (!tell_ || to_tell.empty()) continue;
    lock.unlock();
    for (const SlowLayer& layer : to_tell) tell(layer);
    lock.lock();
  }
}

// Reports nothing if there is no memory for it.
void LayerWatch::tell(const SlowLayer& layer) const {
  try {
    tell_(layer);
  } catch (const std::exception&) {
  }
}

}  // namespace host
