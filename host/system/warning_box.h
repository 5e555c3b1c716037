// Passes warnings from one thread to the thread that shows messages.
#pragma once

#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "host/system/limits.h"  // kWarningsHeldMax

namespace host {

class WarningBox {
 public:
  // Keeps kWarningsHeldMax warnings; further ones are only counted ("and 3 more").
  void put(std::string warning) {
    const std::lock_guard lock(mutex_);
    if (warnings_.size() < kWarningsHeldMax) {
      warnings_.push_back(std::move(warning));
    } else {
      ++left_out_;
    }
  }

  // All warnings since the last call.
  [[nodiscard]] std::vector<std::string> take() {
    const std::lock_guard lock(mutex_);
    if (left_out_ > 0) warnings_.push_back("and " + std::to_string(left_out_) + " more");
    left_out_ = 0;
    return std::exchange(warnings_, {});
  }

 private:
  std::mutex mutex_;  // protects all below
  std::vector<std::string> warnings_;
  std::size_t left_out_ = 0;
};

}  // namespace host
