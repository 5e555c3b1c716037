// 3MF, core specification 1.x, components in other parts of the package (production extension),
// and objects given as slices (slice extension): build items, components, transforms, units.
// Colours and materials are not used.
//
// An object that has both a full mesh and slices is read as its mesh; one whose mesh is only a
// stand-in (meshresolution "lowres"), as its slices.
//
// Items that the build says are not printable, and objects whose type is not "model" or
// "solidsupport", are left out, and told. What would give another part is refused by name: required
// extensions other than those above, slices that are tilted or a component, items of which some
// are slices and some are meshes.
#pragma once

#include <memory>
#include <variant>

#include "core/result.h"                // Result
#include "host/formats/layer_reader.h"  // LayerReader
#include "host/formats/zip_archive.h"   // ZipArchive
#include "host/part/triangle_source.h"  // TriangleSource

namespace host {

// Model parts of one package.
inline constexpr int kThreeMfPartsMax = 1'024;

using MeshOrLayers = std::variant<std::unique_ptr<TriangleSource>, std::unique_ptr<LayerReader>>;

// COSTS: reads the whole package once, slices once more; see mesh_store.h for what is held.
[[nodiscard]] core::Result<MeshOrLayers> open_threemf(ZipArchive archive);

}  // namespace host
