// What single elements of a 3MF model say: units, corners, transforms.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/result.h"               // Result
#include "host/formats/mesh_store.h"   // Transform
#include "host/formats/vertex_snap.h"  // PointMm
#include "host/formats/xml_scanner.h"  // XmlEvent

namespace host {

// <model>: its unit in mm. An error too where it requires an extension that is not known.
[[nodiscard]] core::Result<double> unit_of(const XmlEvent& event, const XmlScanner& xml);

// <vertex>, in mm.
[[nodiscard]] core::Result<PointMm> point_of(const XmlEvent& event, const XmlScanner& xml,
                                             double unit_mm);

// <triangle>, of an object with so many vertices.
[[nodiscard]] core::Result<std::array<std::uint32_t, 3>> corners_of(const XmlEvent& event,
                                                                    const XmlScanner& xml,
                                                                    std::size_t vertices);
// <triangle>: slicers have painted something on it.
[[nodiscard]] bool is_painted(const XmlEvent& event);

// <item>, <component>: twelve numbers, of which the translation is in the model's unit; none is no
// transform.
[[nodiscard]] core::Result<Transform> transform_of(const XmlEvent& event, const XmlScanner& xml,
                                                   double unit_mm);

}  // namespace host
