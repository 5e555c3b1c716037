// Reads a layer file one layer at a time.
//
// Slices have the file's own coordinates and heights. They come from bottom to top, each on top of
// the one below. layer_file places them on the bed.
//
// ENSURES: holds the largest layer (format_limits.h) and fixed buffers, and reads ahead only as far
// as needed to see that a layer has ended. A file that is cut short or contradicts itself is an
// error that names the file, the position, the cause and what to do.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry.h"               // Box
#include "core/units.h"                  // LayerIndex, Length
#include "host/formats/format_limits.h"  // kFormatWarningsMax
#include "host/formats/layer_source.h"   // LayerSource

namespace host {

class LayerReader : public LayerSource {
 public:
  // "ASCII CLI", "SLC"
  [[nodiscard]] virtual std::string format() const = 0;

  // Extent and number of layers from the file's head, if given. They may be wrong, so they are used
  // only where that does no harm. Known once the reader is open.
  [[nodiscard]] const std::optional<core::Box>& box_promised() const { return box_promised_; }
  [[nodiscard]] core::LayerIndex layers_promised() const { return layers_promised_; }  // or 0

  // For people: what was odd and how it was treated. At most kFormatWarningsMax.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 protected:
  void warn(std::string text) {
    if (warnings_.size() < kFormatWarningsMax) warnings_.push_back(std::move(text));
  }

  std::optional<core::Box> box_promised_;
  core::LayerIndex layers_promised_ = 0;

 private:
  std::vector<std::string> warnings_;
};

}  // namespace host
