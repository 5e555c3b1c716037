// Reads single elements of a 3MF model: units, corners, transforms.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/result.h"               // Result
#include "host/formats/mesh_store.h"   // Transform
#include "host/formats/vertex_snap.h"  // PointMm
#include "host/formats/xml_scanner.h"  // XmlEvent

namespace host {

// <model>: its unit in mm. An error if it requires an unknown extension.
[[nodiscard]] core::Result<double> unit_of(const XmlEvent& event, const XmlScanner& xml);

// <vertex>, in mm.
[[nodiscard]] core::Result<PointMm> point_of(const XmlEvent& event, const XmlScanner& xml,
                                             double unit_mm);

// <triangle>, of an object with `vertices` vertices.
[[nodiscard]] core::Result<std::array<std::uint32_t, 3>> corners_of(const XmlEvent& event,
                                                                    const XmlScanner& xml,
                                                                    std::size_t vertices);
// <triangle>: what a slicer has painted on it for supports (facet_paint.h); empty if nothing.
[[nodiscard]] std::string_view support_paint_of(const XmlEvent& event);
// <triangle>: true if a slicer has painted something else on it.
[[nodiscard]] bool has_other_paint(const XmlEvent& event);

// <item>, <component>: twelve numbers, with the translation in the model's unit. Without them, the
// identity.
[[nodiscard]] core::Result<Transform> transform_of(const XmlEvent& event, const XmlScanner& xml,
                                                   double unit_mm);

}  // namespace host
