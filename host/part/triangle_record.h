// A compact encoding of a triangle, for the sorter's temporary file.
//
// The first corner is stored as its difference to the first corner of the triangle before, the
// other two as differences to the first corner: nine integers, each a zigzag varint (7 bits a byte,
// the lowest first, the sign in the lowest bit). A sorted facet of make_part's vase takes 15.7
// bytes, in memory 48.
#pragma once

#include <cstddef>
#include <string>

#include "core/geometry.h"  // Triangle, Vertex

namespace host {

// Differences of int32 fit 33 bits, those of heights 64.
inline constexpr std::size_t kTriangleRecordBytesMax = 6 * 5 + 3 * 10;

// Appends the record. `before`: first corner of the triangle before, {} for the first one.
void write_triangle(const core::Triangle& triangle, const core::Vertex& before, std::string& into);

// Reads one record and returns where it ends. REQUIRES: write_triangle() wrote it there.
[[nodiscard]] const char* read_triangle(const char* bytes, const core::Vertex& before,
                                        core::Triangle& triangle);

}  // namespace host
