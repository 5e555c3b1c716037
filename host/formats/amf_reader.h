// AMF, the mesh part of it: objects, volumes, constellations with their instances, units.
//
// Where there are constellations, those that no other one holds are printed, else every object.
// Curved triangles are taken flat, and told; colours, materials and textures are not used.
#pragma once

#include <memory>
#include <string>

#include "core/result.h"                   // Result
#include "host/formats/triangle_source.h"  // TriangleSource
#include "host/formats/xml_scanner.h"      // XmlScanner

namespace host {

// `name` is the file, for messages. COSTS: reads all of it once; see mesh_store.h.
[[nodiscard]] core::Result<std::unique_ptr<TriangleSource>> open_amf(std::string name,
                                                                     XmlScanner::ByteSource bytes);

}  // namespace host
