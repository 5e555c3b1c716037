// Why to pause before layers that are still in the window.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "core/units.h"  // LayerIndex

namespace host {

class PausesAhead {
 public:
  // REQUIRES: indices ascend.
  void put(core::LayerIndex index, std::string reason) {
    pauses_.emplace_back(index, std::move(reason));
  }

  // The layer's reason, if it has one. Those below it are forgotten.
  [[nodiscard]] std::optional<std::string> take(core::LayerIndex index) {
    std::optional<std::string> reason;
    while (!pauses_.empty() && pauses_.front().first <= index) {
      if (pauses_.front().first == index) reason = std::move(pauses_.front().second);
      pauses_.pop_front();
    }
    return reason;
  }

 private:
  std::deque<std::pair<core::LayerIndex, std::string>> pauses_;
};

}  // namespace host
