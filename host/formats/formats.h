// The kinds of file, in one table: what they are told by, who reads them, who writes them.
//
// A kind is told by the content, never by the name: .slc is the name of three formats at least,
// .ssl and .sif of two.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/result.h"                  // Result
#include "host/formats/layer_reader.h"    // LayerReader
#include "host/formats/layer_writer.h"    // LayerWriter, LayerFileHead
#include "host/formats/threemf_reader.h"  // MeshOrLayers
#include "host/part/input_file.h"         // InputFile
#include "host/part/triangle_source.h"    // TriangleSource

namespace host {

enum class FileKind { kStl, kZip, kAmf, kObj, kSif, kLsif, kCli, kSlc, kSliceV0, kSvg };

struct FormatRow {
  const char* name;
  const char* extensions;
  const char* holds;  // "mesh", "layers", "roads"
  bool reads;
  bool writes;
  const char* remarks;
};

// For people: `rind formats`.
[[nodiscard]] std::span<const FormatRow> formats();

// Reads as much as tells the kind. Errors: an empty file, and kinds that are known and can't be
// read, by name.
[[nodiscard]] core::Result<FileKind> kind_of(InputFile& file);

[[nodiscard]] bool is_layers(FileKind kind);
// A zip archive holds either. REQUIRES: `file` not read but by kind_of()
[[nodiscard]] core::Result<MeshOrLayers> open_zip(InputFile file);
// REQUIRES: is_layers(kind), or a zip that holds layers; `file` not read but by kind_of().
[[nodiscard]] core::Result<std::unique_ptr<LayerReader>> open_layers(FileKind kind, InputFile file);
// REQUIRES: !is_layers(kind), likewise; of a SIF file, that it has no booleans (sif_reader.h).
[[nodiscard]] core::Result<std::unique_ptr<TriangleSource>> open_triangles(FileKind kind,
                                                                           InputFile file);

}  // namespace host
