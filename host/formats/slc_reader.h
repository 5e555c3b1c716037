// Reads SLC 2.0 (3D Systems): binary layers, little-endian. U is a uint32, F an IEEE float32.
//
//     head       text "-SLCVER 2.0 -UNIT MM … -EXTENTS x0,x1 y0,y1 z0,z1 ", then 0D 0A 1A
//     reserved   256 bytes, after 1A or, if the writer pads, after 2048 bytes
//     table      uint8 count, count · { F lowest z, F layer thickness, F, F }
//     layers     { F z of the lower face, U boundaries, boundaries · { U points, U gaps,
//                points · (F x, F y) } }
//     end        F z of the last layer's upper face, U FFFFFFFF
//
// A point is inside if its winding number is odd. By the format, outer boundaries are
// counter-clockwise, but a file with the opposite orientation throughout is read correctly, too.
#pragma once

#include <memory>

#include "core/result.h"                // Result
#include "host/files/input_file.h"      // InputFile
#include "host/formats/layer_reader.h"  // LayerReader

namespace host {

// COSTS: reads the head and the table.
[[nodiscard]] core::Result<std::unique_ptr<LayerReader>> open_slc(InputFile file);

}  // namespace host
