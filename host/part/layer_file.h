// A layer file set on the bed: it goes the same way as a mesh from here on.
//
//     LayerReader ──> shift ──> slices with heights of their own
//
// The lowest layer's lower face is the bed. Where the part lies in the plane (bed_placing.h) rests
// on its extent:
//
//     a file that can be read twice   is read through first, a layer at a time
//     a pipe whose head tells it      is believed (CLI's $$DIMENSION)
//     any other pipe                  its first layer with contours stands for it, and a warning
//                                     says so
//
// Empty layers on top of the last one with contours are left out (of a pipe, kEmptyLayersMax).
//
// Layers that come from a pipe are checked as they come: one that leaves the bed or the axis ends
// the print there.
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

// Empty layers that are waited through for the next one with contours.
inline constexpr std::size_t kEmptyLayersMax = core::kWindowLayersMax;

struct LayerFileInput {
  std::string name;  // stands in errors
  std::unique_ptr<LayerReader> layers;
  // Opens the same layers once more, from the begin; empty where they can be read only once, as
  // from a pipe.
  std::function<core::Result<std::unique_ptr<LayerReader>>()> again;
};

// Errors are open_part()'s (part_file.h), then or in read_rest(), which reads a file to its end,
// and checks the layers' heights (layer_rules.h).
[[nodiscard]] core::Result<OpenedPart> open_layer_file(LayerFileInput file,
                                                       const core::Settings& settings);

}  // namespace host
