// Reads the meshes of an AMF file: objects, volumes, constellations with their instances, units.
//
// If there are constellations, those that are part of no other one are printed; otherwise every
// object. Curved triangles are read as flat ones, with a warning. Colours, materials and textures
// are ignored.
#pragma once

#include <memory>
#include <string>

#include "core/result.h"                   // Result
#include "host/formats/triangle_source.h"  // TriangleSource
#include "host/formats/xml_scanner.h"      // XmlScanner

namespace host {

// `name` is the file, for messages. COSTS: reads it once; see mesh_store.h for the memory.
[[nodiscard]] core::Result<std::unique_ptr<TriangleSource>> open_amf(std::string name,
                                                                     XmlScanner::ByteSource bytes);

}  // namespace host
