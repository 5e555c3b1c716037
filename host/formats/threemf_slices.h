// Build items of a 3MF package that are given as slices, as one row of layers: at each height, what
// all items together have there.
//
// Items that are cut at other heights than the rest can't be one print and are refused, and so is a
// space without any slice between two.
#pragma once

#include <memory>
#include <vector>

#include "core/result.h"                // Result
#include "host/formats/layer_reader.h"  // LayerReader
#include "host/formats/slice_stack.h"   // SlicedItem
#include "host/formats/zip_archive.h"   // ZipArchive

namespace host {

// Each is unpacked by a stream of its own, of some 200 KB.
inline constexpr std::size_t kSlicedItemsMax = 64;

// REQUIRES: 1 … kSlicedItemsMax items
[[nodiscard]] core::Result<std::unique_ptr<LayerReader>> open_threemf_slices(
    ZipArchive archive, std::vector<SlicedItem> items);

}  // namespace host
