// 3MF, core specification 1.x, components in other parts of the package (production extension),
// and objects given as slices (slice extension): build items, components, transforms, units.
// Colours and materials are not used. What slicers say of the meshes (threemf_roles.h) is: negative
// parts are cut out of their item (threemf_cut.h), modifiers and marks for supports are no plastic.
//
// An object that has both a full mesh and slices is read as its mesh; one whose mesh is only a
// stand-in (meshresolution "lowres"), as its slices.
//
// Items that the build says are not printable, and objects whose type is not "model" or
// "solidsupport", are left out, and told. What would give another part is refused by name: required
// extensions other than those above, slices that are tilted or a component, items of which some
// are slices and some are meshes.
#pragma once

#include "core/result.h"                // Result
#include "host/formats/part_content.h"  // PartContent
#include "host/formats/zip_archive.h"   // ZipArchive

namespace host {

// Model parts of one package.
inline constexpr int kThreeMfPartsMax = 1'024;

// COSTS: reads the whole package once, slices once more; see mesh_store.h for what is held.
[[nodiscard]] core::Result<PartContent> open_threemf(ZipArchive archive);

}  // namespace host
