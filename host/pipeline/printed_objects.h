// Several objects while they are printed: their names, and which of them a person does not want any
// more.
//
// Geometry leaves an object out from the first layer on that it has not begun. Commands that are
// queued by then are dropped by the link (printing/skipped_command.h). So what geometry gives
// depends only on the list here, which a journal keeps.
#pragma once

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/units.h"  // LayerIndex

namespace host {

// What a journal's record has room for.
inline constexpr std::size_t kCancelledObjectsMax = 48;

struct CancelledObject {
  int object = 0;
  core::LayerIndex from = 0;  // the first layer of the print without it
};

// For any thread. Objects are counted from 0, as in PartSummary::objects.
class PrintedObjects {
 public:
  void set_names(std::vector<std::string> names);
  // Empty: there are not several, or they are not known yet.
  [[nodiscard]] std::vector<std::string> names() const;

  // Returns the first layer without it; nothing: there is no such object, it is cancelled already,
  // or kCancelledObjectsMax are.
  std::optional<core::LayerIndex> cancel(int object);
  // As a journal has them. REQUIRES: at most kCancelledObjectsMax.
  void restore(std::vector<CancelledObject> cancelled);

  // Geometry begins this layer of the print; they come in order.
  void begin_layer(core::LayerIndex layer);
  // Whether the layer is laid without it.
  [[nodiscard]] bool left_out(int object, core::LayerIndex layer) const;

  [[nodiscard]] bool is_cancelled(int object) const;
  [[nodiscard]] std::vector<CancelledObject> cancelled() const;

 private:
  mutable std::mutex mutex_;  // protects what follows
  std::vector<std::string> names_;
  std::vector<CancelledObject> cancelled_;
  core::LayerIndex next_layer_ = 0;  // the first one that geometry has not begun
};

}  // namespace host
