// What slicers say about a 3MF's meshes beside the model: which parts are plastic, which are cut
// out, which are there to mark a place.
//
//     Metadata/model_settings.config      <object id><part id subtype="negative_part">
//                                         (Bambu Studio, OrcaSlicer: a part is a component)
//     Metadata/Slic3r_PE_model.config     <object id><volume firstid lastid>
//                                           <metadata key="volume_type" value="NegativeVolume"/>
//                                         (PrusaSlicer: a volume is some of the object's triangles;
//                                         before volume_type there was key="modifier" value="1")
//
// Vertices stand in the model where they belong, whatever matrix a volume has here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"               // Result
#include "host/formats/mesh_store.h"   // MeshRole
#include "host/formats/zip_archive.h"  // ZipArchive

namespace host {

// The first and the last of an object's triangles.
struct RoleRange {
  std::size_t first = 0;
  std::size_t last = 0;
  MeshRole role = MeshRole::kSolid;
};

struct ThreeMfRoles {
  // By the root's object. In order, none overlaps another.
  std::map<std::string, std::vector<RoleRange>> volumes;
  // By the root's object and the component's.
  std::map<std::pair<std::string, std::string>, MeshRole> parts;
  std::int64_t modifiers = 0;
  std::int64_t support_marks = 0;
  std::int64_t plates = 0;
  std::string unknown;  // the first type that is none of these

  // What of it is not used, a sentence each, to stand behind the file's name.
  [[nodiscard]] std::vector<std::string> left_out() const;
};

// Puts them in order; false where two overlap.
[[nodiscard]] bool in_order(std::vector<RoleRange>& ranges);

// Nothing where the package has no such entries.
[[nodiscard]] core::Result<ThreeMfRoles> read_roles(const ZipArchive& archive);

}  // namespace host
