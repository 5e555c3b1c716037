// Writes Common Layer Interface files (CLI 2.0).
//
//     walls    $$LABEL/1,"solid" the wall, $$LABEL/2,"loose" the inside
//     slices   $$LABEL/1,"part"
//     roads    a label for each kind of road, a hatch for each segment: for machines that hatch
//
//     $$POLYLINE/label,dir,points,x,y,…   closed; dir 1: outer, counter-clockwise; 0: inner
//     $$LAYER/                            the layer's top
//
// Text is in mm, exact to the grid. Binary is in units of 100 nm as 32-bit floats: exact within
// 1.6 m of the origin, rounded to seven digits beyond.
#pragma once

#include <memory>

#include "host/formats/layer_writer.h"  // LayerWriter, LayerFileHead

namespace host {

enum class CliKind { kText, kBinary, kRoads };

[[nodiscard]] std::unique_ptr<LayerWriter> cli_writer(CliKind kind, const LayerFileHead& head);

}  // namespace host
