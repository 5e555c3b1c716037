// Reads 3MF: core specification 1.x, components in other parts of the package (production
// extension), objects given as slices (slice extension). It reads build items, components,
// transforms and units; colours and materials are ignored. Roles that slicers give to meshes are
// used (threemf_roles.h): negative parts are cut out of their item (threemf_cut.h), modifiers are
// left out. Bodies and painted facets that mark where supports are to be come apart from the
// triangles (threemf_marks.h).
//
// An object with a full mesh and slices is read as its mesh. If the mesh is only a preview
// (meshresolution "lowres"), the object is read as its slices.
//
// Items that are marked as not printable, and objects of a type other than "model" or
// "solidsupport", are left out, with a warning. These are refused, because the part would be wrong:
// other required extensions; slices that are tilted, or used as a component; some items that are
// slices and some that are meshes.
#pragma once

#include "core/result.h"                // Result
#include "host/formats/part_content.h"  // PartContent
#include "host/formats/zip_archive.h"   // ZipArchive

namespace host {

// Model parts of one package.
inline constexpr int kThreeMfPartsMax = 1'024;

// COSTS: reads the whole package once, slices twice; see mesh_store.h for the memory.
[[nodiscard]] core::Result<PartContent> open_threemf(ZipArchive archive);

}  // namespace host
