// Why a part's pipeline ends before its last layer.
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "core/result.h"  // Error

namespace host {

class RunEnd {
 public:
  // `refused`: set once an output wants no more. `stop_asked` may be empty. Both outlive it.
  RunEnd(std::atomic<bool>& refused, const std::function<bool()>& stop_asked)
      : refused_(refused), stop_asked_(stop_asked) {}

  void fail(const core::Error& error) {
    error_ = error;
    refused_ = true;
  }
  // What an output has answered.
  void keep(bool go_on) {
    if (!go_on) refused_ = true;
  }
  // Nobody wants the rest of the object.
  void cancel() { cancelled_ = true; }

  // For all threads.
  [[nodiscard]] bool stopped() const {
    return refused_ || cancelled_ || (stop_asked_ && stop_asked_());
  }

  // Once all threads are done.
  [[nodiscard]] const std::optional<core::Error>& error() const { return error_; }
  [[nodiscard]] bool only_cancelled() const { return cancelled_ && !refused_; }

 private:
  std::atomic<bool>& refused_;
  const std::function<bool()>& stop_asked_;
  std::atomic<bool> cancelled_ = false;
  std::optional<core::Error> error_;
};

}  // namespace host
