// The one queue between the two threads: geometry fills it, the link empties it.
//
//     push ──> [ ▒▒▒▒▒▒▒▒▒ ] ──> try_pop        at most `items` items of at most `bytes` bytes
//
// A full queue makes push() wait: that back-pressure is what keeps geometry from running ahead of
// the printer, and so is the memory bound. Either side can close it at any time.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

#include "core/check.h"

namespace host {

template <typename T>
class BoundedQueue {
 public:
  struct Limits {
    std::size_t items;
    std::size_t bytes;
  };
  struct Level {
    std::size_t items = 0;
    std::size_t bytes = 0;
  };

  // REQUIRES: both limits above 0.
  explicit BoundedQueue(Limits limits) : limits_(limits) {
    RIND_CHECK(limits.items > 0);
    RIND_CHECK(limits.bytes > 0);
  }

  // Waits while the queue is full; false when it was closed, and the item is gone. An item larger
  // than the limit of bytes is taken when the queue is empty, so that nothing waits for ever.
  // REQUIRES: finish() was not called.
  [[nodiscard]] bool push(T item, std::size_t bytes) {
    std::unique_lock lock(mutex_);
    RIND_CHECK(!finished_);
    changed_.wait(lock, [&] { return closed_ || fits(bytes); });
    if (closed_) return false;
    items_.push_back({std::move(item), bytes});
    bytes_ += bytes;
    return true;
  }

  // The oldest item, or nothing when there is none at the moment (see drained()). Never waits:
  // the link has a port to listen to.
  [[nodiscard]] std::optional<T> try_pop() {
    std::optional<T> item;
    {
      const std::lock_guard lock(mutex_);
      if (items_.empty()) return std::nullopt;
      bytes_ -= items_.front().bytes;
      item.emplace(std::move(items_.front().value));
      items_.pop_front();
    }
    changed_.notify_one();
    return item;
  }

  // The filling side says that nothing follows.
  void finish() {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }

  // Either side gives up: what is queued is dropped, and pushing returns false from now on.
  void close() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
      items_.clear();
      bytes_ = 0;
    }
    changed_.notify_all();
  }

  // Nothing is left and nothing will come.
  [[nodiscard]] bool drained() const {
    const std::lock_guard lock(mutex_);
    return closed_ || (finished_ && items_.empty());
  }

  // finish() was called.
  [[nodiscard]] bool finished() const {
    const std::lock_guard lock(mutex_);
    return finished_;
  }

  // Somebody gave up, on whichever side.
  [[nodiscard]] bool closed() const {
    const std::lock_guard lock(mutex_);
    return closed_;
  }

  [[nodiscard]] Level level() const {
    const std::lock_guard lock(mutex_);
    return {items_.size(), bytes_};
  }

  [[nodiscard]] Limits limits() const { return limits_; }

 private:
  struct Item {
    T value;
    std::size_t bytes;
  };

  [[nodiscard]] bool fits(std::size_t bytes) const {
    return items_.empty() || (items_.size() < limits_.items && bytes_ + bytes <= limits_.bytes);
  }

  const Limits limits_;
  mutable std::mutex mutex_;  // protects all below
  std::condition_variable changed_;
  std::deque<Item> items_;
  std::size_t bytes_ = 0;
  bool finished_ = false;
  bool closed_ = false;
};

}  // namespace host
