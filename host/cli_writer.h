// Walls and insides as a Common Layer Interface file (ASCII CLI 2.0): what other programs judge the
// wall by.
//
//     $$LABEL/1,"solid"   the wall          $$POLYLINE/label,dir,points,x,y,…   closed
//     $$LABEL/2,"loose"   the inside        dir 1: outer, counter-clockwise; 0: inner
//                                           $$LAYER/ at the layer's top, in mm
#pragma once

#include <string>

#include "core/slice.h"  // SplitLayer
#include "core/units.h"  // LayerIndex

namespace host {

// Appends the begin of the file. `layers` 0: not known, and left out.
void write_cli_header(core::LayerIndex layers, std::string& into);

void write_cli_layer(const core::SplitLayer& layer, std::string& into);

void write_cli_end(std::string& into);

}  // namespace host
