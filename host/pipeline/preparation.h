// How far the passes over the whole part are that come before its first layer.
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

#include "core/units.h"  // LayerIndex

namespace host {

struct Preparation {
  std::string_view step;              // what is done; a literal
  core::LayerIndex done = 0;          // layers of this step
  core::LayerIndex layers = 0;        // of the part; 0: not known
  std::string_view counts = "layer";  // what `done` and `layers` count
};

// Passes it from the thread of the geometry to that which shows it.
class PreparationBox {
 public:
  // Called by put(), on each layer.
  void on_put(std::function<void(const Preparation&)> call) { call_ = std::move(call); }

  void put(const Preparation& latest) {
    {
      const std::lock_guard lock(mutex_);
      latest_ = latest;
    }
    if (call_) call_(latest);
  }
  // Nothing is prepared any more.
  void clear() {
    const std::lock_guard lock(mutex_);
    latest_.reset();
  }
  // nullopt: nothing is being prepared.
  [[nodiscard]] std::optional<Preparation> get() const {
    const std::lock_guard lock(mutex_);
    return latest_;
  }

 private:
  std::function<void(const Preparation&)> call_;
  mutable std::mutex mutex_;  // protects what follows
  std::optional<Preparation> latest_;
};

}  // namespace host
