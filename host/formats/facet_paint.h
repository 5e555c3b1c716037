// Painting on a facet, as PrusaSlicer, OrcaSlicer and Bambu Studio write it into a 3MF: a tree that
// splits the facet, in hexadecimal digits, the last one first.
//
//     a digit's lowest two bits    0: a leaf; 1, 2, 3: how many of the piece's edges are halved
//     the other two bits           of a leaf its mark: 0 none, 1 enforcer, 2 blocker; 3: three more
//                                  than the next digit says; of others the piece's corner that is
//                                  called a here, b and c come after it
//
// A split piece's children, in the reverse of the file's order; ab is the middle of a and b:
//
//     one       a b bc    bc c a
//     two       a ab ac   ab b ac   b c ac
//     three     a ab ca   ab b bc   bc c ca   ab bc ca
//
// SOURCE: TriangleSelector of PrusaSlicer (serialize, perform_split).
#pragma once

#include <functional>
#include <string_view>

#include "core/geometry.h"  // Triangle
#include "core/result.h"    // Status

namespace host {

enum class FacetPaint { kNone, kEnforcer, kBlocker, kUnknown };

// Pieces within one another. A facet of a metre is split into pieces of a micrometre with 40.
inline constexpr int kPaintDepthMax = 48;

// Whether the text is a whole tree of at most that depth, and nothing more.
[[nodiscard]] bool is_paint(std::string_view text);

// Calls `take` with the facet's pieces that are not kNone, corners to the nearest unit.
// Neighbouring facets have the same points on the edge between them.
// REQUIRES: is_paint(text). `corners`: in the file's order. Errors: of `take`.
// COSTS: O(length).
using PieceTaker = std::function<core::Status(const core::Triangle& piece, FacetPaint paint)>;
[[nodiscard]] core::Status each_painted_piece(std::string_view text, const core::Triangle& corners,
                                              const PieceTaker& take);

}  // namespace host
