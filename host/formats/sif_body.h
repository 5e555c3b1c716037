// Reads the body of a SIF 1.0 file: named vertices, triangles over them, surfaces that are defined
// once and placed several times (sif_reader.h).
#pragma once

#include "core/result.h"               // Status
#include "host/formats/mesh_store.h"   // MeshStore
#include "host/formats/sif_scanner.h"  // SifScanner

namespace host {

// Reads from behind "(body" to its closing parenthesis. The body becomes object `key` of the store.
[[nodiscard]] core::Status read_sif_body(SifScanner& scanner, double unit_mm,
                                         const MeshStore::Key& key, MeshStore& store);

}  // namespace host
