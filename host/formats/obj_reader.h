// Wavefront OBJ: "v x y z" and "f a b c …", in mm, z up; everything else says nothing about shape.
//
// A face's corners are vertices counted from 1, or backwards from -1, and may stand behind it; what
// follows a slash (texture, normal) is not used. Faces of more than three corners are cut into a
// fan, which is right for concave ones too: triangles that turn the other way cancel. Faces of
// fewer are left out, and told. A backslash at a line's end joins the next one in lines of "v" and
// "f" only: other lines may end in one by chance.
#pragma once

#include <memory>

#include "core/result.h"                   // Result
#include "host/files/input_file.h"         // InputFile
#include "host/formats/triangle_source.h"  // TriangleSource

namespace host {

// COSTS: 16 bytes a vertex, 32 a triangle that stands before its vertices, in a temporary file when
// there are many (mapped_array.h).
[[nodiscard]] core::Result<std::unique_ptr<TriangleSource>> open_obj(InputFile file);

}  // namespace host
