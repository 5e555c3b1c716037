// A file that already is layers, read one layer at a time.
//
// Slices come as the file has them: its own coordinates and heights, bottom to top, each standing
// on the one below. Setting them on the bed is layer_file's business.
//
// ENSURES: memory for the largest layer (format_limits.h) and fixed buffers; nothing is read ahead
// but what tells that a layer has ended. Files that end early, or say what can't be, are errors
// that name the file, the place, the cause and what to do.
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

  // What the file's head says about the whole, if it does; believed only as far as that is
  // harmless. Known once the reader has been opened.
  [[nodiscard]] const std::optional<core::Box>& box_promised() const { return box_promised_; }
  [[nodiscard]] core::LayerIndex layers_promised() const { return layers_promised_; }  // 0: unsaid

  // For people: what was odd and how it was taken. At most kFormatWarningsMax.
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
