// Every bound of the program's core in one place, with its reason.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace core {

// Coordinates in the plane stay within ± this many units (53 m). Boost.Polygon 1.74 gives wrong
// results from 2^30 on, and cross products of such coordinates fit an int64.
inline constexpr std::int32_t kCoordinateMax = 1 << 29;

// Largest T, the wall's thickness in layers on either side of the one that is decided.
inline constexpr int kWallLayersMax = 64;

// Layers the window holds at most: 2T + 1.
inline constexpr int kWindowLayersMax = 2 * kWallLayersMax + 1;

// Intersections that any layer costs at most: ⌈log2(2T + 1)⌉.
inline constexpr int kFoldCostMax =
    static_cast<int>(std::bit_width(unsigned{kWindowLayersMax - 1}));

static_assert(kFoldCostMax < kWallLayersMax, "folding must beat intersecting the window");

// Ranges of height that the user may give a layer height of their own.
inline constexpr std::size_t kHeightRangesMax = 256;

// Bins of height in which the surface's slopes are gathered (height_limits.h), a power of two:
// 32 KiB, 0.05 mm each in a part of up to 0.8 m.
inline constexpr std::size_t kHeightBinsMax = 16'384;

// Bins of height in which flat faces are found (flat_faces.h), a power of two: 64 KiB, 0.05 mm each
// in a part of up to 0.2 m.
inline constexpr std::size_t kFlatBinsMax = 4'096;

// Runs of layers of one height that a part has (layer_heights.h): 192 KiB. So many are needed if
// every layer of 0.1 mm in a part of 0.8 m has another height than the one below.
inline constexpr std::size_t kHeightBandsMax = 8'192;

// Each range has a band, and up to four are below it: layers as elsewhere, and those that fit
// what is left.
static_assert(std::has_single_bit(kHeightBinsMax) && std::has_single_bit(kFlatBinsMax));
static_assert(5 * kHeightRangesMax < kHeightBandsMax);

// Objects on the bed: parts and their copies.
inline constexpr int kObjectsMax = 256;

// Corners of the bed's outline. The round beds of PrusaSlicer's printers have 60 and 72.
inline constexpr std::size_t kBedCornersMax = 1'000;

// How often a contour is turned when Boost's Voronoi diagram of it fails its checks, before the
// offset is made the slow way. One turn nearly always does.
inline constexpr int kDiagramTurnsMax = 4;

// How far that slow way's chords stay from the true arcs.
inline constexpr double kCapsuleToleranceUnits = 5;

// Region operations that a layer of a ball-shaped wall costs at most: 2T intersections of its
// window's offsets.
inline constexpr int kBallOperationsMax = kWindowLayersMax - 1;

// Depths that a polygon offset tries when the one asked for is critical (polygon_offset.h), before
// it asks the whole diagram.
inline constexpr int kDepthTriesMax = 12;

// Seams that are remembered from layer to layer (seams.h). They fit, with all else that a journal's
// record holds, into one block of a disk, 4,096 bytes.
inline constexpr std::size_t kSeamsMax = 256;

// Corners of a closed road that are looked at as a place for its seam.
inline constexpr std::size_t kSeamCornersMax = 32;

// Layers above a layer whose corners count.
inline constexpr int kSeamLayersAheadMax = 8;

// Islands of a slice that are followed to see whether the part stands (standing.h): 64 KiB of
// columns' stretches beside the slice itself.
inline constexpr std::size_t kStandingIslandsMax = 256;

// Layers for which a seam is remembered when no road passes there, 10 mm of a usual print.
inline constexpr int kSeamLayersKept = 50;

}  // namespace core
