// All bounds of the readers, each with its reason. They limit the memory that a file can take.
#pragma once

#include <cstddef>
#include <cstdint>

namespace host {

// Bounds of coordinates, ± in mm: in the plane by core's limits.h, in height because half units are
// counted in 64 bits.
inline constexpr double kPlaneMaxMm = 53'687.0;
inline constexpr double kHeightMaxMm = 1e11;

// Contour points of one layer of a layer file: 50 m of contour with a point each 50 µm. Cleaning
// them takes about 200 MB.
inline constexpr std::size_t kLayerPointsMax = std::size_t{1} << 20;
// Contours of one layer.
inline constexpr std::size_t kLayerRingsMax = std::size_t{1} << 17;

// The head of a file, up to its first layer; anything longer is no head.
inline constexpr std::int64_t kHeadBytesMax = std::int64_t{1} << 20;
// One word or number of a text.
inline constexpr std::size_t kWordBytesMax = 256;
// One entry of a head, or one quoted name.
inline constexpr std::size_t kEntryBytesMax = 4'096;

// Nesting of forms (SIF, L-SIF) and of elements (XML).
inline constexpr int kNestingMax = 64;
// One tag or text of XML, which is held whole. A layer of an SVG may be a single path.
inline constexpr std::int64_t kXmlTokenBytesMax = std::int64_t{1} << 24;

// Warnings for one file; further ones would repeat these.
inline constexpr std::size_t kFormatWarningsMax = 8;

}  // namespace host
