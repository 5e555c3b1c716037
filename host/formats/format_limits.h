// What any reader of a file takes at most, so that no file can make the program grow: every bound
// of this folder in one place, with its reason.
#pragma once

#include <cstddef>
#include <cstdint>

namespace host {

// Corners in mm have to lie within this of 0: in the plane because coordinates do (limits.h), in
// height because half units are counted in 64 bits.
inline constexpr double kPlaneMaxMm = 53'687.0;
inline constexpr double kHeightMaxMm = 1e11;

// Layer files: contour points of one layer. Some 50 m of contour at a point each 50 µm; cleaning
// them takes about 200 MB.
inline constexpr std::size_t kLayerPointsMax = std::size_t{1} << 20;
// Contours of one layer.
inline constexpr std::size_t kLayerRingsMax = std::size_t{1} << 17;

// Heads of files up to the first layer; longer ones are no heads.
inline constexpr std::int64_t kHeadBytesMax = std::int64_t{1} << 20;
// One word or number of a text.
inline constexpr std::size_t kWordBytesMax = 256;
// What one header's entry or quoted name may take.
inline constexpr std::size_t kEntryBytesMax = 4'096;

// Forms within forms (SIF, L-SIF), elements within elements (XML).
inline constexpr int kNestingMax = 64;
// XML: one tag or text, which is held whole. A layer of an SVG may be a single path.
inline constexpr std::int64_t kXmlTokenBytesMax = std::int64_t{1} << 24;

// Warnings that one file can earn; the rest would be the same again.
inline constexpr std::size_t kFormatWarningsMax = 8;

}  // namespace host
