// 3MF, core specification 1.x, and components in other parts of the package (production
// extension): build items, components, transforms, units. Colours and materials are not used.
//
// Items that the build says are not printable, and objects whose type is not "model" or
// "solidsupport", are left out, and told. What would give another part is refused by name: required
// extensions other than those above, and objects whose mesh is only a stand-in for slices (slice
// extension, meshresolution "lowres").
#pragma once

#include <memory>

#include "core/result.h"               // Result
#include "host/formats/zip_archive.h"  // ZipArchive
#include "host/triangle_source.h"      // TriangleSource

namespace host {

// Model parts of one package.
inline constexpr int kThreeMfPartsMax = 1'024;

// COSTS: reads the whole package once; see mesh_store.h for what is held.
[[nodiscard]] core::Result<std::unique_ptr<TriangleSource>> open_threemf(ZipArchive archive);

}  // namespace host
