// Plug point: a source of slices, such as a mesh that is cut plane by plane, or a layer file.
#pragma once

#include <optional>

#include "core/result.h"        // Result
#include "core/slices/slice.h"  // Slice

namespace host {

class LayerSource {
 public:
  virtual ~LayerSource() = default;

  // The next slice up; nullopt at the part's end. Indices count from 0 without gaps.
  // An error is final.
  [[nodiscard]] virtual core::Result<std::optional<core::Slice>> next() = 0;
};

}  // namespace host
