// Wavefront OBJ: "v x y z" and "f a b c …", in mm, z up; everything else says nothing about shape.
//
// A face's corners are vertices that stand before it, counted from 1, or backwards from -1; what
// follows a slash (texture, normal) is not used. Faces of more than three corners are cut into a
// fan, which is right for concave ones too: triangles that turn the other way cancel.
#pragma once

#include <memory>

#include "core/result.h"                // Result
#include "host/part/input_file.h"       // InputFile
#include "host/part/triangle_source.h"  // TriangleSource

namespace host {

// COSTS: 16 bytes a vertex, in a temporary file when there are many (mapped_array.h).
[[nodiscard]] core::Result<std::unique_ptr<TriangleSource>> open_obj(InputFile file);

}  // namespace host
