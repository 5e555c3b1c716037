// Writes L-SIF (lsif_reader.h), in mm, to the grid.
//
//     slices   (layer (v …) … (union (nested1d …) …))
//     walls    (layer (v …) … (difference S L) L): the wall as the paper has it, an unevaluated
//              boolean of the slice S and the loose inside L, and beside it the inside
//
// A layer that is not as high as the file's (thickness …) has its own.
#pragma once

#include <memory>

#include "host/formats/layer_writer.h"  // LayerWriter, LayerFileHead

namespace host {

[[nodiscard]] std::unique_ptr<LayerWriter> lsif_writer(const LayerFileHead& head);

}  // namespace host
