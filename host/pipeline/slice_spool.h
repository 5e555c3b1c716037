// Slices in a temporary file, and out of it again (part/layer_spool.h).
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/regions/region.h"         // Region
#include "core/result.h"                 // Result
#include "core/slices/slice.h"           // Slice
#include "host/part/layer_spool.h"       // LayerSpool, SpooledLayer
#include "host/pipeline/slice_intake.h"  // TakenSlice

namespace host {

// The slice's region is `region`, and stays at the record's first place; marks are left out.
[[nodiscard]] SpooledLayer spooled(const core::Slice& slice,
                                   std::shared_ptr<const core::Region> region,
                                   std::optional<std::string> pause);

// The next one up; without a slice at the end. Errors: of the disk.
[[nodiscard]] core::Result<TakenSlice> next_slice(LayerSpool& spool);

}  // namespace host
