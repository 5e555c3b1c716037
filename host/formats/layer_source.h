// Plug point: where slices come from. A mesh that is cut plane by plane, a layer file, a pipe.
#pragma once

#include <optional>

#include "core/result.h"        // Result
#include "core/slices/slice.h"  // Slice

namespace host {

class LayerSource {
 public:
  virtual ~LayerSource() = default;

  // The next slice up, or nothing when the part has ended. Indices count from 0 without gaps.
  // An error is final.
  [[nodiscard]] virtual core::Result<std::optional<core::Slice>> next() = 0;
};

}  // namespace host
