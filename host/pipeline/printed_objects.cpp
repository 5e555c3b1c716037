#include "host/pipeline/printed_objects.h"

#include <algorithm>
#include <utility>

#include "core/check.h"

namespace host {
namespace {

const CancelledObject* found(const std::vector<CancelledObject>& all, int object) {
  const auto place = std::find_if(all.begin(), all.end(), [object](const CancelledObject& one) {
    return one.object == object;
  });
  return place == all.end() ? nullptr : &*place;
}

}  // namespace

void PrintedObjects::set_names(std::vector<std::string> names) {
  const std::lock_guard lock(mutex_);
  names_ = std::move(names);
}

std::vector<std::string> PrintedObjects::names() const {
  const std::lock_guard lock(mutex_);
  return names_;
}

std::optional<core::LayerIndex> PrintedObjects::cancel(int object) {
  const std::lock_guard lock(mutex_);
  const bool known = object >= 0 && static_cast<std::size_t>(object) < names_.size();
  if (!known || cancelled_.size() == kCancelledObjectsMax || found(cancelled_, object) != nullptr) {
    return std::nullopt;
  }
  cancelled_.push_back({object, next_layer_});
  return next_layer_;
}

void PrintedObjects::restore(std::vector<CancelledObject> cancelled) {
  RIND_CHECK(cancelled.size() <= kCancelledObjectsMax);
  const std::lock_guard lock(mutex_);
  cancelled_ = std::move(cancelled);
}

void PrintedObjects::begin_layer(core::LayerIndex layer) {
  const std::lock_guard lock(mutex_);
  next_layer_ = layer + 1;
}

bool PrintedObjects::left_out(int object, core::LayerIndex layer) const {
  const std::lock_guard lock(mutex_);
  const CancelledObject* one = found(cancelled_, object);
  return one != nullptr && layer >= one->from;
}

bool PrintedObjects::is_cancelled(int object) const {
  const std::lock_guard lock(mutex_);
  return found(cancelled_, object) != nullptr;
}

std::vector<CancelledObject> PrintedObjects::cancelled() const {
  const std::lock_guard lock(mutex_);
  return cancelled_;
}

}  // namespace host
