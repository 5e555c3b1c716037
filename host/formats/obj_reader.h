// Reads Wavefront OBJ: "v x y z" and "f a b c …", in mm, z up. Other lines don't describe shape and
// are ignored.
//
// A face's corners are vertices counted from 1, or backwards from -1; the vertices may follow later
// in the file. What follows a slash (texture, normal) is ignored. A face with more than three
// corners is cut into a fan, which is correct for concave faces too: triangles that turn the other
// way cancel. Faces with fewer corners are left out, with a warning. A backslash at a line's end
// joins the next line only for "v" and "f": other lines may end in one by chance.
#pragma once

#include <memory>

#include "core/result.h"                   // Result
#include "host/files/input_file.h"         // InputFile
#include "host/formats/triangle_source.h"  // TriangleSource

namespace host {

// COSTS: 16 bytes a vertex, 32 a triangle that comes before its vertices; many of them are kept in
// a temporary file (mapped_array.h).
[[nodiscard]] core::Result<std::unique_ptr<TriangleSource>> open_obj(InputFile file);

}  // namespace host
