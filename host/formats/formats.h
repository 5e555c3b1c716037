// The kinds of file, in one table: who reads them, who writes them. What they are told by stands in
// file_kind.h.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/result.h"                   // Result
#include "host/files/input_file.h"         // InputFile
#include "host/formats/file_kind.h"        // FileKind
#include "host/formats/layer_reader.h"     // LayerReader
#include "host/formats/layer_writer.h"     // LayerWriter, LayerFileHead
#include "host/formats/part_content.h"     // PartContent
#include "host/formats/triangle_source.h"  // TriangleSource

namespace host {

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

[[nodiscard]] bool is_layers(FileKind kind);
// A zip archive holds any of them: a 3MF package, or one part. REQUIRES: `file` not read but by
// kind_of()
[[nodiscard]] core::Result<PartContent> open_zip(InputFile file);
// REQUIRES: is_layers(kind), or a zip that holds layers; `file` not read but by kind_of().
[[nodiscard]] core::Result<std::unique_ptr<LayerReader>> open_layers(FileKind kind, InputFile file);
// REQUIRES: !is_layers(kind), likewise; of a SIF file or an archive, that it has no booleans.
[[nodiscard]] core::Result<std::unique_ptr<TriangleSource>> open_triangles(FileKind kind,
                                                                           InputFile file);

}  // namespace host
