// Reads the build items of a 3MF package that are given as slices, as one sequence of layers: each
// layer is the union of all items at that height.
//
// Errors: items with slices at different heights, which can't be one print; a gap between slices.
#pragma once

#include <memory>
#include <vector>

#include "core/result.h"                // Result
#include "host/formats/layer_reader.h"  // LayerReader
#include "host/formats/slice_stack.h"   // SlicedItem
#include "host/formats/zip_archive.h"   // ZipArchive

namespace host {

// Each item is unpacked by a stream of its own, of about 200 KB.
inline constexpr std::size_t kSlicedItemsMax = 64;

// REQUIRES: 1 … kSlicedItemsMax items
[[nodiscard]] core::Result<std::unique_ptr<LayerReader>> open_threemf_slices(
    ZipArchive archive, std::vector<SlicedItem> items);

}  // namespace host
