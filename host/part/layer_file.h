// Opens a layer file as a part and places it on the bed. From here on it is treated like a mesh.
//
//     LayerReader ──> shift ──> slices with heights of their own
//
// The lowest layer's lower face lies on the bed. The position in the plane (bed_placing.h) follows
// from the part's extent, which is taken from
//
//     a file that can be read twice       all its layers, read one at a time beforehand
//     a pipe whose head gives an extent   the head (CLI's $$DIMENSION)
//     any other pipe                      its first layer with contours, with a warning
//
// Empty layers above the last one with contours are left out (of a pipe, kEmptyLayersMax).
//
// Layers from a pipe are checked as they arrive: one outside the bed or the axis ends the print.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "core/limits.h"                // kWindowLayersMax
#include "core/result.h"                // Result
#include "core/settings.h"              // Settings
#include "host/formats/layer_reader.h"  // LayerReader
#include "host/part/opened_part.h"      // OpenedPart

namespace host {

// Empty layers that are held back until one with contours follows.
inline constexpr std::size_t kEmptyLayersMax = core::kWindowLayersMax;

struct LayerFileInput {
  std::string name;  // for messages
  std::unique_ptr<LayerReader> layers;
  // Opens the same layers again, from the start; empty if they can be read only once (a pipe).
  std::function<core::Result<std::unique_ptr<LayerReader>>()> again;
};

// Errors are those of open_part() (part_file.h), here or in read_rest(), which reads a file to its
// end and checks the layers' heights (layer_rules.h).
[[nodiscard]] core::Result<OpenedPart> open_layer_file(LayerFileInput file,
                                                       const core::Settings& settings);

}  // namespace host
