// The body of a SIF 1.0 file: named vertices, triangles over them, surfaces that are defined once
// and placed often (sif_reader.h).
#pragma once

#include "core/result.h"               // Status
#include "host/formats/mesh_store.h"   // MeshStore
#include "host/formats/sif_scanner.h"  // SifScanner

namespace host {

// Behind "(body", to its closing parenthesis. Everything comes to be object `key` of the store.
[[nodiscard]] core::Status read_sif_body(SifScanner& scanner, double unit_mm,
                                         const MeshStore::Key& key, MeshStore& store);

}  // namespace host
