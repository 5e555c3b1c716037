// Reads the roles that slicers give to a 3MF's meshes, outside the model: plastic, cut out, marks
// for supports, or nothing that is used.
//
//     Metadata/model_settings.config      <object id><part id subtype="negative_part">
//                                         (Bambu Studio, OrcaSlicer: a part is a component)
//     Metadata/Slic3r_PE_model.config     <object id><volume firstid lastid>
//                                           <metadata key="volume_type" value="NegativeVolume"/>
//                                         (PrusaSlicer: a volume is some of the object's triangles;
//                                         before volume_type there was key="modifier" value="1")
//
// The model's vertices are final: a volume's matrix in these files is ignored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"                 // Result
#include "host/formats/mesh_store.h"     // MeshRole
#include "host/formats/modifier_body.h"  // ModifierSettings
#include "host/formats/zip_archive.h"    // ZipArchive

namespace host {

// A range of an object's triangles.
struct RoleRange {
  std::size_t first = 0;
  std::size_t last = 0;
  MeshRole role = MeshRole::kSolid;
};

// A body with settings of its own: a modifier, or all plastic of an object of the root model.
struct ThreeMfModifier {
  std::string name;  // for messages
  ModifierSettings settings;
  MeshRole role = MeshRole::kSolid;  // modifier_role(); kSolid: of `object`
  std::string object;
};

struct ThreeMfRoles {
  // By object of the root model. In ascending order, without overlaps.
  std::map<std::string, std::vector<RoleRange>> volumes;
  // By object of the root model and its component's object.
  std::map<std::pair<std::string, std::string>, MeshRole> parts;
  // Of objects of the root model that have one; kMeshObjectsMax at most.
  std::map<std::string, std::string> names;
  std::vector<ThreeMfModifier> changes;  // kModifiersMax at most
  // "volume 'Lid': fill_density": settings of one body of an object's plastic
  std::vector<std::string> unused;
  std::int64_t modifiers = 0;  // that change nothing: without settings, or too many
  std::int64_t enforcers = 0;
  std::int64_t blockers = 0;
  std::int64_t plates = 0;
  std::string unknown;  // the first type that is none of these

  // Warnings about ignored bodies, one sentence each, to follow the file's name.
  [[nodiscard]] std::vector<std::string> left_out() const;
};

// Sorts them; false if two overlap.
[[nodiscard]] bool in_order(std::vector<RoleRange>& ranges);

// Empty if the package has no such entries.
[[nodiscard]] core::Result<ThreeMfRoles> read_roles(const ZipArchive& archive);

}  // namespace host
