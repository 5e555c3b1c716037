// Writes L-SIF (lsif_reader.h), in mm, to the grid.
//
//     slices   (layer (v …) … (union (nested1d …) …))
//     walls    (layer (v …) … (difference S L) L): the wall as in the paper, an unevaluated boolean
//              of the slice S and the loose inside L, followed by the inside
//
// A layer has its own (thickness …) if its height differs from the file's.
#pragma once

#include <memory>

#include "host/formats/layer_writer.h"  // LayerWriter, LayerFileHead

namespace host {

[[nodiscard]] std::unique_ptr<LayerWriter> lsif_writer(const LayerFileHead& head);

}  // namespace host
